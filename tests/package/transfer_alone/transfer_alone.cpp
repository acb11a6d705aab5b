// Henyey-Greenstein's moments are powers of g.
#include <skylut/scattering/phase_function.hpp>
#include <skylut/transfer/quality.hpp>

int main() {
  const skylut::HenyeyGreensteinPhaseFunction phase(0.5);
  return phase.moment(2) == 0.25 && skylut::discretisation_of(skylut::Quality::standard).tolerance > 0.0 ? 0
                                                                                                         : 1;
}
