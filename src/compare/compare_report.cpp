#include "skylut/compare/compare_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "skylut/colour/cie1931.hpp"
#include "skylut/compare/metrics.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/fit/fit_sky.hpp"
#include "skylut/models/preetham1999.hpp"
#include "skylut/models/utm2005.hpp"

namespace skylut {

namespace {

using Cell = CompareReport::Cell;

// A row of a report under construction: columns come from the first row.
class RowBuilder {
 public:
  explicit RowBuilder(CompareReport& report) : report_(report), first_(report.rows.empty()) {
    report_.rows.emplace_back();
  }
  void add(const std::string& column, Cell cell) {
    if (first_) report_.columns.push_back(column);
    report_.rows.back().push_back(std::move(cell));
  }
  void add(const std::string& suffix, const PerezCoefficients& k) {
    const std::array<double, 5> values = k.values();
    for (std::size_t i = 0; i < values.size(); ++i) add(kPerezNames[i] + suffix, values[i]);
  }
  void add_blank(const std::string& suffix) {
    for (const char* name : kPerezNames) add(name + suffix, Cell{});
  }

 private:
  CompareReport& report_;
  bool first_;
};

std::string coefficient_line(const char* label, const PerezCoefficients& k) {
  return fmt::format("  {:<12} {:>12.5g} {:>12.5g} {:>12.5g} {:>12.5g} {:>12.5g}\n", label, k.A, k.B, k.C,
                     k.D, k.E);
}

std::string coefficient_heading() {
  return fmt::format("  {:<12} {:>12} {:>12} {:>12} {:>12} {:>12}\n", "", "A", "B", "C", "D", "E");
}

std::vector<Yxy> sky_of(const PerezYxy& k, const Yxy& zenith, const Direction& sun,
                        const std::vector<Direction>& views) {
  std::vector<Yxy> sky;
  for (const Direction& view : views)
    sky.push_back(perez_sky(k.Y, k.x, k.y, zenith, view.zenith_deg * kRadiansPerDegree,
                            angle_between(view, sun), sun.zenith_deg * kRadiansPerDegree));
  return sky;
}

void add_preetham_row(CompareReport& report, const TableEntry& entry, double T) {
  const PerezYxy ours{entry.Y, entry.x, entry.y};
  const PerezYxy theirs = preetham1999_coefficients(T);
  const Yxy zenith = preetham1999_zenith_kcd_m2(T, entry.sun.zenith_deg * kRadiansPerDegree);
  const bool in_range = T >= kPreethamLowestTurbidity && T <= kPreethamHighestTurbidity;
  std::string verdict = in_range ? "in range" : T < kPreethamLowestTurbidity ? "T below 2" : "T above 6";
  std::optional<SkyDifference> distance;
  const bool finite_horizon = theirs.Y.B < 0.0;
  if (zenith.Y > 0.0 && finite_horizon) {
    const std::vector<Direction> views = directions_utm271();
    const std::vector<Yxy> reference = sky_of(theirs, zenith, entry.sun, views);
    if (std::all_of(reference.begin(), reference.end(), [](const Yxy& colour) { return colour.Y > 0.0; }))
      distance = difference(sky_of(ours, entry.zenith, entry.sun, views), reference);
  }
  if (!finite_horizon)
    verdict += ", Preetham's B > 0: infinite at the horizon";
  else if (!distance)
    verdict += ", Preetham's luminance not positive";

  RowBuilder row(report);
  row.add("turbidity", entry.turbidity);
  row.add("preetham_t", T);
  row.add("sun_zenith_deg", entry.sun.zenith_deg);
  row.add("sun_azimuth_deg", entry.sun.azimuth_deg);
  row.add("range", verdict);
  row.add("Y_zenith_kcd_m2", entry.zenith.Y);
  row.add("x_zenith", entry.zenith.x);
  row.add("y_zenith", entry.zenith.y);
  row.add("Y_zenith_kcd_m2_preetham", zenith.Y);
  row.add("x_zenith_preetham", zenith.x);
  row.add("y_zenith_preetham", zenith.y);
  const auto metric = [&](double SkyDifference::*field) {
    return distance ? Cell((*distance).*field) : Cell{};
  };
  row.add("rmse_Y_rel", metric(&SkyDifference::rmse_Y_rel));
  row.add("mean_Y_rel", metric(&SkyDifference::mean_Y_rel));
  row.add("rmse_x", metric(&SkyDifference::rmse_x));
  row.add("rmse_y", metric(&SkyDifference::rmse_y));
  row.add("_Y", ours.Y);
  row.add("_Y_preetham", theirs.Y);
  row.add("_x", ours.x);
  row.add("_x_preetham", theirs.x);
  row.add("_y", ours.y);
  row.add("_y_preetham", theirs.y);

  std::string block =
      fmt::format("turbidity {:g} (T = {:.3f}, {}), sun zenith angle {:g} deg, azimuth {:g} deg\n",
                  entry.turbidity, T, verdict, entry.sun.zenith_deg, entry.sun.azimuth_deg);
  block += fmt::format("  zenith       ours     Y {:8.4f} kcd/m2  x {:.4f}  y {:.4f}\n", entry.zenith.Y,
                       entry.zenith.x, entry.zenith.y);
  block += fmt::format("               Preetham Y {:8.4f} kcd/m2  x {:.4f}  y {:.4f}\n", zenith.Y, zenith.x,
                       zenith.y);
  if (distance)
    block += fmt::format("  dome         RMSE Y {:.1f} % (mean {:+.1f} %), x {:.4f}, y {:.4f}\n",
                         100.0 * distance->rmse_Y_rel, 100.0 * distance->mean_Y_rel, distance->rmse_x,
                         distance->rmse_y);
  block += coefficient_heading();
  block += coefficient_line("Y ours", ours.Y) + coefficient_line("Y Preetham", theirs.Y);
  block += coefficient_line("x ours", ours.x) + coefficient_line("x Preetham", theirs.x);
  block += coefficient_line("y ours", ours.y) + coefficient_line("y Preetham", theirs.y);
  report.blocks.push_back(std::move(block));
}

void add_utm_row(CompareReport& report, const Utm2005Row& published, const Utm2005Verdict& verdict,
                 const TableEntry* ours) {
  RowBuilder row(report);
  row.add("altitude_km", published.altitude_km);
  row.add("turbidity", published.turbidity);
  row.add("sun_zenith_deg", published.sun.zenith_deg);
  row.add("sun_azimuth_deg", published.sun.azimuth_deg);
  row.add("verdict", verdict.text());
  row.add("Y_zenith_utm2005", published.zenith.Y);
  row.add("x_zenith_utm2005", published.zenith.x);
  row.add("y_zenith_utm2005", published.zenith.y);
  row.add("Y_zenith_kcd_m2", ours ? Cell(ours->zenith.Y) : Cell{});
  row.add("x_zenith", ours ? Cell(ours->zenith.x) : Cell{});
  row.add("y_zenith", ours ? Cell(ours->zenith.y) : Cell{});
  row.add("_utm2005", published.coefficients);
  const std::pair<const char*, PerezCoefficients TableEntry::*> channels[] = {
      {"_Y", &TableEntry::Y}, {"_x", &TableEntry::x}, {"_y", &TableEntry::y}};
  for (const auto& [suffix, channel] : channels)
    ours ? row.add(suffix, ours->*channel) : row.add_blank(suffix);

  std::string block =
      fmt::format("{:g} km, turbidity {:g}, sun {:g},{:g} deg: {}\n", published.altitude_km,
                  published.turbidity, published.sun.zenith_deg, published.sun.azimuth_deg, verdict.text());
  block += fmt::format("  zenith       published Y {:8.3f} (no unit)  x {:.4f}  y {:.4f}\n",
                       published.zenith.Y, published.zenith.x, published.zenith.y);
  if (ours)
    block += fmt::format("               ours      Y {:8.4f} kcd/m2    x {:.4f}  y {:.4f}\n", ours->zenith.Y,
                         ours->zenith.x, ours->zenith.y);
  block += coefficient_heading() + coefficient_line("published", published.coefficients);
  if (ours)
    block += coefficient_line("ours Y", ours->Y) + coefficient_line("ours x", ours->x) +
             coefficient_line("ours y", ours->y);
  else
    block += "  the table has no such row\n";
  report.blocks.push_back(std::move(block));
}

std::string cell_text(const Cell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) return fmt::format("{}", *number);
  if (const auto* text = std::get_if<std::string>(&cell)) {
    const bool quoted = text->find(',') != std::string::npos;
    return quoted ? '"' + *text + '"' : *text;
  }
  return {};
}

template <class Texts>
std::string comma_line(const Texts& texts) {
  return fmt::format("{}\n", fmt::join(texts, ","));
}

}  // namespace

