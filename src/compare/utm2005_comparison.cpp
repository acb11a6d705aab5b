#include <fmt/format.h>

#include <algorithm>

#include "compared_entry.hpp"
#include "skylut/colour/cie1931.hpp"
#include "skylut/compare/comparisons.hpp"
#include "skylut/models/utm2005.hpp"

namespace skylut {

namespace {

std::vector<std::string> notes_of(const std::vector<Utm2005Verdict>& verdicts) {
  const auto count = [&](bool Utm2005Verdict::*failure) {
    return std::count_if(verdicts.begin(), verdicts.end(),
                         [&](const Utm2005Verdict& v) { return v.*failure; });
  };
  const auto plausible =
      std::count_if(verdicts.begin(), verdicts.end(), [](const Utm2005Verdict& v) { return v.plausible(); });
  return {fmt::format("UTM report 2005, appendix A: {} of its 75 rows are legible, {} of them plausible",
                      verdicts.size(), plausible),
          fmt::format("chromaticity: {} rows, zenith x, y that no light can have",
                      count(&Utm2005Verdict::impossible_chromaticity)),
          fmt::format("horizon: {} rows, B > 0, infinite at the horizon",
                      count(&Utm2005Verdict::infinite_horizon)),
          fmt::format("mirror: {} rows, not equal to the row of the mirrored sun",
                      count(&Utm2005Verdict::mirror_differs))};
}

}  // namespace

CompareReport compare_with_utm2005(const Context& context, const Table& table) {
  const std::vector<Utm2005Row> published = load_utm2005(context);
  const std::vector<Utm2005Verdict> verdicts = judge_utm2005(published, ColourMatching::load(context));
  CompareReport report;
  report.name = "utm2005";
  report.notes = notes_of(verdicts);
  for (std::size_t i = 0; i < published.size(); ++i) {
    const Utm2005Row& theirs = published[i];
    CompareRow row;
    row.facts = {{"altitude_km", theirs.altitude_km},
                 {"turbidity", theirs.turbidity},
                 {"sun_zenith_deg", theirs.sun.zenith_deg},
                 {"sun_azimuth_deg", theirs.sun.azimuth_deg},
                 {"verdict", verdicts[i].text()}};
    row.skies = {{"published", "_utm2005", "", theirs.zenith, {{"", theirs.coefficients}}},
                 our_sky(table.find(theirs.altitude_km, theirs.turbidity, theirs.sun))};
    report.rows.push_back(std::move(row));
  }
  return report;
}

}  // namespace skylut
