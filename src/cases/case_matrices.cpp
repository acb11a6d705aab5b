#include "case_matrices.hpp"

#include <fmt/format.h>

#include <initializer_list>
#include <string>

#include "skylut/core/errors.hpp"
#include "skylut/scattering/legendre_scattering_matrix.hpp"
#include "skylut/scattering/tabulated_scattering_matrix.hpp"

namespace skylut {
namespace {

constexpr double kHuge = 1e300;

std::vector<double> elements_of(const JsonReader& place, const char* key) {
  return place.at(key).numbers(-kHuge, kHuge, "finite (an element of a scattering matrix)");
}

std::vector<double> moments_of(const JsonReader& place, const char* key) {
  return place.at(key).numbers(-1.0, 1.0, "within -1 to 1 (a moment of a scattering matrix)");
}

void append(std::vector<double>& numbers, const std::vector<double>& more) {
  numbers.push_back(static_cast<double>(more.size()));
  numbers.insert(numbers.end(), more.begin(), more.end());
}

std::shared_ptr<const PhaseFunction> make_table(const JsonReader& place) {
  ScatteringTable table{place.at("theta_deg").numbers(0.0, 180.0, "within 0-180 (a scattering angle)"),
                        elements_of(place, "f11"), elements_of(place, "f12"),
                        elements_of(place, place.has("f22") ? "f22" : "f11"), elements_of(place, "f33")};
  try {
    return std::make_shared<const TabulatedScatteringMatrix>(std::move(table));
  } catch (const InputError& error) {
    place.refuse(error.what());
  }
}

std::shared_ptr<const PhaseFunction> make_moments(const JsonReader& place) {
  const std::vector<double> alpha1 = moments_of(place, "alpha1");
  const std::vector<double> alpha2 = moments_of(place, "alpha2");
  const std::vector<double> alpha3 = moments_of(place, "alpha3");
  const std::vector<double> beta1 = moments_of(place, "beta1");
  std::vector<MatrixMoments> moments;
  for (std::size_t l = 0; l < alpha1.size(); ++l)
    moments.push_back({alpha1[l], alpha2[l], alpha3[l], beta1[l]});
  try {
    return std::make_shared<const LegendreScatteringMatrix>(std::move(moments));
  } catch (const InputError& error) {
    place.refuse(error.what());
  }
}

}  // namespace

CaseMatrix read_matrix_table(const JsonReader& place) {
  place.only({"theta_deg", "f11", "f12", "f22", "f33", "f34", "f44"});
  CaseMatrix matrix{{}, make_table};
  for (const char* key : {"theta_deg", "f11", "f12", "f33"}) append(matrix.numbers, elements_of(place, key));
  if (place.has("f22")) append(matrix.numbers, elements_of(place, "f22"));
  for (const char* key : {"f34", "f44"})
    if (place.has(key)) elements_of(place, key);
  return matrix;
}

CaseMatrix read_matrix_moments(const JsonReader& place) {
  place.only({"alpha1", "alpha2", "alpha3", "beta1"});
  CaseMatrix matrix{{}, make_moments};
  const std::size_t count = moments_of(place, "alpha1").size();
  for (const char* key : {"alpha1", "alpha2", "alpha3", "beta1"}) {
    const std::vector<double> moments = moments_of(place, key);
    if (moments.size() != count)
      place.at(key).refuse(
          fmt::format("{} moments must be {}, as many as alpha1 has", moments.size(), count));
    append(matrix.numbers, moments);
  }
  return matrix;
}

std::vector<std::string> unused_elements(const std::vector<JsonReader>& layers) {
  std::vector<std::string> unused;
  for (const char* table : {"phase_matrix_aerosol", "phase_matrix"})
    for (const char* element : {"f34", "f44"})
      for (const JsonReader& layer : layers)
        if (layer.has(table) && layer.at(table).has(element)) {
          unused.push_back(fmt::format("layers[].{}.{}", table, element));
          break;
        }
  return unused;
}

}  // namespace skylut
