#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "skylut/core/wavelength_grid.hpp"
#include "skylut/forms/sky_supply.hpp"
#include "skylut/models/model_file.hpp"

namespace skylut {

/// What a user may ask of a form.
struct FormOptions {
  bool spectral = false;  ///< bands instead of colours, of forms that can have either
  /// Bands of the forms that have bands.
  WavelengthGrid bands = WavelengthGrid(380.0, 780.0, 40.0);
  double error = 0.0035;                  ///< aimed at by the form that can choose, see CompactFormOptions
  std::vector<double> albedos{0.0, 1.0};  ///< nodes of the forms that have an albedo, ascending, in [0, 1]
};

/// Which of FormOptions change what a form makes.
struct FormHeeds {
  bool spectral = false;
  bool bands = false;
  bool error = false;
  bool albedos = false;
};

/// A kind of sky model that skylut fits: what its parameters are, their bounds, where to start, how to
/// evaluate it and where it holds. fit_form() knows none of this. [models.md]
class Form {
 public:
  virtual ~Form() = default;

  virtual const char* name() const = 0;     ///< as on the command line
  virtual const char* summary() const = 0;  ///< a line for --help
  virtual FormHeeds heeds() const { return {}; }

  /// Fits the form to skies of its own choice, or to those that the supply was given.
  /// @return  without error, or with what only the form can say of it
  /// @throws InputError  if the supply has not the skies that the form needs
  virtual ModelFile fit(const Context& context, const SkySupply& supply,
                        const FormOptions& options) const = 0;

  /// Conditions at which the model is measured: none of those it was fitted to, if it has others. None: the
  /// form measures itself.
  virtual std::vector<SoughtSky> held_out(const SkySupply& supply, const ModelFile& fitted) const;

 protected:
  Form() = default;
  Form(const Form&) = default;
  Form& operator=(const Form&) = default;
};

/// All forms.
std::vector<const Form*> forms();
std::vector<std::string> form_names();

/// @throws InputError  naming the text, the forms there are and the one probably meant
const Form& form_named(const std::string& name);

/// Fits a form and measures what came out, against skies that it was not fitted to where the supply simulates
/// (held_out; checking_views), else against those that it was.
ModelFile fit_form(const Context& context, const Form& form, const SkySupply& supply,
                   const FormOptions& options);

}  // namespace skylut
