#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace skylut {

/// Turbidities of a table converted to the T of Preetham 1999.
class TableTurbidity {
 public:
  /// Takes the conversion of table.json, which knows the table's own air; where there is none, or where
  /// `kind` is given, converts by T = 1 + τ_A(550 nm)/τ_R(550 nm) with the Rayleigh depth at sea level and
  /// Ångström's exponent 1.3.
  /// @param json  table.json; need not exist
  /// @param kind  aod500, aod550, angstrom-beta or preetham-t; visibility only through table.json
  /// @throws InputError  unknown kind; table.json broken
  TableTurbidity(const std::filesystem::path& json, const std::optional<std::string>& kind);

  /// @throws InputError  if table.json does not list that turbidity
  double preetham_t(double turbidity) const;

  /// Where the conversion comes from, for the heading.
  const std::string& source() const { return source_; }

 private:
  struct Listed {
    double given = 0.0;
    double preetham_t = 0.0;
  };
  std::filesystem::path json_;
  std::string kind_;
  std::string source_;
  bool listed_only_ = false;
  std::vector<Listed> listed_;
};

}  // namespace skylut
