#include "particle_optics.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <set>

#include "angular_sum.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/context.hpp"
#include "skylut/core/interpolation.hpp"
#include "skylut/core/parallel.hpp"
#include "skylut/core/quadrature.hpp"
#include "skylut/scattering/mie_sphere.hpp"

namespace skylut {

namespace {

// Radii are integrated over panels of ln r, each with a Gauss-Legendre rule of its own.
constexpr double kPanel = 0.25;
constexpr int kNodesPerPart = 4;
constexpr double kLeastNodes = 2.0;
// Nodes that a component gets beyond that. Ripples of Q and of the phase function, from x = 5 or so, are
// averaged best for a given cost (x² for a radius) where the nodes lie about as extinction over x; x^1.5 was
// found best.
constexpr double kSharedNodes = 1400.0;
// Panels are left out that hold less than this of the mixture's extinction and of its forward peak (r⁴).
constexpr double kNegligibleExtinction = 1e-5;
constexpr double kNegligiblePeak = 1e-2;
constexpr double kNegligibleTail = 1e-6;

struct Panel {
  double lower_ln_um;
  double upper_ln_um;
  double extinction;
  double peak;
  double demand;  // for nodes, see kSharedNodes
};

double at_wavelength(const AerosolComponent& component, const std::vector<double>& values, double at_nm) {
  const Bracket at = held_bracket(component.wavelength_nm, at_nm);
  return linear(values[at.below], values[at.above], at.part);
}

// What each panel holds, roughly: Q is taken as 2 x⁴ / (1 + x⁴).
std::vector<Panel> panels_of(const AerosolComponent& component, double per_um) {
  const double lowest = std::log(component.size.r_min_um);
  const double highest = std::log(component.size.r_max_um);
  const int count = static_cast<int>(std::ceil((highest - lowest) / kPanel));
  std::vector<Panel> panels;
  for (int i = 0; i < count; ++i) {
    Panel panel{lowest + (highest - lowest) * i / count, lowest + (highest - lowest) * (i + 1) / count, 0, 0,
                0};
    const double r = std::exp(0.5 * (panel.lower_ln_um + panel.upper_ln_um));
    const double x = per_um * r;
    const double quartic = std::pow(x, 4);
    panel.extinction =
        component.number_per_cm3 * component.size.per_log_radius(r) * r * r * quartic / (1.0 + quartic);
    panel.peak = panel.extinction * r * r;
    panel.demand = panel.extinction / std::pow(x, 1.5) * std::min(1.0, x * x / 25.0);
    panels.push_back(panel);
  }
  return panels;
}

struct Node {
  std::size_t component;
  double radius_um;
  double number;
};

std::vector<Node> nodes_of(const std::vector<AerosolComponent>& components, double per_um, double fineness) {
  std::vector<std::vector<Panel>> panels;
  double extinction = 0.0;
  double peak = 0.0;
  for (const AerosolComponent& component : components) {
    panels.push_back(panels_of(component, per_um));
    for (const Panel& panel : panels.back()) {
      extinction += panel.extinction;
      peak += panel.peak;
    }
  }
  const Quadrature rule = gauss_legendre(kNodesPerPart, 0.0, 1.0);
  std::vector<Node> nodes;
  for (std::size_t c = 0; c < components.size(); ++c) {
    double demand = 0.0;
    for (const Panel& panel : panels[c]) demand += panel.demand;
    for (const Panel& panel : panels[c]) {
      if (panel.extinction < kNegligibleExtinction * extinction && panel.peak < kNegligiblePeak * peak &&
          per_um * std::exp(panel.lower_ln_um) > 1.0)
        continue;
      const double wanted = fineness * (kLeastNodes + kSharedNodes * panel.demand / demand);
      const int parts = static_cast<int>(std::ceil(wanted / kNodesPerPart));
      const double width = (panel.upper_ln_um - panel.lower_ln_um) / parts;
      for (int part = 0; part < parts; ++part)
        for (std::size_t i = 0; i < rule.node.size(); ++i) {
          const double r = std::exp(panel.lower_ln_um + width * (part + rule.node[i]));
          nodes.push_back(
              {c, r,
               width * rule.weight[i] * components[c].number_per_cm3 * components[c].size.per_log_radius(r)});
        }
    }
  }
  return nodes;
}

void drop_tail(std::vector<double>& moments) {
  double tail = 0.0;
  while (moments.size() > 1) {
    tail += (2.0 * static_cast<double>(moments.size()) - 1.0) * std::abs(moments.back());
    if (tail > kNegligibleTail) return;
    moments.pop_back();
  }
}

}  // namespace

std::vector<ParticleOptics> particle_optics(const Context& context,
                                            const std::vector<AerosolComponent>& components,
                                            const std::vector<double>& wavelength_nm, double fineness) {
  std::vector<std::vector<Node>> nodes;
  AngularSum::Rules rules;
  for (const double at_nm : wavelength_nm) {
    const double per_um = 2.0 * kPi / (1e-3 * at_nm);
    nodes.push_back(nodes_of(components, per_um, fineness));
    for (const Node& node : nodes.back())
      AngularSum::prepare(rules, AngularSum::class_of(MieSphere::terms(per_um * node.radius_um)));
  }
  std::vector<ParticleOptics> results(wavelength_nm.size());
  parallel_for(wavelength_nm.size(), context.threads, [&](std::size_t w) {
    const double per_um = 2.0 * kPi / (1e-3 * wavelength_nm[w]);
    ParticleOptics& result = results[w];
    AngularSum sum;
    for (const Node& node : nodes[w]) {
      const AerosolComponent& component = components[node.component];
      const std::complex<double> index(at_wavelength(component, component.n, wavelength_nm[w]),
                                       at_wavelength(component, component.k, wavelength_nm[w]));
      const MieSphere sphere(per_um * node.radius_um, index);
      const double area = kPi * node.radius_um * node.radius_um * node.number;
      result.extinction_um2 += area * sphere.q_ext();
      result.scattering_um2 += area * sphere.q_sca();
      sum.add(sphere, node.number);
    }
    const std::vector<MatrixMoments> moments = sum.moments(rules);
    const double all = moments[0].alpha1;
    for (const MatrixMoments& moment : moments) result.moments.push_back(moment.alpha1 / all);
    drop_tail(result.moments);
    for (std::size_t l = 0; l < result.moments.size(); ++l) {
      result.polarisation.alpha2.push_back(moments[l].alpha2 / all);
      result.polarisation.alpha3.push_back(moments[l].alpha3 / all);
      result.polarisation.beta1.push_back(moments[l].beta1 / all);
    }
  });
  return results;
}

}  // namespace skylut
