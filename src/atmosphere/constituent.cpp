#include "skylut/atmosphere/constituent.hpp"

namespace skylut {

std::vector<Scatterer> Constituent::scatterers(double, double) const { return {}; }

}  // namespace skylut
