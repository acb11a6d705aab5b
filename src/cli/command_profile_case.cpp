#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "advice.hpp"
#include "commands.hpp"
#include "options/file_kinds.hpp"
#include "options/light_kinds.hpp"
#include "options/number_kinds.hpp"
#include "output.hpp"
#include "scene_options.hpp"
#include "skylut/cases/optical_case.hpp"
#include "skylut/report/case_report.hpp"

namespace skylut::cli {

namespace {

struct CaseOptions {
  std::string name;
  AirOptions air;
  ComputingOptions computing;
  std::optional<std::filesystem::path> out;
  std::optional<double> wavelength_nm;
  double turbidity = 0.1;
  std::optional<std::int64_t> absorption_term;
  OpticalCaseRequest request;
};

void run(const CaseOptions& options, const std::string& command_line) {
  const Context context = program_context(options.computing);
  OpticalCaseRequest request = options.request;
  request.wavelength_nm = *options.wavelength_nm;
  if (options.absorption_term) request.absorption_term = static_cast<int>(*options.absorption_term);
  const Atmosphere air = build_atmosphere(context, options.air.atmosphere(options.name));
  advise_on_profile(context, air.profile());
  const Turbidity turbidity{options.air.turbidity_kind(), options.turbidity};
  advise_on_turbidity({&turbidity, 1}, air);
  request.aod500 = to_aod500(turbidity, air);
  nlohmann::ordered_json document = optical_case(air, request);
  document["command"] = command_line;
  Provenance provenance(command_line);
  describe_into(context, air, provenance);
  document["provenance"] = provenance.json();
  if (options.out) write_result(*options.out, document.dump(1) + "\n");
  if (options.out && is_standard_output(*options.out)) return;
  fmt::print("{}", case_text(document));
  if (options.out)
    fmt::print("wrote {}\n", options.out->string());
  else
    fmt::print("-o FILE writes the case as JSON\n");
}

}  // namespace

Command profile_case_command() {
  const auto options = std::make_shared<CaseOptions>();
  options->request.views = relative_views().read("0:0,30:0,30:90,30:180,60:0,60:90,60:180,85:0,85:90,85:180");
  Command command;
  command.name = "case";
  command.summary = "the air at one wavelength as explicit layers: a case for skylut solve";
  command.notes = "A summary goes to the screen, the case to -o FILE as JSON (-o - : to the screen).";
  command.examples = {
      "skylut profile case ussa1976 --wavelength-nm 550 --turbidity 0.2 --sun-zenith-deg 60 -o case.json",
      "skylut solve case.json"};
  OptionSet& set = command.options;
  set.add("PROFILE", options->name, name_or_file(), "a name (skylut profile list) or a TOML file").required =
      true;
  add_output(set, options->out, file_out(), "file for the case as JSON");
  set.add("--wavelength-nm", options->wavelength_nm, number(domain::kWavelength_nm), "300 to 1000").required =
      true;
  OpticalCaseRequest& request = options->request;
  set.add("--band-nm", request.band_nm, number(domain::kBand_nm),
          "width of the band: absorption by lines and the ground's albedo are its means");
  set.add("--absorption-term", options->absorption_term, whole_number(domain::kAbsorptionTerm),
          "which of the band's terms, where lines absorb");
  add_turbidity(set, options->turbidity);
  set.add("--altitude-km", request.altitude_km, number(domain::kObserver_km),
          "of the observer above the ground, 0 to 30");
  set.add("--sun-zenith-deg", request.sun_zenith_deg, number(domain::kSunZenith_deg), "of the sun, 0 to 99");
  set.add("--view", request.views, relative_views(),
          "zenith angle (0 to 180) and azimuth from the sun's (0 to 180), degrees");
  options->air.add_to(set);
  options->computing.add_to(set);
  command.run = [options](const OptionSet& given) {
    require_turbidity_with_its_kind(given);
    run(*options, given.command_line("skylut profile case"));
  };
  return command;
}

}  // namespace skylut::cli
