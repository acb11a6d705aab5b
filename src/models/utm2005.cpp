#include "skylut/models/utm2005.hpp"

#include "skylut/core/context.hpp"
#include "skylut/core/csv.hpp"

namespace skylut {

std::string Utm2005Verdict::text() const {
  std::string text;
  const auto append = [&text](bool failed, const char* name) {
    if (!failed) return;
    if (!text.empty()) text += '+';
    text += name;
  };
  append(impossible_chromaticity, "chromaticity");
  append(infinite_horizon, "horizon");
  append(mirror_differs, "mirror");
  append(dark_zenith, "dark");
  return text.empty() ? "plausible" : text;
}

std::vector<Utm2005Row> load_utm2005(const Context& context) {
  const CsvTable csv = CsvTable::read(context.data_file("reference/utm2005_appendix_a.csv"));
  std::vector<Utm2005Row> rows;
  for (std::size_t i = 0; i < csv.rows(); ++i) {
    const auto value = [&](const char* name) { return csv.number(i, csv.column(name)); };
    rows.push_back({.altitude_km = value("altitude_km"),
                    .turbidity = value("turbidity"),
                    .sun = {value("sun_zenith_deg"), value("sun_azimuth_deg")},
                    .coefficients = {value("A"), value("B"), value("C"), value("D"), value("E")},
                    .zenith = {value("Y_zenith"), value("x_zenith"), value("y_zenith")}});
  }
  return rows;
}

std::vector<Utm2005Verdict> judge_utm2005(const std::vector<Utm2005Row>& rows,
                                          const ColourMatching& matching) {
  std::vector<Utm2005Verdict> verdicts;
  for (const Utm2005Row& row : rows) {
    Utm2005Verdict verdict{
        .impossible_chromaticity = !matching.inside_spectral_locus(row.zenith.x, row.zenith.y),
        .infinite_horizon = row.coefficients.B > 0.0,
        .mirror_differs = false,
        .dark_zenith = !(row.zenith.Y > 0.0)};
    for (const Utm2005Row& other : rows) {
      // Suns at azimuths 90° and 270°: the same sky mirrored.
      const bool mirror = other.altitude_km == row.altitude_km && other.turbidity == row.turbidity &&
                          other.sun.zenith_deg == row.sun.zenith_deg &&
                          other.sun.azimuth_deg == 360.0 - row.sun.azimuth_deg;
      if (mirror && (other.coefficients != row.coefficients || other.zenith != row.zenith))
        verdict.mirror_differs = true;
    }
    verdicts.push_back(verdict);
  }
  return verdicts;
}

}  // namespace skylut
