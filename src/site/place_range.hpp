#pragma once

#include "skylut/site/place.hpp"

namespace skylut {

/// @throws InputError  naming the member of the place that is out of its range
void check_place(const Place& place);

}  // namespace skylut
