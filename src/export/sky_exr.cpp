#include "skylut/export/sky_exr.hpp"

#include <ImfChannelList.h>
#include <ImfChromaticities.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "skylut/core/atomic_file.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/version.hpp"

namespace skylut {

namespace {

// OpenEXR's own file stream does not report a full disk while it closes; memory cannot fail like that.
class MemoryStream final : public Imf::OStream {
 public:
  MemoryStream() : Imf::OStream("memory") {}
  void write(const char data[], int size) override {
    const auto count = static_cast<std::size_t>(size);
    if (position_ + count > bytes_.size()) bytes_.resize(position_ + count);
    std::copy_n(data, count, bytes_.begin() + static_cast<std::ptrdiff_t>(position_));
    position_ += count;
  }
  uint64_t tellp() override { return position_; }
  void seekp(uint64_t position) override { position_ = position; }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
  std::size_t position_ = 0;
};

using Triple = std::array<float, 3>;

Triple as_floats(double a, double b, double c) {
  return {static_cast<float>(a), static_cast<float>(b), static_cast<float>(c)};
}

std::vector<Triple> rgb_pixels(const SkyMap& map) {
  std::vector<Triple> pixels;
  pixels.reserve(map.colour.size());
  for (const Yxy& colour : map.colour) {
    const LinearRgb rgb = to_linear_srgb(to_xyz(colour));
    pixels.push_back(as_floats(rgb.r, rgb.g, rgb.b));
  }
  return pixels;
}

std::vector<Triple> xyz_pixels(const SkyMap& map) {
  std::vector<Triple> pixels;
  pixels.reserve(map.colour.size());
  for (const Yxy& colour : map.colour) {
    const Xyz xyz = to_xyz(colour);
    pixels.push_back(as_floats(xyz.X, xyz.Y, xyz.Z));
  }
  return pixels;
}

// Channel name of Fichet et al.: Stokes component 0, the wavelength with a decimal comma (a dot would
// begin a layer), the unit.
std::string spectral_channel(double wavelength_nm) {
  std::string name = fmt::format("S0.{:.6f}nm", wavelength_nm);
  name[name.rfind('.')] = ',';
  return name;
}

void describe(Imf::Header& header, const SkyMap& map, const Projection& projection,
              const Provenance& provenance) {
  const auto text = [&header](const char* name, const std::string& value) {
    header.insert(name, Imf::StringAttribute(value));
  };
  const auto number = [&header](const char* name, double value) {
    header.insert(name, Imf::FloatAttribute(static_cast<float>(value)));
  };
  text("skylutVersion", kVersion);
  number("skyAltitudeKm", map.altitude_km);
  number("skyTurbidity", map.turbidity.value);
  text("skyTurbidityKind", std::string(turbidity_kind_name(map.turbidity.kind)));
  number("skySunZenithDeg", map.sun.zenith_deg);
  number("skySunAzimuthDeg", map.sun.azimuth_deg);
  text("skySunDisc", "not included");
  text("skyProjection", projection.name());
  text("skyOrientation", projection.orientation());
  text("skyAzimuthSense", "clockwise from north");
  text("skylutCommand", provenance.command());
  text("skylutProvenance", provenance.json().dump());
}

// A slice of interleaved floats: `stride` floats from one pixel to the next.
void add_channel(Imf::Header& header, Imf::FrameBuffer& frame, const std::string& name, const float* first,
                 std::size_t stride) {
  header.channels().insert(name, Imf::Channel(Imf::FLOAT));
  const auto pixels = static_cast<std::size_t>(header.dataWindow().max.x + 1);
  // The library only reads through this pointer when it writes a file.
  char* const base = reinterpret_cast<char*>(const_cast<float*>(first));
  frame.insert(name, Imf::Slice(Imf::FLOAT, base, stride * sizeof(float), pixels * stride * sizeof(float)));
}

void add_triple(Imf::Header& header, Imf::FrameBuffer& frame, const std::array<const char*, 3>& names,
                const std::vector<Triple>& pixels) {
  for (std::size_t i = 0; i < 3; ++i) add_channel(header, frame, names[i], pixels.front().data() + i, 3);
}

}  // namespace

void write_sky_exr(const std::filesystem::path& path, const SkyMap& map, const Projection& projection,
                   SkyChannels channels, const Provenance& provenance) {
  const auto pixels =
      static_cast<std::size_t>(projection.width()) * static_cast<std::size_t>(projection.height());
  if (map.directions.size() != pixels)
    throw InputError("sky map of {} directions: the {} picture has {} pixels", map.directions.size(),
                     projection.name(), pixels);
  Imf::Header header(projection.width(), projection.height());
  header.compression() = Imf::ZIP_COMPRESSION;
  describe(header, map, projection, provenance);

  Imf::FrameBuffer frame;
  const std::vector<Triple> colours = channels == SkyChannels::xyz ? xyz_pixels(map) : rgb_pixels(map);
  if (channels == SkyChannels::xyz) {
    add_triple(header, frame, {"X", "Y", "Z"}, colours);
    header.insert("skyLuminanceUnit", Imf::StringAttribute("cd.m^-2 (Y)"));
  } else {
    add_triple(header, frame, {"R", "G", "B"}, colours);
    Imf::addChromaticities(header, Imf::Chromaticities());  // the library's default is Rec. 709 with D65
    Imf::addWhiteLuminance(header, 1.0f);                   // R = G = B = 1 is 1 cd m⁻²
    header.insert("skyLuminanceUnit", Imf::StringAttribute("cd.m^-2 (0.2126 R + 0.7152 G + 0.0722 B)"));
  }
  if (channels == SkyChannels::spectral) {
    const std::size_t count = map.wavelengths.size();
    for (std::size_t i = 0; i < count; ++i)
      add_channel(header, frame, spectral_channel(map.wavelengths[i]), map.radiance.data() + i, count);
    header.insert("spectralLayoutVersion", Imf::StringAttribute("1.0"));
    header.insert("emissiveUnits",
                  Imf::StringAttribute("W.m^-2.sr^-1"));  // the only value that readers accept
    header.insert("skyRadianceUnit", Imf::StringAttribute("W.m^-2.sr^-1.nm^-1"));
  }

  MemoryStream stream;
  {
    Imf::OutputFile file(stream, header, 0);  // no threads: small pictures, equal bytes
    file.setFrameBuffer(frame);
    file.writePixels(projection.height());
  }
  write_text_atomically(path, stream.bytes());
}

std::size_t count_outside_rec709(const SkyMap& map) {
  const std::vector<Triple> pixels = rgb_pixels(map);
  return static_cast<std::size_t>(std::count_if(pixels.begin(), pixels.end(), [](const Triple& rgb) {
    return rgb[0] < 0.0f || rgb[1] < 0.0f || rgb[2] < 0.0f;
  }));
}

}  // namespace skylut
