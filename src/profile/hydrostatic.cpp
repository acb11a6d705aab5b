#include "hydrostatic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/quadrature.hpp"

namespace skylut {

namespace {

// U.S. Standard Atmosphere 1976: dry air at sea level, and the radius at which g falls as 1/r².
constexpr double kMolarMass_kg_per_mol = 28.9644e-3;
constexpr double kEffectiveEarthRadius_km = 6356.766;
// A molecule of water is lighter than one of air by this part.
constexpr double kLightnessOfWater = 1.0 - 18.01528 / 28.9644;

// Of the whole column, before anything is changed. AFGL's model atmospheres stay below 0.0025.
constexpr double kTolerance = 0.003;
constexpr double kNegligiblePiece = 2e-4;   // of the whole column: rounded pressures
constexpr double kPieceThatMatters = 0.01;  // of the whole column
// Logarithms of densities are not straight over thicker pieces than this where most of the air is.
constexpr double kThickPiece_km = 2.5;
constexpr double kMostAirBelow_km = 30.0;
constexpr double kWidestStep_km = 1.0;
constexpr int kFewestSteps = 4;

double gravity_m_s2(double height_km) {
  const double ratio = kEffectiveEarthRadius_km / (kEffectiveEarthRadius_km + height_km);
  return kStandardGravity_m_s2 * ratio * ratio;
}

const Quadrature& rule() {
  static const Quadrature nodes = gauss_legendre(12, 0.0, 1.0);
  return nodes;
}

// The piece between two levels of a profile, t from 0 to 1.
class Piece {
 public:
  Piece(const Profile& profile, double ground_height_km, std::size_t i)
      : lower_km_(profile.altitude_km[i]),
        thickness_km_(profile.altitude_km[i + 1] - profile.altitude_km[i]),
        ground_height_km_(ground_height_km),
        lower_K_(profile.temperature_K[i]),
        upper_K_(profile.temperature_K[i + 1]),
        fall_(std::log(profile.pressure_hPa[i] / profile.pressure_hPa[i + 1])),
        weight_Pa_(100.0 * (profile.pressure_hPa[i] - profile.pressure_hPa[i + 1])),
        column_per_m2_(air_column_per_m2(profile, profile.altitude_km[i], profile.altitude_km[i + 1])) {
    if (const GasProfile* water = profile.gas("water_vapour")) {
      lower_water_ = water->density_per_m3[i] / air_state(profile, lower_km_).density_per_m3;
      upper_water_ = water->density_per_m3[i + 1] / air_state(profile, altitude_km(1.0)).density_per_m3;
    }
  }

  double altitude_km(double t) const { return lower_km_ + t * thickness_km_; }
  double lower_km() const { return lower_km_; }
  double upper_km() const { return lower_km_ + thickness_km_; }
  double column_per_m2() const { return column_per_m2_; }

  double temperature_K(double t, double bow) const {
    return (lower_K_ + t * (upper_K_ - lower_K_)) * std::exp(-4.0 * bow * t * (1.0 - t));
  }

  // -d ln p / dz, 1/km: m g / (k T).
  double slope_per_km(double t, double bow) const {
    return 1000.0 * molecule_kg(t) * gravity_m_s2(altitude_km(t) + ground_height_km_) /
           (kBoltzmann_J_per_K * temperature_K(t, bow));
  }

  // ln(p_0/p_t) between two places of the piece.
  double fall_between(double from, double to, double bow) const {
    double fall = 0.0;
    for (std::size_t k = 0; k < rule().node.size(); ++k)
      fall += rule().weight[k] * (to - from) * thickness_km_ *
              slope_per_km(from + rule().node[k] * (to - from), bow);
    return fall;
  }

  // Molecules whose weight is the fall of pressure, by g and m at the mean altitude of the piece's air.
  double weight_per_m2() const {
    double sum = 0.0;
    double mean_t = 0.0;
    for (std::size_t k = 0; k < rule().node.size(); ++k) {
      const double t = rule().node[k];
      const double amount = rule().weight[k] * std::exp(-fall_ * t) / temperature_K(t, 0.0);
      sum += amount;
      mean_t += amount * t;
    }
    mean_t /= sum;
    return weight_Pa_ / (molecule_kg(mean_t) * gravity_m_s2(altitude_km(mean_t) + ground_height_km_));
  }

