#include "skylut/models/preetham_coefficients.hpp"

#include "skylut/models/preetham_matrices.hpp"

namespace skylut {

PerezYxy preetham1999_coefficients(double turbidity) {
  return preetham1999_matrices().coefficients(turbidity);
}

}  // namespace skylut
