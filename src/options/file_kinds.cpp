#include "file_kinds.hpp"

#include <algorithm>
#include <cctype>

#include "skylut/core/writable.hpp"

namespace skylut::cli {

namespace fs = std::filesystem;

namespace {

std::string plain(const std::string& text) { return text; }
std::string plain_path(const fs::path& path) { return path.string(); }

fs::path read_path(const std::string& text, const char* what) {
  if (text.empty()) throw InputError("must be the name of a {}", what);
  return text;
}

}  // namespace

std::string ending_of(const fs::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char character) { return static_cast<char>(std::tolower(character)); });
  return ending;
}

Kind<std::string> name_or_file() {
  const auto read = [](const std::string& text) {
    if (text.empty()) throw InputError("must be a name or a file");
    return text;
  };
  return {"NAME|FILE", read, plain};
}

Kind<fs::path> file_in(const std::string& placeholder) {
  return {placeholder, [](const std::string& text) { return read_path(text, "file"); }, plain_path};
}

Kind<fs::path> file_out() {
  const auto read = [](const std::string& text) {
    fs::path file = read_path(text, "file");
    if (file != "-") require_writable_file(file);
    return file;
  };
  return {"FILE", read, plain_path};
}

Kind<fs::path> file_named(const std::vector<std::string>& endings) {
  const auto read = [endings](const std::string& text) {
    fs::path file = read_path(text, "file");
    if (std::find(endings.begin(), endings.end(), ending_of(file)) == endings.end())
      throw InputError("must be the name of a {} file", listed(endings));
    return file;
  };
  return {"FILE", read, plain_path};
}

Kind<fs::path> folder_out() {
  const auto read = [](const std::string& text) {
    fs::path folder = read_path(text, "folder");
    require_writable_folder(folder);
    return folder;
  };
  return {"DIR", read, plain_path};
}

}  // namespace skylut::cli
