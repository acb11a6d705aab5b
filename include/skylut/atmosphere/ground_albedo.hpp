#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "skylut/atmosphere/spectral_curve.hpp"

namespace skylut {

struct Context;

/// Share of the light that the ground, a Lambertian reflector, sends back: a number, or a curve by
/// wavelength. [docs/air.md, "Ground"]
class GroundAlbedo {
 public:
  /// The same at every wavelength. Implicit: a plain number is an albedo.
  GroundAlbedo(double value = 0.2) : value_(value) {}  // NOLINT(google-explicit-constructor)

  /// @param name  for tables and messages
  /// @param file  that it was read from; empty: none
  GroundAlbedo(std::string name, SpectralCurve curve, std::string file = {})
      : name_(std::move(name)), file_(std::move(file)), curve_(std::move(curve)) {}

  /// A number within 0-1, a preset or a file, as a text. @throws InputError naming the text
  static GroundAlbedo parse(const Context& context, const std::string& text);

  /// A preset (profiles/grounds/NAME.csv) or a file of one's own, which ends in .csv or has a slash and holds
  /// the columns wavelength_nm, albedo; straight lines between its points.
  /// @throws InputError  for an unknown name (naming those there are) or a file that is none
  static GroundAlbedo load(const Context& context, const std::string& name_or_file);

  /// The presets that come with skylut, sorted.
  static std::vector<std::string> names(const Context& context);

  /// @throws InputError  for an albedo outside [0, 1]
  void validate() const;

  /// Mean over [wavelength - band/2, wavelength + band/2], as far as the curve goes; band 0: the value there.
  /// @throws InputError  for a wavelength that the curve does not hold
  double at(double wavelength_nm, double band_nm = 0.0) const;

  /// For people: the number or the name.
  std::string text() const;

  /// The number, or the name with every point of the curve.
  nlohmann::ordered_json describe() const;

  /// The file that it was read from; empty: none.
  const std::string& file() const { return file_; }

  /// The number if it is one.
  std::optional<double> constant() const { return curve_ ? std::nullopt : std::optional(value_); }
  /// Of a curve; empty for a number.
  const std::string& name() const { return name_; }

 private:
  double value_ = 0.0;
  std::string name_;
  std::string file_;
  std::optional<SpectralCurve> curve_;
};

}  // namespace skylut
