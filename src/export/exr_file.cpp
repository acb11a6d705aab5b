#include "export/exr_file.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>

#include <cstdint>

namespace skylut {

// OpenEXR's own file stream does not report a full disk while it closes; AtomicFile looks at every write and
// remembers a failure that a destructor swallows.
class ExrFile::Stream final : public Imf::OStream {
 public:
  Stream(AtomicFile& file, const std::string& name) : Imf::OStream(name.c_str()), file_(file) {}
  void write(const char data[], int size) override { file_.write({data, static_cast<std::size_t>(size)}); }
  std::uint64_t tellp() override { return file_.position(); }
  void seekp(std::uint64_t position) override { file_.seek(position); }

 private:
  AtomicFile& file_;
};

namespace {

Imf::Header complete(Imf::Header header, const std::vector<std::string>& channels) {
  header.compression() = Imf::ZIP_COMPRESSION;  // blocks of 16 rows
  for (const std::string& name : channels) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
  return header;
}

}  // namespace

ExrFile::ExrFile(const std::filesystem::path& path, Imf::Header header, std::vector<std::string> channels)
    : file_(path),
      stream_(std::make_unique<Stream>(file_, path.string())),
      // No threads of OpenEXR's: its pool belongs to the whole process.
      output_(std::make_unique<Imf::OutputFile>(*stream_, complete(std::move(header), channels), 0)),
      channels_(std::move(channels)),
      width_(output_->header().dataWindow().max.x + 1) {}

ExrFile::~ExrFile() = default;

void ExrFile::write_rows(int rows, std::initializer_list<std::span<const float>> groups) {
  const auto width = static_cast<std::size_t>(width_);
  const Imath::V2i first_pixel(0, output_->currentScanLine());
  Imf::FrameBuffer frame;
  auto name = channels_.begin();
  for (const std::span<const float> group : groups) {
    const std::size_t channels = group.size() / (static_cast<std::size_t>(rows) * width);
    const std::size_t pixel_bytes = channels * sizeof(float);
    for (std::size_t i = 0; i < channels; ++i)
      frame.insert(*name++, Imf::Slice::Make(Imf::FLOAT, group.data() + i, first_pixel, width_, rows,
                                             pixel_bytes, width * pixel_bytes));
  }
  output_->setFrameBuffer(frame);
  output_->writePixels(rows);
}

void ExrFile::close() { output_.reset(); }

}  // namespace skylut
