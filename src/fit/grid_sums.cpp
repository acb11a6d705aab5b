#include "grid_sums.hpp"

#include "linear_form.hpp"

namespace skylut::fit_detail {

GridSums::GridSums(const FitProblem& problem, const std::vector<double>& rates,
                   const std::vector<double>& widths) {
  const auto n = static_cast<Eigen::Index>(problem.observations.size());
  const auto nB = static_cast<Eigen::Index>(rates.size());
  const auto nD = static_cast<Eigen::Index>(widths.size());
  Eigen::ArrayXd h(n);
  Eigen::ArrayXd t(n);
  Eigen::ArrayXd K(n);
  Eigen::ArrayXXd U(n, nB);
  Eigen::ArrayXXd W(n, nD);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Observation& o = problem.observations[static_cast<std::size_t>(i)];
    h(i) = o.model_scale;
    t(i) = o.target;
    K(i) = o.cos2_excess;
    for (Eigen::Index b = 0; b < nB; ++b)
      U(i, b) = gradation_basis(rates[static_cast<std::size_t>(b)], o.secant_excess);
    for (Eigen::Index d = 0; d < nD; ++d)
      W(i, d) = aureole_basis(widths[static_cast<std::size_t>(d)], o.gamma_rad, problem.sun);
  }

  const Eigen::MatrixXd powers[3] = {Eigen::MatrixXd::Ones(n, nB), U.matrix(), U.square().matrix()};
  const Eigen::ArrayXd hh = h * h;
  const Eigen::ArrayXd ht = h * t;
  const Eigen::MatrixXd hhW = (W.colwise() * hh).matrix();
  const Eigen::MatrixXd hhWW = (W.square().colwise() * hh).matrix();
  const Eigen::MatrixXd hhWK = (W.colwise() * (hh * K)).matrix();
  const Eigen::MatrixXd htW = (W.colwise() * ht).matrix();
  for (int i = 0; i < 3; ++i) {
    const Eigen::MatrixXd transposed = powers[i].transpose();
    W_[i] = transposed * hhW;
    WW_[i] = transposed * hhWW;
    WK_[i] = transposed * hhWK;
    one_[i] = transposed * hh.matrix();
    K_[i] = transposed * (hh * K).matrix();
    KK_[i] = transposed * (hh * K * K).matrix();
    if (i == 2) break;
    tW_[i] = transposed * htW;
    t_[i] = transposed * ht.matrix();
    tK_[i] = transposed * (ht * K).matrix();
  }
  t_t_ = t.square().sum();
}

NodeSums GridSums::at(Eigen::Index rate, Eigen::Index width) const {
  NodeSums sums{};
  for (int i = 0; i < 3; ++i) {
    sums.one[i] = one_[i](rate);
    sums.K[i] = K_[i](rate);
    sums.KK[i] = KK_[i](rate);
    sums.W[i] = W_[i](rate, width);
    sums.WW[i] = WW_[i](rate, width);
    sums.WK[i] = WK_[i](rate, width);
    if (i == 2) break;
    sums.t_one[i] = t_[i](rate);
    sums.t_K[i] = tK_[i](rate);
    sums.t_W[i] = tW_[i](rate, width);
  }
  sums.t_t = t_t_;
  return sums;
}

}  // namespace skylut::fit_detail
