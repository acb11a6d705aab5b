#include "packed_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

namespace skylut::compact {

namespace {

constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

std::string base64(std::span<const std::uint8_t> bytes) {
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k) three = three << 8 | (k < left ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += k <= left ? kAlphabet[three >> (18 - 6 * k) & 63U] : '=';
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

/// A stream of numbers of some bits each, the lowest bits of the first byte first.
class BitWriter {
 public:
  void add(std::uint32_t value, unsigned bits) {
    held_ |= static_cast<std::uint64_t>(value & mask(bits)) << count_;
    for (count_ += bits; count_ >= 8; count_ -= 8, held_ >>= 8)
      bytes_.push_back(static_cast<std::uint8_t>(held_ & 255U));
  }
  std::vector<std::uint8_t> finish() {
    if (count_ > 0) bytes_.push_back(static_cast<std::uint8_t>(held_ & 255U));
    return std::move(bytes_);
  }
  static std::uint32_t mask(unsigned bits) { return bits == 32 ? ~0U : (1U << bits) - 1U; }

 private:
  std::vector<std::uint8_t> bytes_;
  std::uint64_t held_ = 0;
  unsigned count_ = 0;
};

class BitReader {
 public:
  explicit BitReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  std::uint32_t next(unsigned bits) {
    for (; count_ < bits; count_ += 8) held_ |= static_cast<std::uint64_t>(bytes_[at_++]) << count_;
    const auto value = static_cast<std::uint32_t>(held_) & BitWriter::mask(bits);
    held_ >>= bits;
    count_ -= bits;
    return value;
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
  std::uint64_t held_ = 0;
  unsigned count_ = 0;
};

constexpr unsigned kSingle = 32;  // bits of a float
constexpr unsigned kMostBits = 24;

}  // namespace

nlohmann::ordered_json pack_numbers(std::span<const float> values, double step) {
  double most = 0.0;
  for (const float value : values) most = std::max(most, std::abs(static_cast<double>(value)));
  unsigned bits = kSingle;
  if (step > 0.0 && most / step < static_cast<double>(1U << (kMostBits - 1)) - 1.0)
    bits = static_cast<unsigned>(std::bit_width(static_cast<std::uint32_t>(std::lround(most / step)))) + 1;
  BitWriter writer;
  for (const float value : values)
    writer.add(bits == kSingle ? std::bit_cast<std::uint32_t>(value)
                               : static_cast<std::uint32_t>(std::lround(static_cast<double>(value) / step)),
               bits);
  nlohmann::ordered_json json;
  json["bits"] = bits;
  if (bits != kSingle) json["step"] = step;
  json["base64"] = base64(writer.finish());
  return json;
}

std::vector<float> unpack_numbers(const JsonReader& packed, std::size_t count) {
  const double stated = packed.at("bits").number({1.0, kSingle, "bits"});
  const auto bits = static_cast<unsigned>(stated);
  if (stated != bits || (bits > kMostBits && bits != kSingle))
    packed.at("bits").refuse("must be a whole number, at most 24, or 32");
  const std::vector<std::uint8_t> bytes = bytes_of(packed.at("base64"), packed.at("base64").text());
  const std::size_t needed = (count * bits + 7) / 8;
  if (bytes.size() != needed)
    packed.at("base64").refuse(fmt::format("holds {} bytes: must hold {}", bytes.size(), needed));
  const double step = bits == kSingle ? 0.0 : packed.at("step").number();
  BitReader reader(bytes);
  std::vector<float> values;
  values.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t raw = reader.next(bits);
    if (bits == kSingle) {
      values.push_back(std::bit_cast<float>(raw));
      if (!std::isfinite(values.back())) packed.at("base64").refuse("holds what is not a number");
    } else {
      // The highest bit is the sign.
      const auto whole = static_cast<std::int32_t>(raw << (32 - bits)) >> (32 - bits);
      values.push_back(static_cast<float>(step * whole));
    }
  }
  return values;
}

}  // namespace skylut::compact
