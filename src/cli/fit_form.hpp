#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "options/options.hpp"
#include "program_context.hpp"
#include "skylut/core/wavelength_grid.hpp"
#include "skylut/sky/sky_scene.hpp"

namespace skylut {
class Form;
}

namespace skylut::cli {

/// The options of `skylut fit INPUT --form NAME`.
class FormRequest {
 public:
  void add_to(OptionSet& options);

  /// The forms there are, a line each, for --help.
  static std::string forms_text();

  /// Whether --form was given.
  bool wanted() const { return form_.has_value(); }

  /// @throws InputError  for another option of forms without --form
  void refuse_without_form(const OptionSet& given) const;

  /// Fits the form, writes the model file and says on the screen what came out.
  void run(const std::filesystem::path& input, const std::filesystem::path& out,
           const std::string& command_line) const;

 private:
  void put_axes_into(SkyScene& scene) const;
  void refuse_axes_of_maps(const std::filesystem::path& input) const;
  void refuse_what_it_ignores(const Form& form) const;

  std::optional<std::string> form_;
  std::optional<std::string> grid_;
  std::optional<std::vector<double>> altitudes_km_;
  std::optional<std::vector<double>> turbidities_;
  std::optional<std::vector<double>> albedos_;
  std::optional<WavelengthGrid> bands_;
  std::optional<double> error_;
  bool spectral_ = false;
  ComputingOptions computing_;
};

}  // namespace skylut::cli
