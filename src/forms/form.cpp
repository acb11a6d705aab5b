#include "skylut/forms/form.hpp"

#include "form_list.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/suggestion.hpp"
#include "skylut/forms/model_error.hpp"

namespace skylut {

std::vector<const Form*> forms() {
  // A new form is one line here.
  static const PerezRowsForm perez(PerezRowsForm::Channels::colour);
  static const PerezRowsForm perez_spectral(PerezRowsForm::Channels::bands);
  static const PreethamForm preetham;
  static const HosekWilkieForm hosek_wilkie;
  static const CompactForm compact;
  return {&perez, &perez_spectral, &preetham, &hosek_wilkie, &compact};
}

std::vector<std::string> form_names() {
  std::vector<std::string> names;
  for (const Form* form : forms()) names.emplace_back(form->name());
  return names;
}

const Form& form_named(const std::string& name) {
  for (const Form* form : forms())
    if (name == form->name()) return *form;
  throw InputError("form '{}': must be {}{}", name, listed(form_names()), suggested(name, form_names()));
}

std::vector<SoughtSky> Form::held_out(const SkySupply& supply, const ModelFile& fitted) const {
  constexpr int kLoads = 6;
  constexpr int kPerLoad = 8;
  return spread_conditions(fitted.info, supply.axes(), kLoads, kPerLoad);
}

ModelFile fit_form(const Context& context, const Form& form, const SkySupply& supply,
                   const FormOptions& options) {
  ModelFile file = form.fit(context, supply, options);
  if (supply.simulates()) {
    const std::vector<SoughtSky> held_out = form.held_out(supply, file);
    if (held_out.empty()) return file;
    const std::unique_ptr<const SkyModel> model = make_model(file);
    const std::vector<TrainingSky> skies = supply.simulated(context, held_out, checking_views);
    file.error["held_out"] = error_summary(sky_errors(*model, skies));
  } else {
    file.error["fitted"] =
        error_summary(sky_errors(*make_model(file), supply.given(context, checking_views)));
  }
  return file;
}

}  // namespace skylut
