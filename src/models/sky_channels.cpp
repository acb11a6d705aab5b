#include "skylut/models/sky_channels.hpp"

#include <fmt/format.h>

#include "skylut/core/check.hpp"

namespace skylut {

namespace {

using nlohmann::ordered_json;

constexpr const char* kYxy = "Yxy";
constexpr const char* kXyz = "XYZ";
constexpr const char* kBands = "bands";

}  // namespace

Yxy SkyChannels::colour(std::span<const double> values) const {
  SKYLUT_CHECK_EQ(values.size(), size());
  if (kind == Kind::Yxy) return {values[0], values[1], values[2]};
  if (kind == Kind::Xyz) return to_yxy({values[0], values[1], values[2]});
  Xyz sum;
  for (std::size_t i = 0; i < values.size(); ++i) {
    sum.X += colour_weights[i].X * values[i];
    sum.Y += colour_weights[i].Y * values[i];
    sum.Z += colour_weights[i].Z * values[i];
  }
  return to_yxy(sum);
}

std::vector<double> SkyChannels::values(const Yxy& colour) const {
  SKYLUT_CHECK(kind != Kind::bands);
  if (kind == Kind::Yxy) return {colour.Y, colour.x, colour.y};
  const Xyz xyz = to_xyz(colour);
  return {xyz.X, xyz.Y, xyz.Z};
}

std::string SkyChannels::quantities() const {
  if (kind == Kind::Yxy) return "Y, x, y";
  if (kind == Kind::Xyz) return "X, Y, Z";
  return fmt::format("radiance in {} bands, {}-{} nm", wavelengths->size(), wavelengths->first_nm(),
                     wavelengths->last_nm());
}

std::vector<std::string> SkyChannels::names() const {
  if (kind == Kind::Yxy) return {"Y", "x", "y"};
  if (kind == Kind::Xyz) return {"X", "Y", "Z"};
  std::vector<std::string> names;
  for (std::size_t i = 0; i < wavelengths->size(); ++i)
    names.push_back(fmt::format("L_{}", (*wavelengths)[i]));
  return names;
}

ordered_json SkyChannels::json() const {
  if (kind != Kind::bands) return {{"kind", kind == Kind::Yxy ? kYxy : kXyz}};
  ordered_json weights = ordered_json::array();
  for (const Xyz& weight : colour_weights) weights.push_back({weight.X, weight.Y, weight.Z});
  return {{"kind", kBands},
          {"wavelengths_nm",
           {{"first", wavelengths->first_nm()},
            {"last", wavelengths->last_nm()},
            {"step", wavelengths->step_nm()}}},
          {"colour_weights", weights}};
}

SkyChannels SkyChannels::read(const JsonReader& json) {
  const std::string kind = json.at("kind").text();
  if (kind == kYxy) return {};
  if (kind == kXyz) return {.kind = Kind::Xyz};
  if (kind != kBands) json.at("kind").refuse("must be Yxy, XYZ or bands");
  SkyChannels channels{.kind = Kind::bands};
  const JsonReader nm = json.at("wavelengths_nm");
  channels.wavelengths =
      WavelengthGrid(nm.at("first").number(), nm.at("last").number(), nm.at("step").number());
  for (const JsonReader& weight : json.at("colour_weights").elements()) {
    const std::vector<JsonReader> xyz = weight.elements();
    if (xyz.size() != 3) weight.refuse("must be [X, Y, Z]");
    channels.colour_weights.push_back({xyz[0].number(), xyz[1].number(), xyz[2].number()});
  }
  if (channels.colour_weights.size() != channels.wavelengths->size())
    json.at("colour_weights").refuse("must be one per wavelength");
  return channels;
}

}  // namespace skylut
