#include "perez_form.hpp"

#include <ceres/autodiff_cost_function.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "newton_search.hpp"
#include "skylut/models/preetham_coefficients.hpp"
#include "start_search.hpp"

namespace skylut::fit_detail {

namespace {

bool finite(double value) { return std::isfinite(value); }

template <class T, int N>
bool finite(const ceres::Jet<T, N>& value) {
  return std::isfinite(value.a) && value.v.allFinite();
}

// The residuals in the linear form, h (1 + aU) (1 + cW + eK) - t. [fit.md F3]
struct Residuals {
  const FitProblem* problem;

  template <class T>
  bool operator()(const T* parameter, T* residual) const {
    const T& a = parameter[0];
    const T& B = parameter[1];
    const T& c = parameter[2];
    const T& D = parameter[3];
    const T& e = parameter[4];
    for (std::size_t i = 0; i < problem->observations.size(); ++i) {
      const Observation& o = problem->observations[i];
      residual[i] = o.model_scale * (1.0 + a * gradation_basis(B, o.secant_excess)) *
                        (1.0 + c * aureole_basis(D, o.gamma_rad, problem->sun) + e * o.cos2_excess) -
                    o.target;
    }
    return true;
  }
};

// The same with c and e eliminated: for given a, B, D they follow by linear least squares. Since the
// elimination is differentiated along with the rest, the derivatives are those of the whole (variable
// projection, Golub and Pereyra 1973), and Levenberg-Marquardt is spared the curved valleys along which c, e
// and D trade. [fit.md F5]
struct ProjectedResiduals {
  const FitProblem* problem;
  double least_offset;  // of p; 0: any

  // Parameters a, B, D. False where the formula overflows.
  template <class T>
  bool operator()(const T* parameter, T* residual) const {
    T c, e;
    eliminate(parameter, residual, c, e);
    return std::all_of(residual, residual + problem->observations.size(),
                       [](const T& r) { return finite(r); });
  }

  template <class T>
  void eliminate(const T* parameter, T* residual, T& c, T& e) const {
    const T& a = parameter[0];
    const T& B = parameter[1];
    const T& D = parameter[2];
    const std::size_t n = problem->observations.size();
    std::vector<T> aureole(n);
    std::vector<T> backward(n);
    // Samples are sorted by zenith angle: the gradation changes only from ring to ring.
    double ring = -1.0;
    T gradation(1.0);
    T KK(0.0), KW(0.0), KR(0.0);
    for (std::size_t i = 0; i < n; ++i) {
      const Observation& o = problem->observations[i];
      if (o.secant_excess != ring) {
        ring = o.secant_excess;
        gradation = 1.0 + a * gradation_basis(B, ring);
      }
      const T level = o.model_scale * gradation;
      residual[i] = level - o.target;
      aureole[i] = level * aureole_basis(D, o.gamma_rad, problem->sun);
      backward[i] = level * o.cos2_excess;
      KK += backward[i] * backward[i];
      KW += backward[i] * aureole[i];
      KR += backward[i] * residual[i];
    }
    // Gram-Schmidt: W made orthogonal to K, then the residual to both.
    const bool has_backward = KK > 0.0;
    const T share = has_backward ? T(KW / KK) : T(0.0);
    const T first_e = has_backward ? T(-KR / KK) : T(0.0);
    T before(0.0), WW(0.0), WR(0.0);
    for (std::size_t i = 0; i < n; ++i) {
      before += aureole[i] * aureole[i];
      aureole[i] -= share * backward[i];
      residual[i] += first_e * backward[i];
      WW += aureole[i] * aureole[i];
      WR += aureole[i] * residual[i];
    }
    // A column that is dependent to 12 digits is left out.
    const bool has_aureole = WW > 1e-24 * before;
    c = has_aureole ? T(-WR / WW) : T(0.0);
    e = first_e - c * share;
    for (std::size_t i = 0; i < n; ++i) residual[i] += c * aureole[i];
    hold_offset(D, aureole, backward, share, residual, c, e);
  }

