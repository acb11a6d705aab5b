#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "commands.hpp"
#include "directions_option.hpp"
#include "options/file_kinds.hpp"
#include "options/number_kinds.hpp"
#include "output.hpp"
#include "picture_options.hpp"
#include "program_context.hpp"
#include "scene_options.hpp"
#include "skylut/core/atomic_file.hpp"
#include "skylut/export/model_light.hpp"
#include "skylut/export/sky_csv.hpp"
#include "skylut/forms/sky_source.hpp"
#include "skylut/models/model_domain.hpp"
#include "sun_option.hpp"

namespace skylut::cli {

namespace fs = std::filesystem;

namespace {

constexpr Turbidity kDefaultTurbidity{TurbidityKind::aod500, 0.1};  // that of skylut map

struct EvalOptions {
  std::string source;
  fs::path out;
  double altitude_km = 0.0;
  std::optional<double> turbidity;
  std::optional<TurbidityKind> turbidity_kind;
  std::optional<double> albedo;
  SunOption sun;
  PlaceOptions place;
  std::optional<std::string> directions;
  bool spectral = false;
  PictureRequest picture;
  std::optional<TableRule> rule;
  bool extrapolate = false;
  std::int64_t threads = 0;
};

// A source, what is asked of it, and what is to be said about that.
struct Evaluation {
  SkySource source;
  SkyConditions conditions;          // with the turbidity in the source's kind
  Turbidity asked;                   // as it was typed
  std::string time;                  // that the sun was taken from; empty: none
  std::vector<std::string> outside;  // of the source's domain
  std::shared_ptr<const Sky> sky;
  Provenance provenance;
};

Kind<TableRule> rule_kind() {
  return choice<TableRule>({{"blend", TableRule::blend}, {"utm2005", TableRule::utm2005}});
}

bool is_picture(const EvalOptions& options) { return ending_of(options.out) == ".exr"; }

// What was not given gets its default, so that it is recorded.
void settle(EvalOptions& options, const OptionSet& given) {
  refuse_options_of_other_files(given, options.out, {"--directions", "--spectral"});
  if (is_picture(options))
    options.picture.settle();
  else
    options.directions = options.directions.value_or("utm271");
}

Turbidity asked_turbidity(EvalOptions& options, const ModelInfo& info) {
  if (options.turbidity_kind && !options.turbidity) throw InputError("--turbidity-kind: needs --turbidity");
  if (!options.turbidity) options.turbidity_kind = kDefaultTurbidity.kind;
  options.turbidity = options.turbidity.value_or(kDefaultTurbidity.value);
  options.turbidity_kind = options.turbidity_kind.value_or(info.turbidity_kind);
  return {*options.turbidity_kind, *options.turbidity};
}

// A source without that axis has one ground, which must be the one that is asked for.
double asked_albedo(const EvalOptions& options, const SkySource& source) {
  const double fallback = SkyConditions{}.albedo;
  if (source.model().info().albedo || !options.albedo) return options.albedo.value_or(fallback);
  const std::optional<double> made_with = source.albedo_made_with();
  if (made_with == options.albedo) return *options.albedo;
  throw InputError("--albedo {}: {} has one ground only, {}", *options.albedo, options.source,
                   made_with ? fmt::format("of albedo {}", *made_with) : "and does not say of what albedo");
}

Direction asked_sun(EvalOptions& options, Evaluation& asked) {
  SkyScene lit;
  options.sun.put_into(lit, {options.place, false});
  options.sun.require_above(domain::kSunZenith_deg.highest, lit.suns.front(),
                            "the sky's light ends at 99 deg (night)");
  asked.time = lit.time;
  return lit.suns.front();
}

void require_in_domain(const EvalOptions& options, const Evaluation& asked, bool turbidity_given) {
  if (asked.outside.empty() || options.extrapolate) return;
  const bool turbidity_outside =
      !asked.source.model().info().turbidity.holds(asked.conditions.turbidity.value);
  throw InputError("{}: outside what {} answers for; --extrapolate insists{}", fmt::join(asked.outside, ", "),
                   options.source,
                   turbidity_outside && !turbidity_given
                       ? fmt::format("; without --turbidity it is {} {}",
                                     turbidity_kind_name(kDefaultTurbidity.kind), kDefaultTurbidity.value)
                       : "");
}

// How the sky between a table's rows came about.
void describe_table(const TableModel& table, const Evaluation& asked, Provenance& provenance) {
  nlohmann::ordered_json how;
  how["at_a_row"] = table.is_node(asked.conditions);
  how["rule"] = table.rule();
  const std::string stated =
      table.table().provenance() ? table.table().provenance()->between_nodes : std::string();
  if (!stated.empty()) how["between_nodes"] = nlohmann::ordered_json::parse(stated);
  provenance.describe("interpolation", how);
}

Provenance provenance_of(const Context& context, const EvalOptions& options, const Evaluation& asked,
                         const std::string& command) {
  Provenance provenance(command);
  const ModelInfo& info = asked.source.model().info();
  provenance.describe("model", {{"name", info.name}, {"title", info.title}, {"source", info.source}});
  nlohmann::ordered_json conditions{{"altitude_km", asked.conditions.altitude_km},
                                    {"turbidity", asked.conditions.turbidity.value},
                                    {"turbidity_kind", turbidity_kind_name(asked.conditions.turbidity.kind)},
                                    {"sun_zenith_deg", asked.conditions.sun.zenith_deg},
                                    {"sun_azimuth_deg", asked.conditions.sun.azimuth_deg}};
  if (info.albedo) conditions["albedo"] = asked.conditions.albedo;
  if (!asked.time.empty()) conditions["time"] = asked.time;
  provenance.describe("conditions", conditions);
  if (asked.asked.kind != asked.conditions.turbidity.kind)
    provenance.describe("turbidity_given", {{"value", asked.asked.value},
                                            {"kind", turbidity_kind_name(asked.asked.kind)},
                                            {"converted", asked.source.conversion_source()}});
  if (asked.source.table() != nullptr) describe_table(*asked.source.table(), asked, provenance);
  provenance.describe("extrapolated", nlohmann::ordered_json(asked.outside));
  for (const fs::path& file : asked.source.files()) provenance.add_source(context, file);
  if (!is_picture(options)) provenance.describe("directions", *options.directions);
  return provenance;
}

Evaluation evaluated(const Context& context, EvalOptions& options, const OptionSet& given) {
  Evaluation asked;
  asked.source =
      SkySource::open(options.source, {options.rule.value_or(TableRule::blend), options.extrapolate});
  const ModelInfo& info = asked.source.model().info();
  if (asked.source.table() != nullptr)
    options.rule = options.rule.value_or(TableRule::blend);  // recorded as it was used
  else if (options.rule)
    throw InputError("--interpolation: is for tables, {} is none", options.source);
  asked.asked = asked_turbidity(options, info);
  asked.conditions.altitude_km = options.altitude_km;
  asked.conditions.turbidity = asked.source.in_own_kind(context, asked.asked);
  asked.conditions.albedo = asked_albedo(options, asked.source);
  asked.conditions.sun = asked_sun(options, asked);
  asked.outside = outside_domain(info, asked.conditions);
  require_in_domain(options, asked, given.given("--turbidity"));
  asked.sky = asked.source.model().at(asked.conditions);
  asked.provenance = provenance_of(context, options, asked, given.command_line("skylut eval"));
  return asked;
}

void require_spectra(const char* option, const EvalOptions& options, const Evaluation& asked) {
  if (asked.sky->wavelengths() != nullptr) return;
  throw InputError("{}: {} knows {} only, must be asked for these", option, options.source,
                   asked.source.model().info().quantities);
}

SkyMap sky_map(const EvalOptions& options, const Evaluation& asked) {
  SkyMap map;
  map.altitude_km = asked.conditions.altitude_km;
  map.turbidity = asked.asked;
  map.sun = asked.conditions.sun;
  map.directions = directions_of(*options.directions);
  map.colour.resize(map.directions.size());
  asked.sky->colour(map.directions, map.colour);
  if (!options.spectral) return map;
  map.wavelengths = *asked.sky->wavelengths();
  map.radiance.resize(map.directions.size() * map.wavelengths.size());
  asked.sky->radiance(map.directions, map.radiance);
  return map;
}

void say_conditions(const Evaluation& asked) {
  const ModelInfo& info = asked.source.model().info();
  const auto& [altitude_km, turbidity, albedo, sun] = asked.conditions;
  fmt::print("{}\n", info.title);
  fmt::print("altitude {} km, sun {:.6g}:{:.6g} deg", altitude_km, sun.zenith_deg, sun.azimuth_deg);
  if (info.albedo) fmt::print(", albedo {}", albedo);
  fmt::print("\n{} {}", turbidity_kind_name(asked.asked.kind), asked.asked.value);
  if (asked.asked.kind != turbidity.kind)
    fmt::print(" = {} {:.6g} ({})", turbidity_kind_name(turbidity.kind), turbidity.value,
               asked.source.conversion_source());
  fmt::print("\n");
}

void say_how_sure(const Evaluation& asked) {
  const TableModel* const table = asked.source.table();
  if (!asked.outside.empty())
    warn("extrapolated: {}: nothing vouches for this sky", fmt::join(asked.outside, ", "));
  if (table == nullptr || table->is_node(asked.conditions) || !asked.outside.empty()) return;
  fmt::print("between the table's rows: {}\n", table->rule());
  if (!table->table().provenance() || table->table().provenance()->between_nodes.empty())
    warn("the table states no error between its rows: one of skylut table --grid runtime does");
}

void write_csv(const EvalOptions& options, const Evaluation& asked) {
  if (options.spectral) require_spectra("--spectral", options, asked);
  require_writable("-o", options.out);
  const SkyMap map = sky_map(options, asked);
  write_text_atomically(options.out, sky_csv(map, asked.provenance));
  const auto darker = [](const Yxy& a, const Yxy& b) { return a.Y < b.Y; };
  const auto [darkest, brightest] = std::minmax_element(map.colour.begin(), map.colour.end(), darker);
  say_conditions(asked);
  say_how_sure(asked);
  if (!(darkest->Y > 0.0)) warn("luminance {:.5g} cd/m2: no light can be below 0", darkest->Y);
  fmt::print("{} directions, luminance {:.5g} to {:.5g} cd/m2\nwrote {}\n", map.directions.size(), darkest->Y,
             brightest->Y, options.out.string());
}

void write_exr(const Context& context, const EvalOptions& options, const Evaluation& asked) {
  const std::vector<SkyChannels> channels = options.picture.options().channels;
  if (std::find(channels.begin(), channels.end(), SkyChannels::spectral) != channels.end())
    require_spectra("--channels spectral", options, asked);
  options.picture.check(options.out);
  const ModelLight light(asked.sky, asked.source.view_zenith_deg(asked.conditions), asked.conditions.sun,
                         asked.conditions.altitude_km);
  const PictureLabels labels{asked.conditions.altitude_km, asked.asked, asked.provenance};
  const std::string report =
      options.picture.write(context, options.out, options.picture.preview(), light, nullptr, labels);
  say_conditions(asked);
  say_how_sure(asked);
  fmt::print("{}", report);
}

void run(EvalOptions& options, const OptionSet& given) {
  settle(options, given);
  ComputingOptions computing;
  computing.threads = options.threads;
  const Context context = program_context(computing);
  const Evaluation asked = evaluated(context, options, given);
  if (is_picture(options)) return write_exr(context, options, asked);
  write_csv(options, asked);
}

}  // namespace

Command eval_command() {
  const auto options = std::make_shared<EvalOptions>();
  Command command;
  command.name = "eval";
  command.summary =
      "one sky of a table, a fitted or a published model, as numbers (.csv) or a picture (.exr)";
  command.notes =
      "SOURCE: folder of a table or its table.csv, a model file of skylut fit, or preetham1999.\n"
      "A turbidity is of the source's own kind unless --turbidity-kind says otherwise.\n"
      "Directions that the source has nothing for, below 90 deg for a table, are refused in a .csv file and "
      "black in a picture.";
  command.examples = {
      "skylut eval preetham1999 -o sky.csv --turbidity 3 --sun-zenith-deg 60", "skylut table --out out/table",
      "skylut eval out/table -o sky.csv --altitude-km 6 --turbidity 0.5 --sun-zenith-deg 45",
      "skylut eval preetham1999 -o sky.exr --turbidity 3 --sun-zenith-deg 60 --size 64 --preview sky.png"};
  OptionSet& set = command.options;
  set.add("SOURCE", options->source, name_or_file(), "table, model file or published model").required = true;
  add_output(set, options->out, file_named({".csv", ".exr"}), "file to write: .csv or .exr").required = true;
  set.add("--altitude-km", options->altitude_km, number(domain::kObserver_km),
          "of the observer above the ground, 0 to 30");
  set.add("--turbidity", options->turbidity, number(domain::kTurbidityValue),
          "of the source's kind, or of --turbidity-kind; default: aod500 0.1");
  set.add("--turbidity-kind", options->turbidity_kind, turbidity_kind_by_name(),
          "aod500, aod550, angstrom-beta, preetham-t or visibility-km");
  set.add("--albedo", options->albedo, number(domain::kAlbedo),
          "of the ground, of a source that has it as an axis; default: 0.2");
  options->sun.add_to(set, domain::kSunZenith_deg);
  set.add("--interpolation", options->rule, rule_kind(),
          "between a table's rows: blend (default), or utm2005, the UTM report's rule in altitude");
  set.add_flag("--extrapolate", options->extrapolate, "go on outside the source's domain");
  add_directions(set, options->directions);
  set.add_flag("--spectral", options->spectral, "also radiances, L_<nm> (for .csv)");
  options->picture.add_without_sun_to(set);
  set.group("Place, with --time");
  options->place.add_to(set);
  set.group("Computing");
  set.add("--threads", options->threads, whole_number(domain::kThreads), "0: one per core; changes no result")
      .recorded = false;
  command.run = [options](const OptionSet& given) { run(*options, given); };
  return command;
}

}  // namespace skylut::cli
