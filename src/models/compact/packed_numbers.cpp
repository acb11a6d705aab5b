#include "packed_numbers.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace skylut::compact {

namespace {

constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

std::string base64(std::span<const std::uint8_t> bytes) {
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k) three = three << 8 | (k < left ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += k <= left ? kAlphabet[three >> (18 - 6 * k) & 63U] : '=';
  }
  return text;
}

std::vector<std::uint8_t> bytes_of(const JsonReader& place, const std::string& text) {
  static constexpr auto kValues = [] {
    std::array<int, 256> values{};
    values.fill(-1);
    for (std::size_t i = 0; i < kAlphabet.size(); ++i)
      values[static_cast<unsigned char>(kAlphabet[i])] = static_cast<int>(i);
    return values;
  }();
  std::vector<std::uint8_t> bytes;
  std::uint32_t bits = 0;
  int held = 0;
  for (const char letter : text) {
    if (letter == '=') break;
    const int value = kValues[static_cast<unsigned char>(letter)];
    if (value < 0) place.refuse("must be base64");
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes.push_back(static_cast<std::uint8_t>(bits >> held & 255U));
  }
  return bytes;
}

void append(std::vector<std::uint8_t>& bytes, std::uint32_t value, std::size_t width) {
  for (std::size_t k = 0; k < width; ++k) bytes.push_back(static_cast<std::uint8_t>(value >> (8 * k) & 255U));
}

std::uint32_t word(const std::vector<std::uint8_t>& bytes, std::size_t first, std::size_t width) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < width; ++k) value |= static_cast<std::uint32_t>(bytes[first + k]) << (8 * k);
  return value;
}

}  // namespace

nlohmann::ordered_json pack_numbers(std::span<const float> values, double step) {
  double most = 0.0;
  for (const float value : values) most = std::max(most, std::abs(static_cast<double>(value)));
  const double steps = step > 0.0 ? most / step : 1e9;
  const std::size_t width = steps <= 127.0 ? 1 : steps <= 32767.0 ? 2 : 4;
  std::vector<std::uint8_t> bytes;
  bytes.reserve(values.size() * width);
  for (const float value : values)
    append(bytes,
           width == 4 ? std::bit_cast<std::uint32_t>(value)
                      : static_cast<std::uint32_t>(std::lround(static_cast<double>(value) / step)),
           width);
  nlohmann::ordered_json json;
  json["bytes"] = width;
  if (width < 4) json["step"] = step;
  json["base64"] = base64(bytes);
  return json;
}

std::vector<float> unpack_numbers(const JsonReader& packed, std::size_t count) {
  const double bytes_each = packed.at("bytes").number();
  if (bytes_each != 1.0 && bytes_each != 2.0 && bytes_each != 4.0) packed.at("bytes").refuse("must be 1, 2 or 4");
  const auto width = static_cast<std::size_t>(bytes_each);
  const std::vector<std::uint8_t> bytes = bytes_of(packed.at("base64"), packed.at("base64").text());
  if (bytes.size() != count * width)
    packed.at("base64").refuse("holds " + std::to_string(bytes.size()) + " bytes: must hold " +
                               std::to_string(count * width));
  const double step = width < 4 ? packed.at("step").number() : 0.0;
  std::vector<float> values;
  values.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t raw = word(bytes, i * width, width);
    if (width == 4) {
      values.push_back(std::bit_cast<float>(raw));
      if (!std::isfinite(values.back())) packed.at("base64").refuse("holds what is not a number");
    } else {
      const int whole = width == 1 ? static_cast<std::int8_t>(raw) : static_cast<std::int16_t>(raw);
      values.push_back(static_cast<float>(step * whole));
    }
  }
  return values;
}

}  // namespace skylut::compact
