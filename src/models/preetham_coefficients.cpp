#include "skylut/models/preetham_coefficients.hpp"

namespace skylut {

PerezYxy preetham1999_coefficients(double turbidity) {
  const double T = turbidity;
  return {.Y = {0.1787 * T - 1.4630, -0.3554 * T + 0.4275, -0.0227 * T + 5.3251, 0.1206 * T - 2.5771,
                -0.0670 * T + 0.3703},
          .x = {-0.0193 * T - 0.2592, -0.0665 * T + 0.0008, -0.0004 * T + 0.2125, -0.0641 * T - 0.8989,
                -0.0033 * T + 0.0452},
          .y = {-0.0167 * T - 0.2608, -0.0950 * T + 0.0092, -0.0079 * T + 0.2102, -0.0441 * T - 1.6537,
                -0.0109 * T + 0.0529}};
}

}  // namespace skylut
