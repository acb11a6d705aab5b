#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "skylut/forms/sky_supply.hpp"

namespace skylut::test {

/// A supply whose skies a model gives: what a form fitted to them must find is known.
class ModelSkies final : public SkySupply {
 public:
  ModelSkies(std::shared_ptr<const SkyModel> model, SkyAxes axes)
      : model_(std::move(model)), axes_(std::move(axes)) {}

  const SkyAxes& axes() const override { return axes_; }
  const WavelengthGrid* wavelengths() const override { return nullptr; }
  bool simulates() const override { return true; }
  std::optional<double> albedo() const override { return std::nullopt; }

  std::vector<TrainingSky> given(const Context& context, const ViewsUnderSun& views) const override {
    std::vector<SoughtSky> skies;
    for (const double altitude_km : axes_.altitudes_km)
      for (const double turbidity : axes_.turbidities)
        for (const double sun_deg : axes_.sun_zeniths_deg)
          skies.push_back({altitude_km, {axes_.turbidity_kind, turbidity}, {}, {sun_deg, 0.0}});
    return simulated(context, skies, views);
  }

  std::vector<TrainingSky> simulated(const Context&, std::span<const SoughtSky> requests,
                                     const ViewsUnderSun& views) const override {
    std::vector<TrainingSky> skies;
    for (const SoughtSky& request : requests) {
      TrainingSky& sky = skies.emplace_back(TrainingSky{request, views(request.sun), {}, {}});
      sky.colours.resize(sky.dome.views.size());
      model_->at({request.altitude_km, request.turbidity, request.albedo.value_or(0.2), request.sun})
          ->colour(sky.dome.views, sky.colours);
    }
    return skies;
  }

 private:
  std::shared_ptr<const SkyModel> model_;
  SkyAxes axes_;
};

}  // namespace skylut::test