  // Where c and e would leave p below its bound, they move along the line that keeps it there. Takes the
  // columns as eliminate() leaves them, W made orthogonal to K by taking `share` of it away.
  template <class T>
  void hold_offset(const T& D, const std::vector<T>& aureole, const std::vector<T>& backward, const T& share,
                   T* residual, T& c, T& e) const {
    using std::exp;
    const T k1 = exp(D * (problem->sun.sun_zenith_rad - problem->sun.gamma_0_rad)) / D;
    const double k2 = problem->sun.cos2_sun_zenith;
    const T lacking = least_offset - (1.0 - c * k1 - e * k2);
    if (least_offset == 0.0 || !(lacking > 0.0)) return;
    // Along the line (c, e) = foot + t (-k2, k1).
    const T foot = (1.0 - least_offset) / (k1 * k1 + k2 * k2);
    const T c_from = k1 * foot;
    const T e_from = k2 * foot;
    T square(0.0), product(0.0);
    std::vector<T> along(aureole.size());
    for (std::size_t i = 0; i < aureole.size(); ++i) {
      const T W = aureole[i] + share * backward[i];
      along[i] = k1 * backward[i] - k2 * W;
      residual[i] += (c_from - c) * W + (e_from - e) * backward[i];
      square += along[i] * along[i];
      product += along[i] * residual[i];
    }
    const T t = square > 0.0 ? T(-product / square) : T(0.0);
    for (std::size_t i = 0; i < aureole.size(); ++i) residual[i] += t * along[i];
    c = c_from - t * k2;
    e = e_from + t * k1;
  }
};

// The same in ln(1-a), ln(-B), D, in which the valleys along which a and B trade are straight.
struct StraightResiduals {
  ProjectedResiduals projected;

  template <class T>
  bool operator()(const T* parameter, T* residual) const {
    using std::exp;
    const T at[] = {T(1.0 - exp(parameter[0])), T(-exp(parameter[1])), parameter[2]};
    return projected(at, residual);
  }
};

constexpr double kPreethamStart_T = 3.0;  // the middle of his range

Start searched(const LinearParameters& all) { return {all[0], all[1], all[3]}; }

double least_offset(const FitOptions& options) { return 1.0 / options.largest_scattering; }

}  // namespace

PerezForm::PerezForm(const FitProblem& problem, const FitOptions& options)
    : problem_(problem), options_(options) {}

Minimum PerezForm::search_on(Minimum from) const {
  const ceres::AutoDiffCostFunction<StraightResiduals, ceres::DYNAMIC, 3> residuals(
      new StraightResiduals{{&problem_, least_offset(options_)}},
      static_cast<int>(problem_.observations.size()));
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const std::vector<ParameterBounds> bounds{{-std::log(options_.largest_gradation), kInfinity},
                                            {std::log(-options_.B_upper), std::log(-options_.B_lower)},
                                            {options_.D_lower, options_.D_upper}};
  from.at = {std::log1p(-from.at[0]), std::log(-from.at[1]), from.at[2]};
  Minimum end = newton_search(residuals, bounds, std::move(from), options_.max_iterations);
  const double B = end.at[1] >= bounds[1].upper   ? options_.B_lower
                   : end.at[1] <= bounds[1].lower ? options_.B_upper
                                                  : -std::exp(end.at[1]);
  end.at = {-std::expm1(end.at[0]), B, end.at[2]};
  return end;
}

std::vector<Start> PerezForm::starts() const {
  std::vector<Start> starts = search_grid(problem_, options_);
  const PerezYxy preetham = preetham1999_coefficients(kPreethamStart_T);
  for (const PerezCoefficients& k : {preetham.Y, preetham.x, preetham.y})
    starts.push_back(searched(to_linear(k, problem_.sun)));
  return starts;
}

LinearParameters PerezForm::all_parameters(std::span<const double> searched) const {
  std::vector<double> residual(problem_.observations.size());
  double c = 0.0;
  double e = 0.0;
  ProjectedResiduals{&problem_, least_offset(options_)}.eliminate(searched.data(), residual.data(), c, e);
  return {searched[0], searched[1], c, searched[2], e};
}

Eigen::MatrixXd PerezForm::jacobian(const LinearParameters& at) const {
  const int count = static_cast<int>(problem_.observations.size());
  const ceres::AutoDiffCostFunction<Residuals, ceres::DYNAMIC, 5> function(new Residuals{&problem_}, count);
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows(count, 5);
  std::vector<double> residual(problem_.observations.size());
  const double* blocks[] = {at.data()};
  double* derivatives[] = {rows.data()};
  function.Evaluate(blocks, residual.data(), derivatives);
  return rows;
}

Eigen::MatrixXd PerezForm::coefficient_derivatives(const LinearParameters& at) const {
  using Jet = ceres::Jet<double, 5>;
  std::array<Jet, 5> variable;
  for (int i = 0; i < 5; ++i) variable[static_cast<std::size_t>(i)] = Jet(at[static_cast<std::size_t>(i)], i);
  const std::array<Jet, 5> coefficient = to_perez(variable, problem_.sun);
  Eigen::MatrixXd derivatives(5, 5);
  for (int i = 0; i < 5; ++i) derivatives.row(i) = coefficient[static_cast<std::size_t>(i)].v.transpose();
  return derivatives;
}

}  // namespace skylut::fit_detail
