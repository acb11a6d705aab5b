#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "skylut/core/json_reader.hpp"
#include "skylut/scattering/phase_function.hpp"

namespace skylut {

/// The scattering matrix of a layer as the file gives it: a table by angle or moments.
struct CaseMatrix {
  std::vector<double> numbers;  ///< all that the file gives; equal ones are one scatterer
  std::shared_ptr<const PhaseFunction> (*make)(const JsonReader& place);
};

/// Reads {theta_deg, f11, f12, f33 and, if given, f22 (else f11)}; f34 and f44, which belong to V, are read
/// and not used.
CaseMatrix read_matrix_table(const JsonReader& place);

/// Reads {alpha1, alpha2, alpha3, beta1}, of one length.
CaseMatrix read_matrix_moments(const JsonReader& place);

/// Names of what the layers hold and nothing uses: the elements of V. Empty: nothing.
std::vector<std::string> unused_elements(const std::vector<JsonReader>& layers);

}  // namespace skylut
