#include "skylut/forms/sky_source.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "skylut/core/context.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/suggestion.hpp"
#include "skylut/models/model_file.hpp"
#include "skylut/models/registry.hpp"
#include "skylut/profile/profile.hpp"

namespace skylut {

namespace fs = std::filesystem;

namespace {

// The files that a table was read from.
std::vector<fs::path> files_of_table(const fs::path& path, const Table& table) {
  std::error_code ignored;
  const fs::path csv = fs::is_directory(path, ignored) ? path / "table.csv" : path;
  if (!table.provenance()) return {csv};
  return {csv, csv.parent_path() / "table.json"};
}

}  // namespace

SkySource SkySource::open(const std::string& text, const TableModelOptions& options) {
  SkySource source;
  const fs::path path(text);
  std::error_code ignored;
  if (!fs::exists(path, ignored)) {
    const std::vector<std::string> names = sky_model_names();
    if (std::find(names.begin(), names.end(), text) == names.end())
      throw InputError("'{}': must be the folder or table.csv of a table, a model file, or one of {}{}", text,
                       fmt::join(names, ", "), suggested(text, names));
    source.model_ = make_sky_model(text);
  } else if (fs::is_directory(path, ignored) || !(is_model_file(path) || path.extension() == ".json")) {
    auto table = std::make_unique<const TableModel>(Table::read(path), options);
    source.table_ = table.get();
    source.model_ = std::move(table);
    source.files_ = files_of_table(path, source.table_->table());
  } else {
    source.model_ = read_model_file(path);
    source.files_ = {path};
  }
  return source;
}

std::optional<double> SkySource::albedo_made_with() const {
  if (table_ == nullptr || !table_->table().provenance()) return {};
  return table_->table().provenance()->ground_albedo;
}

Range SkySource::view_zenith_deg(const SkyConditions& conditions) const {
  return table_ != nullptr ? table_->view_zenith_deg(conditions) : model_->info().view_zenith_deg;
}

Turbidity SkySource::in_own_kind(const Context& context, const Turbidity& turbidity) const {
  if (table_ != nullptr) return table_->table().in_own_kind(context, turbidity);
  const TurbidityKind kind = model_->info().turbidity_kind;
  if (turbidity.kind == kind) return turbidity;
  const Atmosphere air(context, load_profile(context, "ussa1976"), {});
  return {kind, from_aod500(to_aod500(turbidity, air), kind, air)};
}

std::string SkySource::conversion_source() const {
  if (table_ != nullptr && table_->table().provenance()) return "as table.json converts it";
  return "in the 1976 standard atmosphere";
}

std::unique_ptr<const SkyModel> open_sky_source(const std::string& source) {
  return SkySource::open(source).release();
}

}  // namespace skylut
