#include "export/png_writer.hpp"

#include <png.h>

#include <cstddef>
#include <new>

#include "skylut/core/errors.hpp"

namespace skylut {

namespace {

// libpng leaves a failed call by longjmp, which must not pass over objects with destructors: everything that
// the library touches while it writes is set up before and lives outside write().
struct Job {
  png_structp png = nullptr;
  png_infop info = nullptr;
  int width = 0;
  int height = 0;
  std::span<const std::uint8_t> pixels;
  std::vector<png_text> texts;
  std::string bytes;

  Job() = default;
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;
  ~Job() { png_destroy_write_struct(&png, &info); }
};

extern "C" void append(png_structp png, png_bytep data, png_size_t size) {
  auto* const bytes = static_cast<std::string*>(png_get_io_ptr(png));
  bool full = false;
  try {
    bytes->append(reinterpret_cast<const char*>(data), size);
  } catch (const std::bad_alloc&) {
    full = true;
  }
  if (full) png_error(png, "out of memory");
}

extern "C" void nothing_to_flush(png_structp) {}

bool write(Job& job) {
  if (setjmp(png_jmpbuf(job.png)) != 0) return false;
  png_set_write_fn(job.png, &job.bytes, append, nothing_to_flush);
  png_set_IHDR(job.png, job.info, static_cast<png_uint_32>(job.width), static_cast<png_uint_32>(job.height),
               8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB_gAMA_and_cHRM(job.png, job.info, PNG_sRGB_INTENT_RELATIVE);
  png_set_text(job.png, job.info, job.texts.data(), static_cast<int>(job.texts.size()));
  png_write_info(job.png, job.info);
  for (int row = 0; row < job.height; ++row)
    png_write_row(job.png, job.pixels.data() + static_cast<std::ptrdiff_t>(row) * job.width * 3);
  png_write_end(job.png, job.info);
  return true;
}

}  // namespace

std::string png_of(int width, int height, std::span<const std::uint8_t> pixels, const PngTexts& texts) {
  Job job;
  job.width = width;
  job.height = height;
  job.pixels = pixels;
  PngTexts kept = texts;
  for (auto& [keyword, value] : kept) {
    png_text text{};
    text.compression = PNG_TEXT_COMPRESSION_NONE;
    text.key = keyword.data();
    text.text = value.data();
    text.text_length = value.size();
    job.texts.push_back(text);
  }
  job.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  if (job.png != nullptr) job.info = png_create_info_struct(job.png);
  if (job.info == nullptr || !write(job)) throw WorkError("cannot make a PNG picture");
  return std::move(job.bytes);
}

}  // namespace skylut
