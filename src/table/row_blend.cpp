#include "row_blend.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {

namespace {

constexpr double kCandelaPerKilocandela = 1000.0;

// Mean of positive values by their logarithms, of others as they are.
class Mean {
 public:
  void add(double value, double weight) {
    sum_ += weight * value;
    if (value > 0.0)
      log_sum_ += weight * std::log(value);
    else
      positive_ = false;
  }
  double value() const { return positive_ ? std::exp(log_sum_) : sum_; }

 private:
  double sum_ = 0.0;
  double log_sum_ = 0.0;
  bool positive_ = true;
};

double perez(const PerezCoefficients& c, double cos_zenith, double gamma_rad, double cos_gamma) {
  return skylut::perez(c.A, c.B, c.C, c.D, c.E, cos_zenith, gamma_rad, cos_gamma);
}

}  // namespace

Yxy RowBlend::Term::colour(double cos_zenith, double gamma_rad, double cos_gamma) const {
  const double held_rad = std::clamp(gamma_rad, lowest_gamma_rad, highest_gamma_rad);
  const double cos_held = held_rad == gamma_rad ? cos_gamma : std::cos(held_rad);
  return {scale.Y * perez(coefficients.Y, cos_zenith, held_rad, cos_held),
          scale.x * perez(coefficients.x, cos_zenith, held_rad, cos_held),
          scale.y * perez(coefficients.y, cos_zenith, held_rad, cos_held)};
}

RowBlend::RowBlend(const std::vector<WeightedRow>& rows, const Direction& sun, double horizon_zenith_deg)
    : sun_(sun), horizon_zenith_deg_(horizon_zenith_deg) {
  largest_B_ = -std::numeric_limits<double>::infinity();
  for (const auto& [entry, weight] : rows) {
    const double sun_rad = entry->sun.zenith_deg * kRadiansPerDegree;
    const auto scale = [&](double zenith, const PerezCoefficients& c) {
      return zenith / skylut::perez(c, 0.0, sun_rad);
    };
    Term term;
    term.coefficients = {entry->Y, entry->x, entry->y};
    term.scale = {scale(entry->zenith.Y * kCandelaPerKilocandela, entry->Y), scale(entry->zenith.x, entry->x),
                  scale(entry->zenith.y, entry->y)};
    term.weight = weight;
    term.lowest_gamma_rad =
        std::max(0.0, entry->sun.zenith_deg - entry->horizon_zenith_deg) * kRadiansPerDegree;
    term.highest_gamma_rad =
        std::min(180.0, entry->sun.zenith_deg + entry->horizon_zenith_deg) * kRadiansPerDegree;
    terms_.push_back(term);
    largest_B_ = std::max({largest_B_, entry->Y.B, entry->x.B, entry->y.B});
  }
}

void RowBlend::colour(std::span<const Direction> views, std::span<Yxy> colours) const {
  if (views.size() != colours.size())
    throw InputError("sky in {} directions into {} colours: must be as many", views.size(), colours.size());
  for (std::size_t i = 0; i < views.size(); ++i) {
    const double zenith_deg = perez_zenith_deg(views[i], horizon_zenith_deg_, largest_B_);
    const double cos_zenith = std::cos(zenith_deg * kRadiansPerDegree);
    const double gamma_rad = angle_between(views[i], sun_);
    const double cos_gamma = std::cos(gamma_rad);
    Mean Y;
    Mean x;
    Mean y;
    for (const Term& term : terms_) {
      const Yxy colour = term.colour(cos_zenith, gamma_rad, cos_gamma);
      Y.add(colour.Y, term.weight);
      x.add(colour.x, term.weight);
      y.add(colour.y, term.weight);
    }
    colours[i] = {Y.value(), x.value(), y.value()};
  }
}

void LayerSum::colour(std::span<const Direction> views, std::span<Yxy> colours) const {
  std::fill(colours.begin(), colours.end(), Yxy{0.0, 0.0, 0.0});
  std::vector<Yxy> one(views.size());
  for (const auto& [sky, weight] : skies_) {
    sky->colour(views, one);
    for (std::size_t i = 0; i < views.size(); ++i) {
      colours[i].Y += weight * one[i].Y;
      colours[i].x += weight * one[i].x;
      colours[i].y += weight * one[i].y;
    }
  }
}

}  // namespace skylut
