#include "directions_option.hpp"

#include <filesystem>

#include "options/file_kinds.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/suggestion.hpp"
#include "skylut/export/directions_csv.hpp"

namespace skylut::cli {

Option& add_directions(OptionSet& options, std::optional<std::string>& name_or_file) {
  return options.add("--directions", name_or_file, cli::name_or_file(),
                     "utm271 (default), preetham343 or a CSV file (for .csv)");
}

std::vector<Direction> directions_of(const std::string& name_or_file) {
  if (name_or_file == "utm271") return directions_utm271();
  if (name_or_file == "preetham343") return directions_preetham343();
  std::error_code ignored;
  if (!std::filesystem::exists(name_or_file, ignored))
    throw InputError(
        "--directions '{}': must be utm271, preetham343 or a CSV file with columns zenith_deg,azimuth_deg{}",
        name_or_file, suggested(name_or_file, {"utm271", "preetham343"}));
  return read_directions_csv(name_or_file);
}

}  // namespace skylut::cli
