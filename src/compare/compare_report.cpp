#include "skylut/compare/compare_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

namespace skylut {

namespace {

using Cell = CompareRow::Cell;

std::string cell_text(const Cell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) return fmt::format("{}", *number);
  if (const auto* text = std::get_if<std::string>(&cell)) {
    const bool quoted = text->find(',') != std::string::npos;
    return quoted ? '"' + *text + '"' : *text;
  }
  return {};
}

template <class Value, class Member>
Cell cell(const std::optional<Value>& value, Member member) {
  return value ? Cell((*value).*member) : Cell{};
}

std::string zenith_text(const ComparedSky& sky) {
  if (!sky.zenith) return fmt::format("  zenith       {:<14} none\n", sky.label);
  return fmt::format("  zenith       {:<14} Y {:8.4f} {:<9} x {:.4f}  y {:.4f}\n", sky.label, sky.zenith->Y,
                     sky.unit.empty() ? "(no unit)" : "kcd/m2", sky.zenith->x, sky.zenith->y);
}

// The channels of the first sky, each beside the same channel of the others.
std::string coefficients_text(const std::vector<ComparedSky>& skies) {
  std::string lines;
  std::size_t most = 0;
  for (const ComparedSky& sky : skies) most = std::max(most, sky.coefficients.size());
  for (std::size_t channel = 0; channel < most; ++channel)
    for (const ComparedSky& sky : skies) {
      if (channel >= sky.coefficients.size() || !sky.coefficients[channel].second) continue;
      const auto& [name, k] = sky.coefficients[channel];
      lines += fmt::format("  {:<1} {:<14} {:>12.5g} {:>12.5g} {:>12.5g} {:>12.5g} {:>12.5g}\n", name,
                           sky.label, k->A, k->B, k->C, k->D, k->E);
    }
  if (lines.empty()) return {};
  return fmt::format("  {:<16} {:>12} {:>12} {:>12} {:>12} {:>12}\n", "", "A", "B", "C", "D", "E") + lines;
}

}  // namespace

std::vector<std::pair<std::string, Cell>> CompareRow::cells() const {
  std::vector<std::pair<std::string, Cell>> cells = facts;
  for (const ComparedSky& sky : skies) {
    const std::string unit = sky.unit.empty() ? "" : "_" + sky.unit;
    cells.emplace_back("Y_zenith" + unit + sky.suffix, cell(sky.zenith, &Yxy::Y));
    cells.emplace_back("x_zenith" + sky.suffix, cell(sky.zenith, &Yxy::x));
    cells.emplace_back("y_zenith" + sky.suffix, cell(sky.zenith, &Yxy::y));
  }
  if (has_difference) {
    cells.emplace_back("rmse_Y_rel", cell(difference, &SkyDifference::rmse_Y_rel));
    cells.emplace_back("mean_Y_rel", cell(difference, &SkyDifference::mean_Y_rel));
    cells.emplace_back("rmse_x", cell(difference, &SkyDifference::rmse_x));
    cells.emplace_back("rmse_y", cell(difference, &SkyDifference::rmse_y));
  }
  for (const ComparedSky& sky : skies)
    for (const auto& [channel, k] : sky.coefficients)
      for (std::size_t i = 0; i < kPerezNames.size(); ++i)
        cells.emplace_back(kPerezNames[i] + (channel.empty() ? "" : "_" + channel) + sky.suffix,
                           k ? Cell(k->values()[i]) : Cell{});
  return cells;
}

std::string CompareRow::text() const {
  std::string text;
  for (const auto& [name, value] : facts) {
    if (!text.empty()) text += ", ";
    const auto* number = std::get_if<double>(&value);
    text += number ? fmt::format("{} {:.6g}", name, *number)
                   : fmt::format("{}: {}", name, std::get<std::string>(value));
  }
  text += "\n";
  for (const ComparedSky& sky : skies) text += zenith_text(sky);
  if (difference)
    text += fmt::format("  dome         RMSE Y {:.1f} % (mean {:+.1f} %), x {:.4f}, y {:.4f}\n",
                        100.0 * difference->rmse_Y_rel, 100.0 * difference->mean_Y_rel, difference->rmse_x,
                        difference->rmse_y);
  return text + coefficients_text(skies);
}

std::string CompareReport::text() const {
  std::string text;
  for (const std::string& note : notes) text += note + "\n";
  for (const CompareRow& row : rows) text += fmt::format("\n{}", row.text());
  return text;
}

std::string CompareReport::csv(const Provenance& provenance) const {
  std::string text;
  for (const std::string& note : notes) text += fmt::format("# {}\n", note);
  text += provenance.comment_lines();
  bool first = true;
  for (const CompareRow& row : rows) {
    std::vector<std::string> columns;
    std::vector<std::string> values;
    for (const auto& [column, value] : row.cells()) {
      columns.push_back(column);
      values.push_back(cell_text(value));
    }
    if (first) text += fmt::format("{}\n", fmt::join(columns, ","));
    first = false;
    text += fmt::format("{}\n", fmt::join(values, ","));
  }
  return text;
}

std::string CompareReport::json(const Provenance& provenance) const {
  using Json = nlohmann::ordered_json;
  Json all = Json::array();
  for (const CompareRow& row : rows) {
    Json one = Json::object();
    for (const auto& [column, cell] : row.cells()) {
      Json& value = one[column];
      if (const auto* number = std::get_if<double>(&cell)) value = *number;
      if (const auto* text = std::get_if<std::string>(&cell)) value = *text;
    }
    all.push_back(one);
  }
  Json file{{"format", "skylut comparison"}, {"format_version", 1}};
  const Json how = provenance.json();
  for (const auto& [key, value] : how.items()) file[key] = value;
  file["against"] = name;
  file["notes"] = notes;
  file["rows"] = std::move(all);
  return file.dump(1) + "\n";
}

}  // namespace skylut