  // Mean temperature that the pressures ask for over that of the levels.
  double temperature_ratio() const { return fall_between(0.0, 1.0, 0.0) / fall_; }

  // The bow that makes the pressure fall as it does; monotonic, hence Newton's steps with the slope's own
  // derivative by difference.
  double bow() const {
    double c = 0.0;
    for (int step = 0; step < 50; ++step) {
      constexpr double kDifference = 1e-5;
      const double miss = fall_between(0.0, 1.0, c) - fall_;
      const double derivative = (fall_between(0.0, 1.0, c + kDifference) - fall_ - miss) / kDifference;
      c -= miss / derivative;
      if (std::abs(miss) < 1e-12) break;
    }
    return c;
  }

  bool is_thick() const { return thickness_km_ > kThickPiece_km && lower_km_ < kMostAirBelow_km; }

  int steps() const {
    return std::max(kFewestSteps, static_cast<int>(std::ceil(thickness_km_ / kWidestStep_km - 1e-9)));
  }

 private:
  double molecule_kg(double t) const {
    const double water = lower_water_ + t * (upper_water_ - lower_water_);
    return kMolarMass_kg_per_mol / kAvogadro_per_mol * (1.0 - kLightnessOfWater * std::min(water, 1.0));
  }

  double lower_km_;
  double thickness_km_;
  double ground_height_km_;
  double lower_K_;
  double upper_K_;
  double lower_water_ = 0.0;
  double upper_water_ = 0.0;
  double fall_;
  double weight_Pa_;
  double column_per_m2_;
};

std::vector<Piece> pieces_of(const Profile& profile, double ground_height_km) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i + 1 < profile.altitude_km.size(); ++i)
    pieces.emplace_back(profile, ground_height_km, i);
  return pieces;
}

double whole_weight_per_m2(const std::vector<Piece>& pieces) {
  double whole = 0.0;
  for (const Piece& piece : pieces) whole += piece.weight_per_m2();
  return whole;
}

double mismatch_of(const std::vector<Piece>& pieces) {
  double below = 0.0;
  double largest = 0.0;
  for (const Piece& piece : pieces) {
    below += piece.column_per_m2() - piece.weight_per_m2();
    if (std::abs(below) > std::abs(largest)) largest = below;
  }
  return largest / whole_weight_per_m2(pieces);
}

// Copies a profile's levels one by one, with others in between.
class Refined {
 public:
  Refined(const Profile& sparse, const std::vector<std::string>& mixing_ratio_gases)
      : sparse_(sparse), refined_(sparse), mixing_ratio_gases_(mixing_ratio_gases) {
    refined_.altitude_km.clear();
    refined_.temperature_K.clear();
    refined_.pressure_hPa.clear();
    refined_.relative_aerosol_extinction.clear();
    for (GasProfile& gas : refined_.gases) gas.density_per_m3.clear();
  }

  void copy_level(std::size_t i) {
    add(sparse_.altitude_km[i], sparse_.temperature_K[i], sparse_.pressure_hPa[i]);
    for (std::size_t g = 0; g < refined_.gases.size(); ++g)
      refined_.gases[g].density_per_m3.push_back(sparse_.gases[g].density_per_m3[i]);
  }

  void add_level(double z, double temperature_K, double pressure_hPa) {
    add(z, temperature_K, pressure_hPa);
    const double density = 100.0 * pressure_hPa / (kBoltzmann_J_per_K * temperature_K);
    for (std::size_t g = 0; g < refined_.gases.size(); ++g)
      refined_.gases[g].density_per_m3.push_back(gas_density(sparse_.gases[g], z, density));
  }

  Profile take() { return std::move(refined_); }

 private:
  void add(double z, double temperature_K, double pressure_hPa) {
    refined_.altitude_km.push_back(z);
    refined_.temperature_K.push_back(temperature_K);
    refined_.pressure_hPa.push_back(pressure_hPa);
    if (!sparse_.relative_aerosol_extinction.empty())
      refined_.relative_aerosol_extinction.push_back(
          interpolate_by_altitude(sparse_, sparse_.relative_aerosol_extinction, z));
  }

