#pragma once

#include "skylut/forms/form.hpp"

/// The forms, one file each.
namespace skylut {

/// One Perez formula per channel and sky, of the conditions of the input: `perez` (Y, x, y) and
/// `perez-spectral` (bands). [perez_rows_form.cpp]
class PerezRowsForm final : public Form {
 public:
  enum class Channels { colour, bands };
  explicit PerezRowsForm(Channels channels) : channels_(channels) {}

  const char* name() const override;
  const char* summary() const override;
  FormHeeds heeds() const override { return {.bands = channels_ == Channels::bands}; }
  ModelFile fit(const Context& context, const SkySupply& supply, const FormOptions& options) const override;
  std::vector<SoughtSky> held_out(const SkySupply& supply, const ModelFile& fitted) const override;

 private:
  Channels channels_;
};

/// Preetham, Shirley and Smits 1999, their procedure on our skies. [preetham_form.cpp]
class PreethamForm final : public Form {
 public:
  const char* name() const override { return "preetham"; }
  const char* summary() const override { return "Preetham 1999: A-E linear in T, polynomials of the zenith"; }
  ModelFile fit(const Context& context, const SkySupply& supply, const FormOptions& options) const override;
};

/// Hosek and Wilkie 2012. [hosek_wilkie_form.cpp]
class HosekWilkieForm final : public Form {
 public:
  const char* name() const override { return "hosek-wilkie"; }
  const char* summary() const override {
    return "Hosek and Wilkie 2012: nine coefficients, quintic in the sun";
  }
  FormHeeds heeds() const override { return {.spectral = true, .bands = true, .albedos = true}; }
  ModelFile fit(const Context& context, const SkySupply& supply, const FormOptions& options) const override;
};

/// Our own. [compact_form.cpp]
class CompactForm final : public Form {
 public:
  const char* name() const override { return "skylut"; }
  const char* summary() const override { return "the sky's smooth parts, compressed over all conditions"; }
  FormHeeds heeds() const override { return {.spectral = true, .bands = true, .error = true}; }
  ModelFile fit(const Context& context, const SkySupply& supply, const FormOptions& options) const override;
  /// None: it states an error of its own, by lines of sight, over its whole domain.
  std::vector<SoughtSky> held_out(const SkySupply&, const ModelFile&) const override { return {}; }
};

}  // namespace skylut
