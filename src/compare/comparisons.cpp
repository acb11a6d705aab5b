#include "skylut/compare/comparisons.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "skylut/core/errors.hpp"
#include "skylut/models/registry.hpp"

namespace skylut {

namespace {

constexpr const char* kUtm2005 = "utm2005";

}  // namespace

std::vector<std::string> comparison_names() {
  std::vector<std::string> names = sky_model_names();
  names.push_back(kUtm2005);
  return names;
}

CompareReport compare_table(const Context& context, const Table& table, const std::string& against) {
  if (against == kUtm2005) return compare_with_utm2005(context, table);
  const std::vector<std::string> names = comparison_names();
  if (std::find(names.begin(), names.end(), against) == names.end())
    throw InputError("comparison with '{}': must be one of {}", against, fmt::join(names, ", "));
  return compare_with_model(context, table, *make_sky_model(against));
}

}  // namespace skylut