  double gas_density(const GasProfile& gas, double z, double air_per_m3) const {
    if (std::find(mixing_ratio_gases_.begin(), mixing_ratio_gases_.end(), gas.name) ==
        mixing_ratio_gases_.end())
      return interpolate_by_altitude(sparse_, gas.density_per_m3, z);
    std::vector<double> fraction = gas.density_per_m3;
    for (std::size_t i = 0; i < fraction.size(); ++i)
      fraction[i] *= kBoltzmann_J_per_K * sparse_.temperature_K[i] / (100.0 * sparse_.pressure_hPa[i]);
    return air_per_m3 * interpolate_by_altitude(sparse_, fraction, z);
  }

  const Profile& sparse_;
  Profile refined_;
  const std::vector<std::string>& mixing_ratio_gases_;
};

struct Balanced {
  Profile profile;
  std::string ranges;  // altitudes of the pieces that were changed
};

// Adds levels in every piece that is thick or misses its weight by more than a part of the whole.
Balanced refine(const Profile& profile, const std::vector<Piece>& pieces, double negligible,
                const std::vector<std::string>& mixing_ratio_gases, const std::string& path) {
  const double whole = whole_weight_per_m2(pieces);
  Refined refined(profile, mixing_ratio_gases);
  std::string ranges;
  double changed_to_km = -1e9;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    refined.copy_level(i);
    const Piece& piece = pieces[i];
    const bool contradicts = std::abs(piece.column_per_m2() - piece.weight_per_m2()) > negligible * whole;
    if (!contradicts && !piece.is_thick()) continue;
    const double ratio = piece.temperature_ratio();
    if (!(ratio > 0.5 && ratio < 2.0)) {
      if (std::max(piece.weight_per_m2(), piece.column_per_m2()) < kPieceThatMatters * whole) continue;
      throw InputError(
          "{}: between {:g} and {:g} km the pressures ask for air {:.3g} times as warm as the temperatures "
          "say: "
          "altitudes, temperatures and pressures must belong together (units?)",
          path, piece.lower_km(), piece.upper_km(), ratio);
    }
    const double bow = piece.bow();
    double fall = 0.0;
    for (int step = 1; step < piece.steps(); ++step) {
      const double t = static_cast<double>(step) / piece.steps();
      fall += piece.fall_between(static_cast<double>(step - 1) / piece.steps(), t, bow);
      refined.add_level(piece.altitude_km(t), piece.temperature_K(t, bow),
                        profile.pressure_hPa[i] * std::exp(-fall));
    }
    if (!contradicts) continue;
    const bool goes_on = changed_to_km == piece.lower_km();
    if (goes_on) ranges.erase(ranges.rfind('-'));
    if (!goes_on) ranges += fmt::format("{}{:g}", ranges.empty() ? "" : ", ", piece.lower_km());
    ranges += fmt::format("-{:g}", piece.upper_km());
    changed_to_km = piece.upper_km();
  }
  refined.copy_level(pieces.size());
  return {refined.take(), ranges};
}

}  // namespace

double hydrostatic_mismatch(const Profile& profile, double ground_height_km) {
  return mismatch_of(pieces_of(profile, ground_height_km));
}

void balance(Profile& profile, double ground_height_km, const std::vector<std::string>& mixing_ratio_gases,
             const std::string& path) {
  const std::vector<Piece> pieces = pieces_of(profile, ground_height_km);
  const double mismatch = mismatch_of(pieces);
  if (std::abs(mismatch) <= kTolerance) {
    if (std::any_of(pieces.begin(), pieces.end(), [](const Piece& piece) { return piece.is_thick(); }))
      profile = refine(profile, pieces, kTolerance, mixing_ratio_gases, path).profile;
    return;
  }
  Balanced balanced = refine(profile, pieces, kNegligiblePiece, mixing_ratio_gases, path);
  // Many thin pieces, each of which misses little, may miss much together.
  if (std::abs(hydrostatic_mismatch(balanced.profile, ground_height_km)) > kTolerance)
    balanced = refine(profile, pieces, 0.0, mixing_ratio_gases, path);
  profile = std::move(balanced.profile);
  profile.notes.push_back(fmt::format(
      "its temperatures and pressures contradict the weight of the air ({:+.1f} % of the column): "
      "between the levels at {} km temperatures follow from the pressures",
      100.0 * mismatch, balanced.ranges));
}

}  // namespace skylut
