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

using nlohmann::ordered_json;

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
  std::size_t left() const { return count_ + 8 * (bytes_.size() - at_); }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
  std::uint64_t held_ = 0;
  unsigned count_ = 0;
};

constexpr unsigned kSingle = 32;    // bits of a float
constexpr unsigned kWidthBits = 5;  // that say how many bits the numbers of a block have
constexpr unsigned kMostBits = 24;  // of a number
constexpr std::size_t kBlock = 16;  // numbers

/// The bits of a whole number and its sign; 0 for 0.
unsigned width_of(std::int32_t whole) {
  return whole == 0 ? 0U
                    : static_cast<unsigned>(std::bit_width(static_cast<std::uint32_t>(std::abs(whole)))) + 1;
}

ordered_json pack_singles(std::span<const float> values) {
  BitWriter writer;
  for (const float value : values) writer.add(std::bit_cast<std::uint32_t>(value), kSingle);
  return {{"count", values.size()}, {"base64", base64(writer.finish())}};
}

std::vector<float> unpack_singles(const JsonReader& place, std::span<const std::uint8_t> bytes,
                                  std::size_t count) {
  if (bytes.size() != 4 * count)
    place.refuse(fmt::format("holds {} bytes: must hold {}", bytes.size(), 4 * count));
  BitReader reader(bytes);
  std::vector<float> values;
  for (std::size_t i = 0; i < count; ++i) {
    values.push_back(std::bit_cast<float>(reader.next(kSingle)));
    if (!std::isfinite(values.back())) place.refuse("holds what is not a number");
  }
  return values;
}

}  // namespace

ordered_json pack_numbers(std::span<const float> values, double step) {
  double most = 0.0;
  for (const float value : values) most = std::max(most, std::abs(static_cast<double>(value)));
  if (!(step > 0.0) || !(most / step < static_cast<double>(1U << (kMostBits - 1)) - 1.0))
    return pack_singles(values);
  std::vector<std::int32_t> whole;
  for (const float value : values)
    whole.push_back(static_cast<std::int32_t>(std::lround(static_cast<double>(value) / step)));
  BitWriter writer;
  for (std::size_t first = 0; first < whole.size(); first += kBlock) {
    const std::span<const std::int32_t> block =
        std::span(whole).subspan(first, std::min(kBlock, whole.size() - first));
    unsigned width = 0;
    for (const std::int32_t number : block) width = std::max(width, width_of(number));
    writer.add(width, kWidthBits);
    for (const std::int32_t number : block)
      if (width > 0) writer.add(static_cast<std::uint32_t>(number), width);
  }
  return {{"count", values.size()}, {"step", step}, {"base64", base64(writer.finish())}};
}

std::vector<float> unpack_numbers(const JsonReader& packed, std::size_t count) {
  if (packed.at("count").number() != static_cast<double>(count))
    packed.at("count").refuse(fmt::format("must be {}", count));
  const JsonReader place = packed.at("base64");
  const std::vector<std::uint8_t> bytes = bytes_of(place, place.text());
  if (!packed.has("step")) return unpack_singles(place, bytes, count);
  const double step = packed.at("step").number();
  BitReader reader(bytes);
  std::vector<float> values;
  values.reserve(count);
  for (std::size_t first = 0; first < count; first += kBlock) {
    const std::size_t in_block = std::min(kBlock, count - first);
    if (reader.left() < kWidthBits)
      place.refuse(fmt::format("ends after {} numbers: must hold {}", first, count));
    const unsigned width = reader.next(kWidthBits);
    if (width > kMostBits || reader.left() < width * in_block)
      place.refuse(fmt::format("ends after {} numbers: must hold {}", first, count));
    for (std::size_t i = 0; i < in_block; ++i) {
      // The highest bit is the sign.
      const std::uint32_t raw = width == 0 ? 0U : reader.next(width) << (32 - width);
      const std::int32_t whole = width == 0 ? 0 : static_cast<std::int32_t>(raw) >> (32 - width);
      values.push_back(static_cast<float>(step * whole));
    }
  }
  if (reader.left() >= 8) place.refuse(fmt::format("goes on: must hold {} numbers", count));
  return values;
}

}  // namespace skylut::compact
