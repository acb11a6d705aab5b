#include "optics_cache.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <string_view>

#include "skylut/core/atomic_file.hpp"
#include "skylut/core/context.hpp"

namespace skylut {

namespace fs = std::filesystem;

namespace {

// Counts up whenever particle_optics() gives other numbers for the same request.
constexpr int kAlgorithm = 3;

// 13 wavelengths of 4 times 4000 moments are 5 MB.
constexpr off_t kLargestFile_bytes = 16'000'000;

// FNV-1a, 64 bit.
std::uint64_t hash_of(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char character : text) hash = (hash ^ static_cast<unsigned char>(character)) * 0x100000001b3;
  return hash;
}

// The file holds the whole key, so that a coincidence of names is harmless.
fs::path file_for(const Context& context, const std::string& key) {
  return context.cache_folder / fmt::format("aerosol-{:016x}.txt", hash_of(key));
}

std::string checksum_line(std::string_view content) {
  return fmt::format("checksum {:016x}\n", hash_of(content));
}

// A regular file of sensible size, itself and not where a link points; anything else, a pipe or a device that
// would keep us waiting, is as good as no file.
std::optional<std::string> read_regular_file(const fs::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) return std::nullopt;
  std::optional<std::string> text;
  struct stat status {};
  if (::fstat(file, &status) == 0 && S_ISREG(status.st_mode) && status.st_size <= kLargestFile_bytes) {
    text.emplace(static_cast<std::size_t>(status.st_size), '\0');
    std::size_t size = 0;
    while (size < text->size()) {
      const ssize_t got = ::read(file, text->data() + size, text->size() - size);
      if (got <= 0) break;
      size += static_cast<std::size_t>(got);
    }
    if (size != text->size()) text.reset();
  }
  ::close(file);
  return text;
}

// The next line of a text, taken off its front.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

bool read_numbers(std::string_view line, std::vector<double>& numbers) {
  const char* at = line.data();
  const char* const end = at + line.size();
  while (at < end) {
    double value = 0.0;
    const auto [stop, error] = std::from_chars(at, end, value);
    if (error != std::errc{} || (stop != end && *stop != ' ')) return false;
    numbers.push_back(value);
    at = stop == end ? end : stop + 1;
  }
  return true;
}

// What Mie's theory can have given. Without absorption scattering is extinction but for rounding.
bool is_possible(const ParticleOptics& optics) {
  if (!(optics.extinction_um2 >= 0.0 && std::isfinite(optics.extinction_um2))) return false;
  if (!(optics.scattering_um2 >= 0.0 && optics.scattering_um2 <= (1.0 + 1e-9) * optics.extinction_um2))
    return false;
  if (optics.moments.size() < 2 || optics.moments.front() != 1.0) return false;
  for (const double moment : optics.moments)
    if (!(std::abs(moment) <= 1.0)) return false;
  const PolarisationMoments& polarisation = optics.polarisation;
  for (const std::vector<double>* kind : {&polarisation.alpha2, &polarisation.alpha3, &polarisation.beta1}) {
    if (kind->size() != optics.moments.size()) return false;
    for (const double moment : *kind)
      if (!(std::abs(moment) <= 1.0)) return false;
  }
  return true;
}

}  // namespace

std::string optics_key(const std::vector<AerosolComponent>& components,
                       const std::vector<double>& wavelength_nm) {
  std::string key =
      fmt::format("skylut particle optics {}; nm {}", kAlgorithm, fmt::join(wavelength_nm, " "));
  for (const AerosolComponent& component : components) {
    const SizeDistribution& size = component.size;
    key += fmt::format("; {} {} {} {} {} {} {} at {} n {} k {}", component.number_per_cm3,
                       static_cast<int>(size.kind), size.mode_radius_um, size.sigma_g, size.exponent,
                       size.r_min_um, size.r_max_um, fmt::join(component.wavelength_nm, " "),
                       fmt::join(component.n, " "), fmt::join(component.k, " "));
  }
  return key;
}

std::optional<std::vector<ParticleOptics>> find_in_cache(const Context& context, const std::string& key) {
  if (context.cache_folder.empty()) return std::nullopt;
  const std::optional<std::string> text = read_regular_file(file_for(context, key));
  if (!text) return std::nullopt;
  std::string_view rest = *text;
  const std::string_view checksum = take_line(rest);
  if (fmt::format("{}\n", checksum) != checksum_line(rest) || take_line(rest) != key) return std::nullopt;
  std::vector<ParticleOptics> results;
  for (std::string_view line = take_line(rest); line != "end"; line = take_line(rest)) {
    std::vector<double> numbers;
    if (!read_numbers(line, numbers) || numbers.size() < 4) return std::nullopt;
    results.push_back({numbers[0], numbers[1], {numbers.begin() + 2, numbers.end()}});
    PolarisationMoments& polarisation = results.back().polarisation;
    for (std::vector<double>* kind : {&polarisation.alpha2, &polarisation.alpha3, &polarisation.beta1})
      if (!read_numbers(take_line(rest), *kind)) return std::nullopt;
    if (!is_possible(results.back())) return std::nullopt;
  }
  return results;
}

void keep_in_cache(const Context& context, const std::string& key,
                   const std::vector<ParticleOptics>& results) {
  if (context.cache_folder.empty()) return;
  std::string content = key + "\n";
  for (const ParticleOptics& result : results)
    content +=
        fmt::format("{} {} {}\n{}\n{}\n{}\n", result.extinction_um2, result.scattering_um2,
                    fmt::join(result.moments, " "), fmt::join(result.polarisation.alpha2, " "),
                    fmt::join(result.polarisation.alpha3, " "), fmt::join(result.polarisation.beta1, " "));
  content += "end\n";
  std::error_code ignored;
  fs::create_directories(context.cache_folder, ignored);
  const fs::path file = file_for(context, key);
  // A pipe or a device in the file's place would be written to, and might keep us waiting.
  if (fs::exists(fs::symlink_status(file, ignored)) &&
      !fs::is_regular_file(fs::symlink_status(file, ignored)))
    return;
  try {
    write_text_atomically(file, checksum_line(content) + content);
  } catch (const std::exception&) {
    // No place to keep it: the next run computes it again.
    return;
  }
}

}  // namespace skylut
