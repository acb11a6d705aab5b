#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "skylut/core/json_reader.hpp"

namespace skylut::compact {

/// Numbers in a JSON file at a few bits each: base64 (RFC 4648) of a stream of bits, the lowest first. With a
/// step, blocks of 16 whole numbers of it, each block's width in bits before them in 5 bits, the numbers in
/// two's complement; without, numbers of single precision.
/// @param step  > 0; what the numbers are rounded to; 0: single precision
nlohmann::ordered_json pack_numbers(std::span<const float> values, double step);

/// @param count  that there must be
/// @throws InputError  naming the place
std::vector<float> unpack_numbers(const JsonReader& packed, std::size_t count);

}  // namespace skylut::compact
