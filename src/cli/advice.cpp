#include "advice.hpp"

#include "output.hpp"
#include "skylut/colour/cie1931.hpp"
#include "skylut/core/context.hpp"

namespace skylut::cli {

namespace {

constexpr double kEnough = 0.99;  // of the eye's sensitivity

// A single wavelength stands for the band around it.
std::pair<double, double> covered_nm(const WavelengthGrid& wavelengths) {
  const double half_nm = wavelengths.size() == 1 ? 0.5 * wavelengths.step_nm() : 0.0;
  return {wavelengths.first_nm() - half_nm, wavelengths.last_nm() + half_nm};
}

}  // namespace

void advise_on_turbidity(std::span<const Turbidity> turbidities, const Atmosphere& air) {
  for (const Turbidity& turbidity : turbidities) {
    const TurbidityKind kind = turbidity.kind;
    if (kind == TurbidityKind::preetham_t || kind == TurbidityKind::visibility_km) continue;
    const double aod500 = to_aod500(turbidity, air);
    if (aod500 <= kThickAir_aod500) continue;
    warn(
        "turbidity {} ({}) is an optical depth, of thick haze: Preetham's T {:.3g}, visibility {:.2g} km; if "
        "you "
        "mean T, give --turbidity-kind preetham-t",
        turbidity.value, turbidity_kind_name(kind), from_aod500(aod500, TurbidityKind::preetham_t, air),
        from_aod500(aod500, TurbidityKind::visibility_km, air));
    return;
  }
}

void advise_on_profile(const Context& context, const Profile& profile) {
  const bool ours = std::filesystem::path(profile.file).parent_path() == context.data_folder;
  if (ours) return;
  for (const std::string& note : profile.notes) warn("profile {}: {}", profile.name, note);
}

void advise_on_wavelengths(const Context& context, const WavelengthGrid& wavelengths) {
  const auto [first_nm, last_nm] = covered_nm(wavelengths);
  const double part = ColourMatching::load(context).part_of_vision(first_nm, last_nm);
  if (part >= kEnough) return;
  warn("luminance and colour count only {}-{} nm: {:.2g} % of the eye's sensitivity", first_nm, last_nm,
       100.0 * part);
}

}  // namespace skylut::cli
