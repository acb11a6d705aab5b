#include <algorithm>
#include <cmath>

#include "channel_samples.hpp"
#include "form_list.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/context.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/parallel.hpp"
#include "skylut/fit/fit_perez.hpp"
#include "skylut/models/perez_rows_model.hpp"

namespace skylut {

namespace {

using forms_detail::band_channels;
using forms_detail::channel_values;

std::size_t zenith_view(const TrainingSky& sky) {
  constexpr double kZenith_deg = 1e-6;
  for (std::size_t i = 0; i < sky.dome.views.size(); ++i)
    if (sky.dome.views[i].zenith_deg <= kZenith_deg) return i;
  throw InputError(
      "sky at altitude {} km under the sun at {}: no zenith: one direction must have zenith angle 0",
      sky.conditions.altitude_km, sky.conditions.sun.zenith_deg);
}

PerezRow fitted_row(const TrainingSky& sky, const SkyChannels& channels, const WavelengthGrid* wavelengths) {
  PerezRow row{.altitude_km = sky.conditions.altitude_km,
               .turbidity = sky.conditions.turbidity.value,
               .sun_zenith_deg = sky.conditions.sun.zenith_deg,
               .coefficients = {},
               .zenith = {}};
  const std::vector<double> values = channel_values(sky, channels, wavelengths);
  const std::size_t zenith = zenith_view(sky);
  for (std::size_t channel = 0; channel < channels.size(); ++channel) {
    std::vector<SkySample> samples;
    for (std::size_t i = 0; i < sky.dome.views.size(); ++i)
      samples.push_back({sky.dome.views[i].zenith_deg * kRadiansPerDegree,
                         angle_between(sky.dome.views[i], sky.conditions.sun),
                         values[i * channels.size() + channel], fit_weight(sky.dome, i)});
    FitOptions options;
    options.residual = channels.is_light(channel) ? ResidualKind::relative : ResidualKind::absolute;
    const double zenith_value = values[zenith * channels.size() + channel];
    const FitReport report =
        fit_perez(samples, sky.conditions.sun.zenith_deg * kRadiansPerDegree, zenith_value, options);
    row.coefficients.push_back(report.coefficients);
    row.zenith.push_back(zenith_value);
  }
  return row;
}

Range range_of(std::span<const TrainingSky> skies, const char* unit, double (*value)(const TrainingSky&)) {
  Range range{value(skies.front()), value(skies.front()), unit};
  for (const TrainingSky& sky : skies) {
    range.lowest = std::min(range.lowest, value(sky));
    range.highest = std::max(range.highest, value(sky));
  }
  return range;
}

// The form with the axes of its skies as its domain.
ModelInfo info_of(std::span<const TrainingSky> skies, const SkyChannels& channels) {
  ModelInfo info;
  info.title = "Perez, Seals, Michalsky 1993, one formula per sky and channel";
  info.quantities = channels.quantities();
  info.altitude_km = range_of(skies, "km", [](const TrainingSky& sky) { return sky.conditions.altitude_km; });
  info.turbidity_kind = skies.front().conditions.turbidity.kind;
  info.turbidity = range_of(skies, "", [](const TrainingSky& sky) { return sky.conditions.turbidity.value; });
  info.sun_zenith_deg =
      range_of(skies, "deg", [](const TrainingSky& sky) { return sky.conditions.sun.zenith_deg; });
  info.view_zenith_deg = {0.0, 90.0, "deg"};
  return info;
}

}  // namespace

const char* PerezRowsForm::name() const { return channels_ == Channels::colour ? "perez" : "perez-spectral"; }

const char* PerezRowsForm::summary() const {
  return channels_ == Channels::colour ? "Perez: five coefficients for Y, x and y of each sky"
                                       : "Perez: five coefficients for each band of each sky";
}

ModelFile PerezRowsForm::fit(const Context& context, const SkySupply& supply,
                             const FormOptions& options) const {
  const std::vector<TrainingSky> skies = supply.given(context, fitting_views);
  SkyChannels channels;
  if (channels_ == Channels::bands) channels = band_channels(context, supply, options.bands, skies);
  std::vector<PerezRow> rows(skies.size());
  parallel_for(skies.size(), context.threads,
               [&](std::size_t i) { rows[i] = fitted_row(skies[i], channels, supply.wavelengths()); });
  return {.form = name(),
          .info = info_of(skies, channels),
          .error = {},
          .model = PerezRowsModel::json(channels, rows)};
}

std::vector<SoughtSky> PerezRowsForm::held_out(const SkySupply& supply, const ModelFile& fitted) const {
  const std::unique_ptr<const SkyModel> model = make_model(fitted);
  if (dynamic_cast<const PerezRowsModel&>(*model).fills_a_grid() &&
      dynamic_cast<const PerezRowsModel&>(*model).rows().size() > 1)
    return Form::held_out(supply, fitted);
  std::vector<SoughtSky> requests;
  for (const PerezRow& row : dynamic_cast<const PerezRowsModel&>(*model).rows())
    requests.push_back(
        {row.altitude_km, {fitted.info.turbidity_kind, row.turbidity}, {}, {row.sun_zenith_deg, 0.0}});
  return requests;
}

}  // namespace skylut
