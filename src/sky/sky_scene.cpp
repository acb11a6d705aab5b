#include "skylut/sky/sky_scene.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "skylut/atmosphere/atmosphere_description.hpp"
#include "skylut/atmosphere/solar_spectrum.hpp"
#include "skylut/core/context.hpp"

namespace skylut {

using Json = nlohmann::ordered_json;

namespace {

// Every kind of turbidity for each value given, as far as it exists in this air.
Json turbidities_json(const SkyScene& scene) {
  Json all = Json::array();
  for (const Turbidity& turbidity : scene.turbidities) {
    Json one{{"given", turbidity.value}, {"kind", turbidity_kind_name(turbidity.kind)}};
    const double aod500 = to_aod500(turbidity, *scene.atmosphere);
    for (const TurbidityKind kind : turbidity_kinds())
      one[std::string(turbidity_kind_name(kind))] = from_aod500(aod500, kind, *scene.atmosphere);
    all.push_back(std::move(one));
  }
  return all;
}

Json suns_json(const SkyScene& scene) {
  Json suns = Json::array();
  for (const Direction& sun : scene.suns)
    suns.push_back({{"zenith_deg", sun.zenith_deg}, {"azimuth_deg", sun.azimuth_deg}});
  return suns;
}

}  // namespace

std::vector<double> extraterrestrial_irradiance(const Context& context, const SkyScene& scene) {
  const SolarSpectrum sun = SolarSpectrum::load(context, scene.solar);
  std::vector<double> irradiance;
  for (std::size_t i = 0; i < scene.wavelengths.size(); ++i)
    irradiance.push_back(sun.irradiance_W_m2_nm(scene.wavelengths[i], scene.wavelengths.step_nm()) /
                         (scene.sun_distance_au * scene.sun_distance_au));
  return irradiance;
}

Provenance scene_provenance(const Context& context, const SkyScene& scene, std::string command) {
  Provenance provenance(std::move(command));
  provenance.describe("altitudes_km", Json(scene.altitudes_km));
  provenance.describe("turbidities", turbidities_json(scene));
  provenance.describe("suns", suns_json(scene));
  provenance.describe("directions",
                      Json{{"name", scene.directions_name}, {"count", scene.directions.size()}});
  if (scene.place)
    provenance.describe("place", Json{{"latitude_deg", scene.place->latitude_deg},
                                      {"longitude_deg", scene.place->longitude_deg},
                                      {"height_m", scene.place->height_m}});
  if (!scene.time.empty()) provenance.describe("time", scene.time);
  provenance.describe("wavelengths_nm", Json{{"first", scene.wavelengths.first_nm()},
                                             {"last", scene.wavelengths.last_nm()},
                                             {"step", scene.wavelengths.step_nm()}});
  provenance.describe("solar", scene.solar);
  provenance.describe("sun_distance_au", Json(scene.sun_distance_au));
  describe_into(context, *scene.atmosphere, provenance);
  provenance.add_source(context, SolarSpectrum::load(context, scene.solar).file());
  provenance.add_source(context, context.data_file("spectra/cie1931_2deg.csv"));
  return provenance;
}

void describe_into(const TransferReport& report, Provenance& provenance) {
  provenance.set_instruction_set(report.kernel);
  provenance.describe("transfer", Json{{"kernel", report.kernel},
                                       {"lanes", report.lanes},
                                       {"blocks", report.blocks},
                                       {"iterations_most", report.iterations_most},
                                       {"error_left", report.error_left}});
}

}  // namespace skylut
