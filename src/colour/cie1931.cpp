#include "skylut/colour/cie1931.hpp"

#include <algorithm>
#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/core/context.hpp"
#include "skylut/core/csv.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/interpolation.hpp"

namespace skylut {

namespace {

double cross(const Yxy& origin, const Yxy& a, const Yxy& b) {
  return (a.x - origin.x) * (b.y - origin.y) - (a.y - origin.y) * (b.x - origin.x);
}

// Andrew's monotone chain: the chromaticities of the long wavelengths crowd and turn back by rounding, and
// the hull of all is the region of mixtures whatever they do.
std::vector<Yxy> convex_hull(std::vector<Yxy> points) {
  std::sort(points.begin(), points.end(),
            [](const Yxy& a, const Yxy& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::vector<Yxy> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t start = hull.size();
    for (const Yxy& point : points) {
      while (hull.size() >= start + 2 && cross(hull[hull.size() - 2], hull.back(), point) <= 0.0)
        hull.pop_back();
      hull.push_back(point);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

}  // namespace

ColourMatching ColourMatching::load(const Context& context) {
  const CsvTable table = CsvTable::read(context.data_file("spectra/cie1931_2deg.csv"));
  const std::size_t wavelength = table.column("wavelength_nm");
  const std::size_t x_bar = table.column("x_bar");
  const std::size_t y_bar = table.column("y_bar");
  const std::size_t z_bar = table.column("z_bar");
  ColourMatching matching;
  double sum = 0.0;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    matching.wavelength_nm_.push_back(table.number(i, wavelength));
    matching.value_.push_back({table.number(i, x_bar), table.number(i, y_bar), table.number(i, z_bar)});
    const double step_nm = i == 0 ? 5.0 : matching.wavelength_nm_[i] - matching.wavelength_nm_[i - 1];
    if (step_nm != 5.0) throw InputError("{}: wavelengths must rise by 5 nm", table.place(i));
    sum += matching.value_.back().Y * step_nm;
  }
  // The header gives the integral to 4 decimals.
  const double stated = table.comment_number("integral_y_bar_nm").value_or(0.0);
  if (!(std::abs(sum - stated) <= 1e-4))
    throw InputError("{}: the sum of y_bar times 5 nm is {:.4f}: must be the {:.4f} that the header states",
                     table.path().string(), sum, stated);
  std::vector<Yxy> chromaticities;
  for (const Xyz& value : matching.value_) chromaticities.push_back(to_yxy(value));
  matching.locus_ = convex_hull(std::move(chromaticities));
  return matching;
}

Xyz ColourMatching::at(double wavelength_nm) const {
  if (wavelength_nm < wavelength_nm_.front() || wavelength_nm > wavelength_nm_.back()) return {};
  const Bracket at = held_bracket(wavelength_nm_, wavelength_nm);
  const Xyz& a = value_[at.below];
  const Xyz& b = value_[at.above];
  return {linear(a.X, b.X, at.part), linear(a.Y, b.Y, at.part), linear(a.Z, b.Z, at.part)};
}

std::vector<Xyz> ColourMatching::weights(const WavelengthGrid& grid) const {
  const auto add = [](Xyz& sum, double share, const Xyz& value) {
    sum.X += share * kLuminousEfficacy_lm_per_W * value.X;
    sum.Y += share * kLuminousEfficacy_lm_per_W * value.Y;
    sum.Z += share * kLuminousEfficacy_lm_per_W * value.Z;
  };
  std::vector<Xyz> weights(grid.size());
  if (grid.size() == 1) {
    add(weights[0], grid.step_nm(), at(grid[0]));
    return weights;
  }
  for (std::size_t i = 0; i + 1 < grid.size(); ++i) {
    // Nodes within one step of the grid: its ends and the table's wavelengths between them.
    std::vector<double> nodes{grid[i]};
    for (const double wavelength : wavelength_nm_)
      if (wavelength > grid[i] + 1e-9 && wavelength < grid[i + 1] - 1e-9) nodes.push_back(wavelength);
    nodes.push_back(grid[i + 1]);
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      const double from = n == 0 ? nodes[n] : nodes[n - 1];
      const double to = n + 1 == nodes.size() ? nodes[n] : nodes[n + 1];
      const Xyz value = at(nodes[n]);
      const double t = (nodes[n] - grid[i]) / (grid[i + 1] - grid[i]);
      add(weights[i], 0.5 * (to - from) * (1.0 - t), value);
      add(weights[i + 1], 0.5 * (to - from) * t, value);
    }
  }
  return weights;
}

Xyz ColourMatching::integrate(const WavelengthGrid& grid, std::span<const double> radiance_W_m2_sr_nm) const {
  if (radiance_W_m2_sr_nm.size() != grid.size())
    throw InputError("spectrum of {} values: must have the {} of its wavelengths", radiance_W_m2_sr_nm.size(),
                     grid.size());
  return weighted_sum<double>(weights(grid), radiance_W_m2_sr_nm);
}

double ColourMatching::part_of_vision(double first_nm, double last_nm) const {
  constexpr int kPerStep = 20;  // pieces of the table's 5 nm
  const double piece_nm = (wavelength_nm_[1] - wavelength_nm_[0]) / kPerStep;
  const std::size_t pieces = kPerStep * (wavelength_nm_.size() - 1);
  double all = 0.0;
  double part = 0.0;
  for (std::size_t i = 0; i < pieces; ++i) {
    const double middle_nm = wavelength_nm_.front() + (static_cast<double>(i) + 0.5) * piece_nm;
    const double sensitivity = at(middle_nm).Y;
    all += sensitivity;
    if (middle_nm > first_nm && middle_nm < last_nm) part += sensitivity;
  }
  return part / all;
}

bool ColourMatching::inside_spectral_locus(double x, double y) const {
  const Yxy point{0.0, x, y};
  // Rounding of a point on the border: 1e-12 of the area spanned.
  for (std::size_t i = 0; i < locus_.size(); ++i)
    if (!(cross(locus_[i], locus_[(i + 1) % locus_.size()], point) >= -1e-12)) return false;
  return true;
}

}  // namespace skylut
