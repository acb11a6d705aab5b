#include "case_layers.hpp"

#include <algorithm>
#include <map>
#include <string>

#include "case_matrices.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {
namespace {

constexpr double kHuge = 1e300;

/// Collects scattering depths, one scatterer per distinct phase function.
class ScattererList {
 public:
  explicit ScattererList(std::size_t layers) : layers_(layers) {}

  template <typename Make>
  void add(const std::vector<double>& key, std::size_t layer, double depth, const Make& make) {
    const auto [found, is_new] = index_.try_emplace(key, scatterers_.size());
    if (is_new) scatterers_.push_back({make(), std::vector<double>(layers_, 0.0)});
    scatterers_[found->second].scattering_depth[layer] += depth;
  }

  std::vector<Scatterer> take() { return std::move(scatterers_); }

 private:
  std::size_t layers_;
  std::map<std::vector<double>, std::size_t> index_;
  std::vector<Scatterer> scatterers_;
};

// The first number of a key says which kind of phase function it is.
constexpr double kRayleighKey = 0.0;
constexpr double kHenyeyGreensteinKey = 1.0;
constexpr double kMomentsKey = 2.0;
constexpr double kTableKey = 3.0;
constexpr double kMatrixMomentsKey = 4.0;

double depth_of(const JsonReader& layer, const char* key) {
  return layer.at(key).number(0.0, kHuge, ">= 0 (an optical depth)");
}

double albedo_of(const JsonReader& layer, const char* key) {
  return layer.at(key).number(0.0, 1.0, "within 0-1 (a single-scattering albedo)");
}

double asymmetry_of(const JsonReader& layer, const char* key) {
  const double g = layer.at(key).number(-1.0, 1.0, "within -1 to 1, both excluded (an asymmetry parameter)");
  if (g == 1.0 || g == -1.0) layer.at(key).refuse("1 or -1 must be a number within -1 to 1, both excluded");
  return g;
}

void add_henyey_greenstein(ScattererList& list, std::size_t index, double g, double depth) {
  list.add({kHenyeyGreensteinKey, g}, index, depth,
           [g] { return std::make_shared<const HenyeyGreensteinPhaseFunction>(g); });
}

void add_moments(ScattererList& list, std::size_t index, const JsonReader& place, double depth) {
  const std::vector<double> moments = place.numbers(-1.0, 1.0, "within -1 to 1 (a Legendre moment)");
  if (std::abs(moments[0] - 1.0) > 1e-6) place.refuse("the first moment must be 1");
  std::vector<double> key = moments;
  key.insert(key.begin(), kMomentsKey);
  if (depth > 0.0)
    list.add(key, index, depth, [&] { return std::make_shared<const LegendrePhaseFunction>(moments); });
}

void add_matrix(ScattererList& list, std::size_t index, double kind, const JsonReader& place, double depth) {
  const CaseMatrix matrix = kind == kTableKey ? read_matrix_table(place) : read_matrix_moments(place);
  std::vector<double> key = matrix.numbers;
  key.insert(key.begin(), kind);
  if (depth > 0.0) list.add(key, index, depth, [&] { return matrix.make(place); });
}

/// Molecules, one aerosol and an absorber. @return extinction depth
double read_air(const JsonReader& layer, std::size_t index, double rayleigh_depolarisation,
                ScattererList& list) {
  layer.only({"tau_rayleigh", "tau_aerosol", "ssa_aerosol", "g_aerosol", "tau_absorption",
              "phase_moments_aerosol", "phase_matrix_aerosol", "matrix_moments_aerosol"});
  if (layer.has("phase_moments_aerosol") + layer.has("phase_matrix_aerosol") +
          layer.has("matrix_moments_aerosol") >
      1)
    layer.refuse(
        "must have one at most of the keys \"phase_moments_aerosol\", \"phase_matrix_aerosol\" and "
        "\"matrix_moments_aerosol\"");
  const double rayleigh = depth_of(layer, "tau_rayleigh");
  const double aerosol = depth_of(layer, "tau_aerosol");
  const double albedo = albedo_of(layer, "ssa_aerosol");
  const double g = asymmetry_of(layer, "g_aerosol");
  const double absorption = depth_of(layer, "tau_absorption");
  if (rayleigh > 0.0)
    list.add({kRayleighKey}, index, rayleigh, [rayleigh_depolarisation] {
      return std::make_shared<const RayleighPhaseFunction>(rayleigh_depolarisation);
    });
  if (layer.has("phase_moments_aerosol"))
    add_moments(list, index, layer.at("phase_moments_aerosol"), aerosol * albedo);
  else if (layer.has("phase_matrix_aerosol"))
    add_matrix(list, index, kTableKey, layer.at("phase_matrix_aerosol"), aerosol * albedo);
  else if (layer.has("matrix_moments_aerosol"))
    add_matrix(list, index, kMatrixMomentsKey, layer.at("matrix_moments_aerosol"), aerosol * albedo);
  else if (aerosol * albedo > 0.0)
    add_henyey_greenstein(list, index, g, aerosol * albedo);
  return rayleigh + aerosol + absorption;
}

/// One medium with its own phase function. @return extinction depth
double read_medium(const JsonReader& layer, std::size_t index, ScattererList& list) {
  layer.only({"tau", "ssa", "phase_moments", "g_hg", "phase_matrix", "matrix_moments"});
  const double depth = depth_of(layer, "tau");
  const double scattering = depth * albedo_of(layer, "ssa");
  if (layer.has("phase_moments") + layer.has("g_hg") + layer.has("phase_matrix") +
          layer.has("matrix_moments") !=
      1)
    layer.refuse(
        "must have one of the keys \"phase_moments\", \"g_hg\", \"phase_matrix\" and \"matrix_moments\", "
        "not several");
  if (layer.has("g_hg")) {
    const double g = asymmetry_of(layer, "g_hg");
    if (scattering > 0.0) add_henyey_greenstein(list, index, g, scattering);
    return depth;
  }
  if (layer.has("phase_matrix"))
    add_matrix(list, index, kTableKey, layer.at("phase_matrix"), scattering);
  else if (layer.has("matrix_moments"))
    add_matrix(list, index, kMatrixMomentsKey, layer.at("matrix_moments"), scattering);
  else
    add_moments(list, index, layer.at("phase_moments"), scattering);
  return depth;
}

}  // namespace

OpticalColumn read_layers(const std::vector<JsonReader>& layers, double rayleigh_depolarisation) {
  OpticalColumn column;
  ScattererList list(layers.size());
  for (std::size_t i = 0; i < layers.size(); ++i)
    column.extinction_depth.push_back(layers[i].has("tau")
                                          ? read_medium(layers[i], i, list)
                                          : read_air(layers[i], i, rayleigh_depolarisation, list));
  column.scatterers = list.take();
  return column;
}

void reverse_layers(OpticalColumn& column) {
  std::reverse(column.extinction_depth.begin(), column.extinction_depth.end());
  for (Scatterer& scatterer : column.scatterers)
    std::reverse(scatterer.scattering_depth.begin(), scatterer.scattering_depth.end());
}

}  // namespace skylut
