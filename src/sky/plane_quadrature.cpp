#include "plane_quadrature.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "skylut/core/constants.hpp"
#include "skylut/core/quadrature.hpp"

namespace skylut {

namespace {

constexpr int kNodes = 16;  // of a piece

// The pieces between ends that others divide where they lie between them.
std::vector<double> pieces(double first, double last, std::initializer_list<double> between) {
  std::vector<double> ends{first, last};
  for (const double end : between)
    if (end > first && end < last) ends.push_back(end);
  std::sort(ends.begin(), ends.end());
  return ends;
}

// Nodes in every piece, weights in the unit of the ends.
Quadrature crowded(const std::vector<double>& ends) {
  const Quadrature gauss = gauss_legendre(kNodes, 0.0, 1.0);
  Quadrature rule;
  for (std::size_t piece = 0; piece + 1 < ends.size(); ++piece) {
    const double span = ends[piece + 1] - ends[piece];
    for (std::size_t i = 0; i < gauss.node.size(); ++i) {
      const double t = gauss.node[i];
      rule.node.push_back(ends[piece] + span * t * t * (3.0 - 2.0 * t));
      rule.weight.push_back(gauss.weight[i] * span * 6.0 * t * (1.0 - t));
    }
  }
  return rule;
}

// Where on a circle of equal zenith angle the plane's edge crosses it: cos i = 0 at this azimuth from the
// plane's, degrees, either way; 0 or 180 where it does not.
double edge_deg(const TiltedPlane& plane, double zenith) {
  const double tilt = plane.tilt_deg * kRadiansPerDegree;
  const double level = std::cos(tilt) * std::cos(zenith);
  const double swing = std::sin(tilt) * std::sin(zenith);
  if (!(std::abs(level) < swing)) return 0.0;
  return std::acos(-level / swing) * kDegreesPerRadian;
}

}  // namespace

double cos_incidence(const TiltedPlane& plane, const Direction& from) {
  const double tilt = plane.tilt_deg * kRadiansPerDegree;
  const double zenith = from.zenith_deg * kRadiansPerDegree;
  return std::cos(tilt) * std::cos(zenith) +
         std::sin(tilt) * std::sin(zenith) *
             std::cos((from.azimuth_deg - plane.azimuth_deg) * kRadiansPerDegree);
}

SkyQuadrature plane_quadrature(const TiltedPlane& plane, PlanePart part, const Direction& sun,
                               double horizon_zenith_deg) {
  const bool above = part == PlanePart::sky;
  const double touching_deg = std::abs(90.0 - plane.tilt_deg);
  const Quadrature zenith =
      crowded(pieces(above ? 0.0 : 90.0, above ? 90.0 : 180.0,
                     {sun.zenith_deg, horizon_zenith_deg, touching_deg, 180.0 - touching_deg}));
  const double turn_deg = folded_relative_azimuth_deg(plane.azimuth_deg, sun.azimuth_deg);
  const TiltedPlane turned{plane.tilt_deg, turn_deg};  // with azimuths counted from the sun's
  SkyQuadrature result;
  for (std::size_t i = 0; i < zenith.node.size(); ++i) {
    const double theta = zenith.node[i] * kRadiansPerDegree;
    // Azimuths from the sun's, on the side where the plane faces; the other side mirrors its light.
    const double edge = edge_deg(plane, theta);
    const auto folded = [](double azimuth_deg) { return folded_relative_azimuth_deg(azimuth_deg, 0.0); };
    const Quadrature azimuth =
        crowded(pieces(0.0, 180.0, {folded(turn_deg + edge), folded(turn_deg - edge)}));
    for (std::size_t k = 0; k < azimuth.node.size(); ++k) {
      double cosines = 0.0;
      for (const double side : {-1.0, 1.0})
        cosines += std::max(0.0, cos_incidence(turned, {zenith.node[i], side * azimuth.node[k]}));
      if (cosines <= 0.0) continue;
      result.views.push_back({zenith.node[i], azimuth.node[k]});
      result.weight.push_back(cosines * std::sin(theta) * zenith.weight[i] * azimuth.weight[k] *
                              kRadiansPerDegree * kRadiansPerDegree);
    }
  }
  return result;
}

}  // namespace skylut
