#include "skylut/table/table_turbidity.hpp"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "skylut/core/errors.hpp"

namespace skylut {

namespace {

constexpr double kAngstromExponent = 1.3;

// Bodhaine et al. 1999 eq. 30: sea level, 45° latitude, 360 ppm CO₂. 0.09707 at 550 nm.
double rayleigh_depth(double wavelength_um) {
  const double square = wavelength_um * wavelength_um;
  return 0.0021520 * (1.0455996 - 341.29061 / square - 0.90230850 * square) /
         (1.0 + 0.0027059889 / square - 85.968563 * square);
}

double aerosol_depth_550(const std::string& kind, double value) {
  if (kind == "aod500") return value * std::pow(550.0 / 500.0, -kAngstromExponent);
  if (kind == "aod550") return value;
  if (kind == "angstrom-beta") return value * std::pow(0.55, -kAngstromExponent);
  throw InputError("turbidity kind '{}': must be one of aod500, aod550, angstrom-beta, preetham-t{}", kind,
                   kind == "visibility-km" ? ", since visibility needs the table.json of the table" : "");
}

}  // namespace

TableTurbidity::TableTurbidity(const std::filesystem::path& json, const std::optional<std::string>& kind)
    : json_(json), kind_(kind.value_or("aod500")) {
  if (!kind && std::filesystem::is_regular_file(json)) {
    try {
      std::ifstream file(json);
      const nlohmann::json table = nlohmann::json::parse(file);
      for (const nlohmann::json& one : table.at("inputs").at("turbidities"))
        listed_.push_back({one.at("given").get<double>(), one.at("preetham-t").get<double>()});
    } catch (const nlohmann::json::exception& error) {
      throw InputError("{}: {}: must be the table.json of skylut table", json.string(), error.what());
    }
    listed_only_ = true;
    source_ = "as table.json converts it";
    return;
  }
  if (kind_ != "preetham-t") aerosol_depth_550(kind_, 0.0);
  source_ = kind_ == "preetham-t" ? "as the table has it"
                                  : "from " + kind_ + " by 1 + tau_A(550)/0.0971, Angstrom exponent 1.3";
}

double TableTurbidity::preetham_t(double turbidity) const {
  if (listed_only_) {
    for (const Listed& listed : listed_)
      if (listed.given == turbidity) return listed.preetham_t;
    throw InputError(
        "{}: turbidity {} of the table is not in it: table.csv and table.json must belong together",
        json_.string(), turbidity);
  }
  if (kind_ == "preetham-t") return turbidity;
  return 1.0 + aerosol_depth_550(kind_, turbidity) / rayleigh_depth(0.55);
}

}  // namespace skylut
