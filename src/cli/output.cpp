#include "output.hpp"

#include <cstdio>

#include "skylut/core/atomic_file.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/writable.hpp"

namespace skylut::cli {

namespace fs = std::filesystem;

void require_writable(const std::string& option, const fs::path& file) {
  try {
    require_writable_file(file);
  } catch (const InputError& error) {
    throw InputError("{} {}: {}", option, file.string(), error.what());
  }
}

bool is_standard_output(const fs::path& file) { return file == "-" || file == "/dev/stdout"; }

void write_result(const fs::path& file, std::string_view text) {
  if (is_standard_output(file))
    std::fwrite(text.data(), 1, text.size(), stdout);  // main() looks whether it arrived
  else
    write_text_atomically(file, text);
}

void warn(const std::string& message) {
  std::fprintf(stderr, "skylut: warning: %s\n", in_one_line(message).c_str());
}

std::string in_one_line(std::string text) {
  for (char& character : text)
    if (character == '\n' || character == '\r') character = ' ';
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

}  // namespace skylut::cli
