#include "optics_cache.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "skylut/core/atomic_file.hpp"
#include "skylut/core/context.hpp"

namespace skylut {

namespace fs = std::filesystem;

namespace {

// Counts up whenever particle_optics() gives other numbers for the same request.
constexpr int kAlgorithm = 1;

// FNV-1a, 64 bit. The file holds the whole key, so that a coincidence of names is harmless.
fs::path file_for(const Context& context, const std::string& key) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char character : key) hash = (hash ^ static_cast<unsigned char>(character)) * 0x100000001b3;
  return context.cache_folder / fmt::format("aerosol-{:016x}.txt", hash);
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
  std::ifstream file(file_for(context, key));
  std::string line;
  if (!std::getline(file, line) || line != key) return std::nullopt;
  std::vector<ParticleOptics> results;
  bool complete = false;
  while (!complete && std::getline(file, line)) {
    if (line == "end") {
      complete = true;
      continue;
    }
    std::vector<double> numbers;
    if (!read_numbers(line, numbers) || numbers.size() < 4) return std::nullopt;
    results.push_back({numbers[0], numbers[1], {numbers.begin() + 2, numbers.end()}});
  }
  if (!complete) return std::nullopt;
  return results;
}

void keep_in_cache(const Context& context, const std::string& key,
                   const std::vector<ParticleOptics>& results) {
  if (context.cache_folder.empty()) return;
  std::string text = key + "\n";
  for (const ParticleOptics& result : results)
    text += fmt::format("{} {} {}\n", result.extinction_um2, result.scattering_um2,
                        fmt::join(result.moments, " "));
  text += "end\n";
  std::error_code ignored;
  fs::create_directories(context.cache_folder, ignored);
  try {
    write_text_atomically(file_for(context, key), text);
  } catch (const std::exception&) {
    // No place to keep it: the next run computes it again.
    return;
  }
}

}  // namespace skylut
