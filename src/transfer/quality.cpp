#include "skylut/transfer/quality.hpp"

#include <cmath>
#include <string>

#include "skylut/core/errors.hpp"

namespace skylut {

namespace {

/// One number of DiscretisationOptions as the command line knows it.
struct Number {
  std::string_view name;
  double lowest;
  double highest;
  bool whole;
  double (*get)(const DiscretisationOptions&);
  void (*set)(DiscretisationOptions&, double);
};

template <auto kMember>
constexpr Number number(std::string_view name, double lowest, double highest, bool whole) {
  return {name,
          lowest,
          highest,
          whole,
          [](const DiscretisationOptions& options) { return static_cast<double>(options.*kMember); },
          [](DiscretisationOptions& options, double value) {
            options.*kMember = static_cast<std::remove_reference_t<decltype(options.*kMember)>>(value);
          }};
}

using Options = DiscretisationOptions;
constexpr Number kNumbers[] = {
    number<&Options::optical_step>("optical-step", 1e-3, 1.0, false),
    number<&Options::truncated_peak>("truncated-peak", 1e-4, 0.1, false),
    number<&Options::narrow_peak_degree>("narrow-peak-degrees", 2, 30, true),
    number<&Options::polarised_degree>("polarised-degrees", 0, 30, true),
    number<&Options::polar_per_degree>("polar-per-degree", 0.5, 4.0, false),
    number<&Options::least_polar_nodes>("polar-nodes", 4, 64, true),
    number<&Options::sun_node_density>("sun-nodes", 0, 4, true),
    number<&Options::sun_bands>("sun-bands", 0, 1, true),
    number<&Options::merge_layers>("merge-layers", 0, 1, true),
    number<&Options::ray_step_km>("ray-step-km", 0.1, 100.0, false),
    number<&Options::sunbeam_step_km>("sunbeam-step-km", 0.01, 10.0, false),
    number<&Options::tolerance>("tolerance", 1e-6, 0.1, false),
};

void check(const Number& number, double value) {
  if (!(value >= number.lowest && value <= number.highest) || (number.whole && value != std::floor(value)))
    throw InputError("{} {}: must be {} within {} to {}", number.name, value,
                     number.whole ? "a whole number" : "a number", number.lowest, number.highest);
}

}  // namespace

DiscretisationOptions discretisation_of(Quality quality) {
  switch (quality) {
    case Quality::draft:
      return {.optical_step = 0.2,
              .truncated_peak = 0.024,
              .narrow_peak_degree = 12,
              .polarised_degree = 4,
              .polar_per_degree = 0.6,
              .least_polar_nodes = 8,
              .sun_node_density = 0,
              .sun_bands = true,
              .merge_layers = true,
              .ray_step_km = 20.0,
              .sunbeam_step_km = 2.0,
              .tolerance = 3e-3};
    case Quality::standard:
      return {.optical_step = 0.04,
              .truncated_peak = 0.012,
              .narrow_peak_degree = 20,
              .polarised_degree = 6,
              .polar_per_degree = 0.7,
              .least_polar_nodes = 10,
              .sun_node_density = 0,
              .sun_bands = true,
              .merge_layers = true,
              .ray_step_km = 10.0,
              .sunbeam_step_km = 0.25,
              .tolerance = 1e-3};
    case Quality::reference:
      return {.optical_step = 0.02,
              .truncated_peak = 0.004,
              .narrow_peak_degree = 30,
              .polarised_degree = 12,
              .polar_per_degree = 0.9,
              .least_polar_nodes = 16,
              .sun_node_density = 1,
              .sun_bands = false,
              .merge_layers = false,
              .ray_step_km = 5.0,
              .sunbeam_step_km = 0.125,
              .tolerance = 1e-4};
  }
  return discretisation_of(Quality::standard);
}

void set_discretisation(DiscretisationOptions& options, std::string_view name, double value) {
  std::string known;
  for (const Number& number : kNumbers) {
    if (number.name == name) {
      check(number, value);
      number.set(options, value);
      return;
    }
    known += (known.empty() ? "" : ", ") + std::string(number.name);
  }
  throw InputError("quality limit '{}': must be one of {}", name, known);
}

void check_discretisation(const DiscretisationOptions& options) {
  for (const Number& number : kNumbers) check(number, number.get(options));
}

}  // namespace skylut
