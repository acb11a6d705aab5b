#include "export/exr_header.hpp"

#include <ImfChromaticities.h>
#include <ImfFloatAttribute.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "skylut/core/version.hpp"

namespace skylut {

namespace {

// Channel name of Fichet et al.: Stokes component 0, the wavelength with a decimal comma (a dot would
// begin a layer), the unit.
std::string spectral_channel(double wavelength_nm) {
  std::string name = fmt::format("S0.{:.6f}nm", wavelength_nm);
  name[name.rfind('.')] = ',';
  return name;
}

class Attributes {
 public:
  explicit Attributes(Imf::Header& header) : header_(header) {}
  void text(const char* name, const std::string& value) { header_.insert(name, Imf::StringAttribute(value)); }
  void number(const char* name, double value) {
    header_.insert(name, Imf::FloatAttribute(static_cast<float>(value)));
  }

 private:
  Imf::Header& header_;
};

void describe_sky(Attributes& add, const SkyLight& sky, const PictureLabels& labels,
                  const std::string& sun_disc) {
  add.text("skylutVersion", kVersion);
  add.number("skyAltitudeKm", labels.altitude_km);
  add.number("skyTurbidity", labels.turbidity.value);
  add.text("skyTurbidityKind", std::string(turbidity_kind_name(labels.turbidity.kind)));
  add.number("skySunZenithDeg", sky.sun().zenith_deg);
  add.number("skySunAzimuthDeg", sky.sun().azimuth_deg);
  add.number("skyHorizonZenithDeg", sky.horizon_zenith_deg());
  add.text("skySunDisc", sun_disc);
  add.text("skylutCommand", labels.provenance.command());
  add.text("skylutProvenance", labels.provenance.json().dump());
}

void describe_picture(Attributes& add, const Projection& projection) {
  add.text("skyProjection", projection.name());
  add.text("skyOrientation", projection.orientation());
  add.text("skyAzimuthSense", "clockwise from north");
  add.text("skyPixelValue", "mean over the pixel's solid angle");
}

std::string signed_term(double weight, const char* channel) {
  return fmt::format(" {} {:.4f} {}", weight < 0.0 ? '-' : '+', std::abs(weight), channel);
}

Imath::V2f v2f(const Chromaticity& c) { return {static_cast<float>(c.x), static_cast<float>(c.y)}; }

void describe_rgb(Imf::Header& header, Attributes& add, const PictureOptions& options) {
  const RgbSpace& space = rgb_space(options.rgb_space);
  const bool adapts = space.white != rgb_space("rec709").white;
  const bool adapted = adapts && options.adaptation == WhiteAdaptation::bradford;
  Imf::addChromaticities(header, {v2f(space.red), v2f(space.green), v2f(space.blue), v2f(space.white)});
  Imf::addAdoptedNeutral(header, adapted ? v2f(space.white) : v2f({kD65_x, kD65_y}));
  Imf::addWhiteLuminance(header, 1.0f);  // R = G = B = 1 is 1 cd m⁻²
  add.text("skyRgbSpace", space.name);
  add.text("colorInteropID", space.colour_interop_id);
  if (adapts)
    add.text("skyWhiteAdaptation", adapted ? "Bradford, from D65 to the white of the space" : "none");
  const LinearRgb weight = RgbConversion(space, options.adaptation).luminance_weights();
  add.text("skyLuminanceUnit", fmt::format("cd.m^-2 ({:.4f} R{}{})", weight.r, signed_term(weight.g, "G"),
                                           signed_term(weight.b, "B")));
}

}  // namespace

std::vector<std::string> channel_names(SkyChannels channels, const WavelengthGrid& wavelengths) {
  if (channels == SkyChannels::xyz) return {"X", "Y", "Z"};
  if (channels == SkyChannels::luminance) return {"Y"};
  std::vector<std::string> names{"R", "G", "B"};
  if (channels == SkyChannels::spectral)
    for (const double wavelength_nm : wavelengths.values_nm())
      names.push_back(spectral_channel(wavelength_nm));
  return names;
}

Imf::Header exr_header(SkyChannels channels, const Projection& projection, const SkyLight& sky,
                       const PictureOptions& options, const PictureLabels& labels,
                       const std::string& sun_disc) {
  Imf::Header header(projection.width(), projection.height());
  Attributes add(header);
  describe_sky(add, sky, labels, sun_disc);
  describe_picture(add, projection);
  if (channels == SkyChannels::rgb || channels == SkyChannels::spectral)
    describe_rgb(header, add, options);
  else
    add.text("skyLuminanceUnit", "cd.m^-2 (Y)");
  if (channels == SkyChannels::spectral) {
    add.text("spectralLayoutVersion", "1.0");
    add.text("emissiveUnits", "W.m^-2.sr^-1");  // the only value that readers accept
    add.text("skyRadianceUnit", "W.m^-2.sr^-1.nm^-1");
  }
  return header;
}

}  // namespace skylut