std::string CompareReport::text() const {
  std::string text;
  for (const std::string& note : notes) text += note + "\n";
  for (const std::string& block : blocks) text += "\n" + block;
  return text;
}

std::string CompareReport::csv() const {
  std::string text;
  for (const std::string& note : notes) text += "# " + note + "\n";
  text += comma_line(columns);
  for (const auto& row : rows) {
    std::vector<std::string> cells;
    for (const Cell& cell : row) cells.push_back(cell_text(cell));
    text += comma_line(cells);
  }
  return text;
}

std::string CompareReport::json() const {
  using Json = nlohmann::ordered_json;
  Json all = Json::array();
  for (const auto& row : rows) {
    Json one = Json::object();
    for (std::size_t i = 0; i < row.size(); ++i) {
      Json& value = one[columns[i]];
      if (const auto* number = std::get_if<double>(&row[i])) value = *number;
      if (const auto* text = std::get_if<std::string>(&row[i])) value = *text;
    }
    all.push_back(one);
  }
  const Json file = {{"format", "skylut comparison"},
                     {"format_version", 1},
                     {"against", name},
                     {"notes", notes},
                     {"rows", all}};
  return file.dump(1) + "\n";
}

CompareReport compare_with_preetham1999(std::span<const TableEntry> entries,
                                        const TableTurbidity& turbidity) {
  CompareReport report;
  report.name = "preetham1999";
  report.notes = {
      "Preetham, Shirley, Smits 1999 beside the rows at 0 km; T " + turbidity.source(),
      "Preetham fitted T = 2 to 6; differences are ours minus theirs over 271 directions, Y relative to "
      "theirs"};
  std::size_t below_horizon = 0;
  for (const TableEntry& entry : entries) {
    if (entry.altitude_km != 0.0) continue;
    if (entry.sun.zenith_deg > 90.0) {
      ++below_horizon;
      continue;
    }
    add_preetham_row(report, entry, turbidity.preetham_t(entry.turbidity));
  }
  if (report.rows.empty())
    throw InputError(
        "table of {} rows: none at altitude 0 km with the sun above the horizon, must have at least one",
        entries.size());
  if (below_horizon > 0)
    report.notes.push_back(fmt::format("{} rows with the sun below the horizon left out", below_horizon));
  return report;
}

