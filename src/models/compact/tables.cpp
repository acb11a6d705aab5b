#include "skylut/models/compact/tables.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "packed_numbers.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/domain.hpp"

namespace skylut::compact {

namespace {

using nlohmann::ordered_json;

constexpr Range kNodeCount{4.0, 1000.0, ""};
constexpr Range kRank{1.0, 4096.0, ""};
constexpr Range kTerms{1.0, 16.0, ""};
constexpr std::size_t kAngles = 1024;

ordered_json basis_json(const Basis& basis) {
  ordered_json json;
  json["functions"] = basis.columns;
  json["values"] = pack_numbers(basis.values, 0.0);
  return json;
}

std::size_t whole(const JsonReader& place, const Range& range) {
  const double value = place.number(range);
  if (value != std::floor(value)) place.refuse("must be a whole number");
  return static_cast<std::size_t>(value);
}

Basis read_basis(const JsonReader& bases, const char* name, std::size_t rows) {
  const JsonReader place = bases.at(name);
  Basis basis;
  basis.rows = rows;
  basis.columns = whole(place.at("functions"), {1.0, static_cast<double>(rows), ""});
  basis.values = unpack_numbers(place.at("values"), rows * basis.columns);
  return basis;
}

// A core rank by rank, each in as few bytes as its step allows.
ordered_json core_json(const std::vector<float>& core, std::size_t rank, double step) {
  ordered_json json = ordered_json::array();
  const std::size_t each = core.size() / rank;
  for (std::size_t r = 0; r < rank; ++r)
    json.push_back(pack_numbers(std::span(core).subspan(r * each, each), step));
  return json;
}

std::vector<float> read_core(const JsonReader& model, const char* name, std::size_t rank, std::size_t each) {
  const std::vector<JsonReader> ranks = model.at(name).elements();
  if (ranks.size() != rank) model.at(name).refuse("must have one entry per rank");
  std::vector<float> core;
  core.reserve(rank * each);
  for (const JsonReader& one : ranks) {
    const std::vector<float> values = unpack_numbers(one, each);
    core.insert(core.end(), values.begin(), values.end());
  }
  return core;
}

std::vector<double> ascending(const JsonReader& place, const Range& range) {
  std::vector<double> values = place.numbers(range.lowest, range.highest, "the form's domain");
  if (!kNodeCount.holds(static_cast<double>(values.size()))) place.refuse("must have 4 to 1000 values");
  if (std::adjacent_find(values.begin(), values.end(), std::greater_equal<>()) != values.end())
    place.refuse("must ascend");
  return values;
}

}  // namespace

ordered_json tables_json(const Tables& tables) {
  ordered_json json;
  json["altitudes_km"] = tables.nodes.altitudes_km;
  json["aod500"] = tables.nodes.aod500;
  json["sun_zenith_deg"] = tables.nodes.suns_deg;
  json["planet_radius_km"] = tables.planet_radius_km;
  json["zenith_nodes"] = {tables.zenith_counts.above, tables.zenith_counts.limb, tables.zenith_counts.ground};
  json["wavelengths_nm"] = tables.wavelengths_nm;
  json["haze_terms"] = {
      {"count", tables.terms}, {"mean", tables.haze_mean}, {"values", pack_numbers(tables.haze_terms, 0.0)}};
  json["rayleigh"] = {{"at_0_deg", tables.rayleigh_0}, {"at_90_deg", tables.rayleigh_90}};
  json["spherical_albedo"] = pack_numbers(tables.spherical_albedo, 0.0);
  json["bases"] = {{"aod500", basis_json(tables.load)},
                   {"altitude", basis_json(tables.altitude)},
                   {"sun", basis_json(tables.sun)},
                   {"zenith", basis_json(tables.zenith)}};
  json["rank"] = tables.rank;
  json["mean"] = pack_numbers(tables.mean, 1e-4);
  json["conditions"] = core_json(tables.condition_core, tables.rank, tables.step);
  json["features"] = core_json(tables.feature_core, tables.rank, tables.step);
  return json;
}

Tables read_tables(const JsonReader& model) {
  Tables tables;
  tables.nodes.altitudes_km = ascending(model.at("altitudes_km"), domain::kObserver_km);
  tables.nodes.aod500 = ascending(model.at("aod500"), domain::kTurbidityValue);
  if (tables.nodes.aod500.size() < 5) model.at("aod500").refuse("must have at least 5 values");
  tables.nodes.suns_deg = ascending(model.at("sun_zenith_deg"), domain::kSunZenith_deg);
  tables.planet_radius_km = model.at("planet_radius_km").number(domain::kPlanetRadius_km);
  const std::vector<JsonReader> counts = model.at("zenith_nodes").elements();
  if (counts.size() != 3) model.at("zenith_nodes").refuse("must be [above, limb, ground]");
  tables.zenith_counts = {whole(counts[0], kNodeCount), whole(counts[1], kNodeCount),
                          whole(counts[2], kNodeCount)};
  tables.channels = {"X", "Y", "Z"};
  if (!model.at("wavelengths_nm").value().empty())
    tables.wavelengths_nm =
        model.at("wavelengths_nm")
            .numbers(domain::kWavelength_nm.lowest, domain::kWavelength_nm.highest, "a wavelength in nm");
  for (const double wavelength_nm : tables.wavelengths_nm)
    tables.channels.push_back(std::to_string(wavelength_nm));
  const std::size_t channels = tables.channels.size();

  const JsonReader haze = model.at("haze_terms");
  tables.terms = whole(haze.at("count"), kTerms);
  tables.haze_mean = haze.at("mean").number({1e-9, 1e9, ""});
  tables.haze_terms = unpack_numbers(haze.at("values"), kAngles * tables.terms);
  const auto per_channel = [&](const char* key) {
    std::vector<double> values = model.at("rayleigh").at(key).numbers(0.0, 10.0, "a phase function");
    if (values.size() != channels) model.at("rayleigh").at(key).refuse("must have one value per channel");
    return values;
  };
  tables.rayleigh_0 = per_channel("at_0_deg");
  tables.rayleigh_90 = per_channel("at_90_deg");
  tables.spherical_albedo =
      unpack_numbers(model.at("spherical_albedo"), 2 * tables.nodes.aod500.size() * channels);

  const std::size_t zenith_nodes =
      tables.zenith_counts.above + tables.zenith_counts.limb + tables.zenith_counts.ground;
  const JsonReader bases = model.at("bases");
  tables.load = read_basis(bases, "aod500", tables.nodes.aod500.size());
  tables.altitude = read_basis(bases, "altitude", tables.nodes.altitudes_km.size());
  tables.sun = read_basis(bases, "sun", tables.nodes.suns_deg.size());
  tables.zenith = read_basis(bases, "zenith", zenith_nodes);
  tables.rank = whole(model.at("rank"), kRank);
  const std::size_t numbers = tables.layout().size();
  tables.mean = unpack_numbers(model.at("mean"), zenith_nodes * numbers);
  tables.condition_core = read_core(model, "conditions", tables.rank,
                                    tables.load.columns * tables.altitude.columns * tables.sun.columns);
  tables.feature_core = read_core(model, "features", tables.rank, tables.zenith.columns * numbers);
  return tables;
}

}  // namespace skylut::compact
