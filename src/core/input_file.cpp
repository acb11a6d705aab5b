#include "input_file.hpp"

#include <fstream>
#include <istream>

#include "skylut/core/domain.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {

std::string read_input_file(const std::filesystem::path& path, const char* expected) {
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path))
    throw InputError("{}: cannot be read; expected {}", path.string(), expected);
  constexpr std::size_t kPart = 1 << 16;
  std::string text;
  while (file) {
    const std::size_t size = text.size();
    if (size > domain::kLargestInput_bytes)
      throw InputError("{}: holds more than {} MB; expected {}", path.string(),
                       domain::kLargestInput_bytes / 1'000'000, expected);
    text.resize(size + kPart);
    file.read(text.data() + size, kPart);
    text.resize(size + static_cast<std::size_t>(file.gcount()));
  }
  if (file.bad()) throw InputError("{}: cannot be read; expected {}", path.string(), expected);
  return text;
}

bool read_input_line(std::istream& file, std::string& line, const std::filesystem::path& path,
                     std::size_t number) {
  line.clear();
  std::streambuf& buffer = *file.rdbuf();
  for (;;) {
    const int next = buffer.sbumpc();
    if (next == std::char_traits<char>::eof()) {
      file.setstate(line.empty() ? std::ios::eofbit | std::ios::failbit : std::ios::eofbit);
      return !line.empty();
    }
    if (next == '\n') return true;
    if (line.size() == domain::kLongestLine_bytes)
      throw InputError("{}:{}: longer than {} bytes: must be a line of comma-separated values", path.string(),
                       number, domain::kLongestLine_bytes);
    line += static_cast<char>(next);
  }
}

}  // namespace skylut
