#include "grid_sums.hpp"

#include "aureole.hpp"
#include "linear_form.hpp"

namespace skylut::fit_detail {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;

GridSums::GridSums(const FitProblem& problem, const std::vector<double>& rates,
                   const std::vector<double>& widths) {
  const auto n = static_cast<Index>(problem.observations.size());
  const auto rings = static_cast<Index>(problem.ring_begins.size()) - 1;
  const auto nB = static_cast<Index>(rates.size());
  const auto nD = static_cast<Index>(widths.size());
  ArrayXd h(n);
  ArrayXd t(n);
  ArrayXd K(n);
  ArrayXd away(n);
  for (Index i = 0; i < n; ++i) {
    const Observation& o = problem.observations[static_cast<std::size_t>(i)];
    h(i) = o.model_scale;
    t(i) = o.target;
    K(i) = o.cos2_excess;
    away(i) = o.gamma_rad - problem.sun.sun_zenith_rad;
  }
  t_t_ = t.square().sum();

  // Sums over each ring; those of W as widths × rings.
  const ArrayXd hh = h * h;
  const ArrayXd ht = h * t;
  const ArrayXd hhK = hh * K;
  MatrixXd ring_one(rings, 5);  // of h², h² K, h² K², h t, h t K
  MatrixXd ring_W(nD, rings), ring_WW(nD, rings), ring_WK(nD, rings), ring_tW(nD, rings);
  const auto over_ring = [&](Index ring, const auto& sum) {
    const auto from = static_cast<Index>(problem.ring_begins[static_cast<std::size_t>(ring)]);
    const auto to = static_cast<Index>(problem.ring_begins[static_cast<std::size_t>(ring) + 1]);
    sum(from, to - from);
  };
  for (Index ring = 0; ring < rings; ++ring)
    over_ring(ring, [&](Index from, Index count) {
      ring_one(ring, 0) = hh.segment(from, count).sum();
      ring_one(ring, 1) = hhK.segment(from, count).sum();
      ring_one(ring, 2) = (hhK * K).segment(from, count).sum();
      ring_one(ring, 3) = ht.segment(from, count).sum();
      ring_one(ring, 4) = (ht * K).segment(from, count).sum();
    });
  Aureole aureole(n);
  for (Index d = 0; d < nD; ++d) {
    aureole.set(widths[static_cast<std::size_t>(d)], away, problem.sun);
    const ArrayXd& W = aureole.W;
    for (Index ring = 0; ring < rings; ++ring)
      over_ring(ring, [&](Index from, Index count) {
        const auto W_here = W.segment(from, count);
        ring_W(d, ring) = (hh.segment(from, count) * W_here).sum();
        ring_WW(d, ring) = (hh.segment(from, count) * W_here.square()).sum();
        ring_WK(d, ring) = (hhK.segment(from, count) * W_here).sum();
        ring_tW(d, ring) = (ht.segment(from, count) * W_here).sum();
      });
  }

  MatrixXd U(rings, nB);
  for (Index ring = 0; ring < rings; ++ring) {
    const double excess =
        problem.observations[problem.ring_begins[static_cast<std::size_t>(ring)]].secant_excess;
    for (Index b = 0; b < nB; ++b) U(ring, b) = gradation_basis(rates[static_cast<std::size_t>(b)], excess);
  }
  const MatrixXd powers[3] = {MatrixXd::Ones(rings, nB), U, U.array().square().matrix()};
  for (int i = 0; i < 3; ++i) {
    W_[i] = ring_W * powers[i];
    WW_[i] = ring_WW * powers[i];
    WK_[i] = ring_WK * powers[i];
    one_[i] = powers[i].transpose() * ring_one.col(0);
    K_[i] = powers[i].transpose() * ring_one.col(1);
    KK_[i] = powers[i].transpose() * ring_one.col(2);
    if (i == 2) break;
    tW_[i] = ring_tW * powers[i];
    t_[i] = powers[i].transpose() * ring_one.col(3);
    tK_[i] = powers[i].transpose() * ring_one.col(4);
  }
}

RateSums GridSums::at(Index rate) const {
  RateSums sums{};
  for (int i = 0; i < 3; ++i) {
    sums.one[i] = one_[i](rate);
    sums.K[i] = K_[i](rate);
    sums.KK[i] = KK_[i](rate);
    sums.W[i] = W_[i].col(rate);
    sums.WW[i] = WW_[i].col(rate);
    sums.WK[i] = WK_[i].col(rate);
    if (i == 2) break;
    sums.t_one[i] = t_[i](rate);
    sums.t_K[i] = tK_[i](rate);
    sums.t_W[i] = tW_[i].col(rate);
  }
  sums.t_t = t_t_;
  return sums;
}

}  // namespace skylut::fit_detail