CompareReport compare_with_utm2005(const Context& context, std::span<const TableEntry> entries) {
  const std::vector<Utm2005Row> rows = load_utm2005(context);
  const std::vector<Utm2005Verdict> verdicts = judge_utm2005(rows, ColourMatching::load(context));
  CompareReport report;
  report.name = "utm2005";
  const auto count = [&](bool Utm2005Verdict::*failure) {
    return std::count_if(verdicts.begin(), verdicts.end(),
                         [&](const Utm2005Verdict& v) { return v.*failure; });
  };
  const auto plausible =
      std::count_if(verdicts.begin(), verdicts.end(), [](const Utm2005Verdict& v) { return v.plausible(); });
  report.notes = {
      fmt::format("UTM report 2005, appendix A: {} of its 75 rows are legible, {} of them plausible",
                  rows.size(), plausible),
      fmt::format("chromaticity: {} rows, zenith x, y that no light can have",
                  count(&Utm2005Verdict::impossible_chromaticity)),
      fmt::format("horizon: {} rows, B > 0, infinite at the horizon",
                  count(&Utm2005Verdict::infinite_horizon)),
      fmt::format("mirror: {} rows, not equal to the row of the mirrored sun",
                  count(&Utm2005Verdict::mirror_differs))};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto ours = std::find_if(entries.begin(), entries.end(), [&](const TableEntry& entry) {
      return entry.altitude_km == rows[i].altitude_km && entry.turbidity == rows[i].turbidity &&
             entry.sun == rows[i].sun;
    });
    add_utm_row(report, rows[i], verdicts[i], ours == entries.end() ? nullptr : &*ours);
  }
  return report;
}

}  // namespace skylut
