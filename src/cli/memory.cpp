#include "memory.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "skylut/core/errors.hpp"
#include "skylut/transfer/transfer_cost.hpp"

namespace skylut::cli {

namespace {

// Bytes, counted from the types in simulate_sky.cpp and checked against peaks of real runs.
constexpr double kRadiance = 4.0;
constexpr double kMapDirection = 100.0;  // direction, colour, a line in the view set
constexpr double kColumn = 250e3;        // one optical column: layers, mostly tables of phase functions
constexpr double kColumnsPerBand = 1.3;  // where lines absorb a band has several
constexpr double kUsable = 0.9;          // the rest is the program's and the system's

std::string gigabytes(double bytes) {
  return bytes < 1e10 ? fmt::format("{:.1f} GB", bytes * 1e-9) : fmt::format("{:.0f} GB", bytes * 1e-9);
}

std::string refusal(double needed, double available) {
  return fmt::format("needs about {} of memory, {} may be used here", gigabytes(needed),
                     gigabytes(available));
}

}  // namespace

double needed_bytes(const RequestSize& size) {
  const double columns = kColumnsPerBand * size.wavelengths * size.turbidities;
  const double maps = size.altitudes * size.turbidities * size.suns;
  // The solver answers every sun's views under every sun.
  const double solved = columns * size.altitudes * size.suns * (size.suns * size.directions) * kRadiance;
  return solved + columns * kColumn + maps * size.directions * (size.wavelengths * kRadiance + kMapDirection);
}

double needed_bytes_of_table(const RequestSize& size, double map_directions) {
  const double skies = size.altitudes * size.turbidities * size.suns;
  const double columns = kColumnsPerBand * size.wavelengths;
  return columns * kColumn + skies * size.directions * kMapDirection +
         skies * map_directions * (size.wavelengths * kRadiance + kMapDirection);
}

double available_bytes() {
  double bytes = machine_memory_bytes();
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    bytes = std::min(bytes, static_cast<double>(limit.rlim_cur));
  return kUsable * bytes;
}

void require_memory(const RequestSize& size, const std::function<double(const RequestSize&)>& needed_for) {
  const double available = available_bytes();
  const double needed = needed_for(size);
  if (needed <= available) return;
  // The longest list is the one to shorten. Only a single map chooses its directions.
  std::vector<std::pair<double RequestSize::*, const char*>> lists{
      {&RequestSize::turbidities, "--turbidities"},
      {&RequestSize::suns, "--suns"},
      {&RequestSize::wavelengths, "--wavelengths-nm"},
      {&RequestSize::altitudes, "--altitudes-km"}};
  if (size.turbidities * size.suns * size.altitudes == 1.0)
    lists.emplace_back(&RequestSize::directions, "--directions");
  const auto longest = *std::max_element(lists.begin(), lists.end(), [&](const auto& a, const auto& b) {
    return size.*a.first < size.*b.first;
  });
  const double count = size.*longest.first;
  RequestSize fitting = size;
  double fits = std::floor(count);
  while (fits > 1.0 && needed_for(fitting) > available)
    fitting.*longest.first = fits = std::floor(0.9 * fits);
  throw InputError("{}: {} values: {}: at most {:.0f} fit", longest.second, count, refusal(needed, available),
                   fits);
}

}  // namespace skylut::cli
