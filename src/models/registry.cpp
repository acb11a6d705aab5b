#include "skylut/models/registry.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

#include "skylut/core/errors.hpp"
#include "skylut/models/preetham1999.hpp"

namespace skylut {

namespace {

template <class Model>
std::unique_ptr<const SkyModel> make() {
  return std::make_unique<const Model>();
}

// A new model is one line here.
constexpr std::array kMakers{make<Preetham1999>};

}  // namespace

std::vector<std::string> sky_model_names() {
  std::vector<std::string> names;
  for (const auto maker : kMakers) names.push_back(maker()->info().name);
  return names;
}

std::unique_ptr<const SkyModel> make_sky_model(const std::string& name) {
  for (const auto maker : kMakers)
    if (std::unique_ptr<const SkyModel> model = maker(); model->info().name == name) return model;
  throw InputError("sky model '{}': must be one of {}", name, fmt::join(sky_model_names(), ", "));
}

}  // namespace skylut
