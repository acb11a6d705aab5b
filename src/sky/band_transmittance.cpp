#include "band_transmittance.hpp"

#include "skylut/transfer/direct_beam.hpp"

namespace skylut {

double band_transmittance(const ConstituentExtinction& constituent, const std::vector<double>& path_factors) {
  double sum = 0.0;
  for (const ExtinctionTerm& term : constituent.terms)
    sum += term.weight * beam_transmittance(path_factors, term.depth);
  return sum;
}

}  // namespace skylut
