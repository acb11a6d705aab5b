#pragma once

#include <span>

#include "skylut/sky/simulate_sky.hpp"

/// What is no mistake but seldom meant, said in a line on standard error before the work.
namespace skylut::cli {

/// Above this optical depth at 500 nm hardly any cloudless sky lies; the thickest dust storms reach it.
inline constexpr double kThickAir_aod500 = 1.5;

/// Says what an optical depth above kThickAir_aod500 is in other words: Preetham's T and Linke's turbidity
/// are often typed for it.
void advise_on_turbidity(std::span<const Turbidity> turbidities, const Atmosphere& air);

/// Says what was done to a user's profile that its author may not expect (Profile::notes).
void advise_on_profile(const Context& context, const Profile& profile);

/// Says how much of the eye's sensitivity the wavelengths cover, if that is less than 99 %.
void advise_on_wavelengths(const Context& context, const WavelengthGrid& wavelengths);

}  // namespace skylut::cli
