#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "skylut/models/sky_model.hpp"
#include "skylut/table/table_model.hpp"

namespace skylut {

struct Context;

/// Whatever gives skies for conditions: the folder or table.csv of a table, a model file of skylut fit, or a
/// published model by its name.
class SkySource {
 public:
  /// @param options  for a table
  /// @throws InputError  as Table::read and read_model_file; for a text that is none of the three
  static SkySource open(const std::string& source, const TableModelOptions& options = {});

  const SkyModel& model() const { return *model_; }
  /// The table, if it is one.
  const TableModel* table() const { return table_; }
  /// What it was read from; nothing of a published model.
  const std::vector<std::filesystem::path>& files() const { return files_; }
  /// The ground's albedo that it was made with, where it has no axis of albedo and says so.
  std::optional<double> albedo_made_with() const;

  /// The views that the sky of some conditions has light for.
  Range view_zenith_deg(const SkyConditions& conditions) const;

  /// A turbidity of any kind in the model's: as Table::in_own_kind; for other models in the 1976 standard
  /// atmosphere with the haze of AerosolOptics{}.
  Turbidity in_own_kind(const Context& context, const Turbidity& turbidity) const;
  /// Where that takes its numbers from.
  std::string conversion_source() const;

  std::unique_ptr<const SkyModel> release() && { return std::move(model_); }

 private:
  std::unique_ptr<const SkyModel> model_;
  const TableModel* table_ = nullptr;
  std::vector<std::filesystem::path> files_;
};

/// The model of SkySource::open alone.
std::unique_ptr<const SkyModel> open_sky_source(const std::string& source);

}  // namespace skylut
