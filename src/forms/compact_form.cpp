#include "skylut/forms/compact_form.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "compact/held_out.hpp"
#include "compact/tensor_compression.hpp"
#include "compact/training_fields.hpp"
#include "compact/training_spectrum.hpp"
#include "form_list.hpp"
#include "skylut/core/context.hpp"
#include "skylut/core/domain.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/models/compact_sky.hpp"

namespace skylut {

namespace {

using namespace compact;

constexpr Range kError{5e-4, 0.02, ""};
/// Of the features that compression may leave, per error of luminance: measured on skies by day.
constexpr double kTolerancePerError = 6.0;
constexpr Range kMostAod{0.1, 5.0, ""};
constexpr std::size_t kHazeTerms = 5;
constexpr ZenithGrid::Counts kZenithNodes{14, 12, 8};
/// Of the stratosphere, where the aerosol has none of its own.
constexpr double kLeastAod = 1e-3;
/// As a factor of the one before it: loads that lie closer are left out.
constexpr double kClosest = 1.3;

/// Close where haze lies and where the sun sets; chosen by what halving each did to held-out skies.
Nodes nodes_of(double least_aod500, double most_aod500) {
  Nodes nodes;
  nodes.altitudes_km = {0.0, 0.2, 0.5,  1.0,  1.5,  2.0,  2.75, 3.75, 5.0,
                        7.0, 9.5, 12.0, 14.5, 17.0, 20.0, 23.0, 26.5, 30.0};
  nodes.suns_deg = {0.0,  18.0, 36.0, 50.0, 61.0, 70.0, 76.0, 80.0, 83.0, 85.0, 86.5, 88.0, 89.0, 89.5,
                    90.0, 90.5, 91.0, 91.5, 92.0, 92.5, 93.0, 93.5, 94.0, 94.5, 95.0, 95.5, 96.0};
  nodes.aod500 = {0.0, least_aod500};
  for (const double load :
       {0.005, 0.0115, 0.0225, 0.041, 0.071, 0.12, 0.2, 0.33, 0.52, 0.75, 1.0, 1.35, 1.8, 2.4, 3.2, 4.1})
    if (load > kClosest * least_aod500 && kClosest * load < most_aod500) nodes.aod500.push_back(load);
  nodes.aod500.push_back(most_aod500);
  return nodes;
}

ModelInfo info_of(const CompactFormOptions& options) {
  return {.name = "skylut",
          .title = "skylut's compact sky",
          .source = "skylut",
          .quantities = options.bands ? "Y, x, y, spectra" : "Y, x, y",
          .altitude_km = domain::kObserver_km,
          .turbidity_kind = TurbidityKind::aod500,
          .turbidity = {0.0, options.most_aod500, ""},
          .albedo = domain::kAlbedo,
          .sun_zenith_deg = {0.0, 96.0, "deg"},  // the last of its nodes
          .view_zenith_deg = domain::kAnyZenith_deg};
}

}  // namespace

ModelFile fit_compact_sky(const Context& context, const SkyScene& scene, const CompactFormOptions& options,
                          const TransferOptions& transfer) {
  require_within("error of the form", options.error, kError);
  require_within("largest aod500 of the form", options.most_aod500, kMostAod);
  const AerosolShape& shape = scene.atmosphere->aerosol().shape;
  const double least = shape.stratospheric_aod500 > 0.0 ? shape.stratospheric_aod500 : kLeastAod;
  const TrainingSpectrum spectrum(context, scene, options.bands ? &*options.bands : nullptr, transfer);
  const TrainingFields fields = training_fields(
      context, scene, spectrum, nodes_of(least, options.most_aod500), kZenithNodes, kHazeTerms, transfer);
  Tables tables;
  tables.nodes = fields.nodes;
  tables.planet_radius_km = fields.planet_radius_km;
  tables.zenith_counts = kZenithNodes;
  tables.channels = {"X", "Y", "Z"};
  if (options.bands) tables.wavelengths_nm = options.bands->values_nm();
  for (const double wavelength_nm : tables.wavelengths_nm)
    tables.channels.push_back(std::to_string(wavelength_nm));
  tables.terms = kHazeTerms;
  tables.haze_terms = fields.haze->functions();
  tables.haze_mean = fields.haze->mean();
  tables.rayleigh_0 = fields.rayleigh_0;
  tables.rayleigh_90 = fields.rayleigh_90;
  tables.spherical_albedo = fields.spherical_albedo;
  compress(fields, kTolerancePerError * options.error, tables);

  ModelFile file{.form = "skylut", .info = info_of(options), .error = {}, .model = tables_json(tables)};
  // As read back, rounding included.
  const JsonReader written(file.model, "model");
  const CompactSkyModel model(file.info, read_tables(written));
  file.error = held_out_error(context, scene, model, options.held_out, transfer);
  file.error["of_colour_wavelengths"] = spectrum.colour_error();
  file.error["aimed_at"] = options.error;
  return file;
}

ModelFile CompactForm::fit(const Context& context, const SkySupply& supply,
                           const FormOptions& options) const {
  const std::optional<SkySupply::Air> air = supply.air();
  if (!air) throw InputError("form skylut of maps: must be a table folder, whose air it simulates");
  CompactFormOptions own;
  own.error = options.error;
  if (options.spectral) own.bands = options.bands;
  for (const double value : supply.axes().turbidities)
    own.most_aod500 =
        std::max(own.most_aod500, to_aod500({supply.axes().turbidity_kind, value}, *air->scene.atmosphere));
  return fit_compact_sky(context, air->scene, own, air->options);
}

}  // namespace skylut
