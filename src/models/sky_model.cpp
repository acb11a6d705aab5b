#include "skylut/models/sky_model.hpp"

#include "skylut/core/errors.hpp"

namespace skylut {

void Sky::radiance(std::span<const Direction>, std::span<float>) const {
  throw InputError("spectra of a model that knows colours only: must be asked for its colour");
}

}  // namespace skylut
