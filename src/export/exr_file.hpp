#pragma once

#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>

#include <filesystem>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "skylut/core/atomic_file.hpp"

namespace skylut {

/// One OpenEXR file of 32-bit floats, written from the top row downwards, that appears when it is published.
class ExrFile {
 public:
  /// @param header    with its attributes; channels and compression are added
  /// @param channels  names, in the order in which the pixels hold them
  ExrFile(const std::filesystem::path& path, Imf::Header header, std::vector<std::string> channels);
  ~ExrFile();

  /// The next rows.
  /// @param groups  of channels, in the order of their names: each [row][column][channel of the group]
  void write_rows(int rows, std::initializer_list<std::span<const float>> groups);
  /// After the last row: what is left goes to the file, which may then be published.
  void close();
  AtomicFile& file() { return file_; }

 private:
  class Stream;
  AtomicFile file_;
  std::unique_ptr<Stream> stream_;
  std::unique_ptr<Imf::OutputFile> output_;
  std::vector<std::string> channels_;
  int width_;
};

}  // namespace skylut
