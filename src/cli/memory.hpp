#pragma once

#include <cstddef>
#include <functional>
#include <string>

/// Requests that cannot fit the machine are refused before the work. [docs/performance.md]
namespace skylut::cli {

/// How many of each thing a request for skies asks for, with the option that says so.
struct RequestSize {
  double directions = 1;
  double wavelengths = 1;
  double turbidities = 1;
  double altitudes = 1;
  double suns = 1;
};

/// About how much memory the simulation of it holds at the same time, bytes.
double needed_bytes(const RequestSize& size);

/// The same of a table: its loads are solved one after the other, and of its skies the colours are kept.
/// @param map_directions  of the maps that are kept with their radiances; 0: none
double needed_bytes_of_table(const RequestSize& size, double map_directions);

/// What this process may use: the machine's memory, or less if a limit (ulimit -v, a control group) is set.
double available_bytes();

/// Refuses skies that do not fit, naming the list that is longest for what it costs and how much of it fits.
/// @throws InputError
void require_memory(const RequestSize& size,
                    const std::function<double(const RequestSize&)>& needed = needed_bytes);

}  // namespace skylut::cli
