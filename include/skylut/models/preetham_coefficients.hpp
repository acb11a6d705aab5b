#pragma once

#include "skylut/models/perez_sky.hpp"

namespace skylut {

/// The coefficients of Preetham, Shirley and Smits 1999, appendix A.2, linear in turbidity T. The UTM report
/// 2005, eqs. 2.20-2.21, loses the signs of A_x, D_x and D_y. [fit.md P1]
/// preetham1999.hpp has the whole model.
PerezYxy preetham1999_coefficients(double turbidity);

}  // namespace skylut
