#include "first_collision.hpp"

#include <algorithm>
#include <cmath>

namespace skylut::monte_carlo {
namespace {

/// Pieces are cut at shells and at this optical depth and length, so that the draw follows the light closely.
constexpr double kPieceDepth = 0.05;
constexpr double kPieceLength_km = 5.0;

/// Light from the ground, relative to the isotropic scattering of all that arrives: only sets the share of
/// draws.
constexpr double kGroundShare = 0.3;

}  // namespace

FirstCollision::FirstCollision(const ShellWalk& shells, const PhotonPosition& observer, const Vector& view,
                               const Vector& to_sun)
    : shells_(shells), observer_(observer), view_(view) {
  double depth = 0.0;
  double end_km = 0.0;
  const WalkEnd end = shells.walk(observer, view, [&](std::size_t layer, double start, double length) {
    const double extinction = shells.extinction_per_km(layer);
    const double count =
        std::ceil(std::max({1.0, extinction * length / kPieceDepth, length / kPieceLength_km}));
    for (double i = 0.0; i < count; i += 1.0) {
      pieces_.push_back({layer, start + length * i / count, length / count, depth});
      depth += extinction * length / count;
    }
    end_km = start + length;
    return true;
  });
  hits_ground_ = end == WalkEnd::ground;
  depth_to_ground_ = depth;
  if (hits_ground_) ground_ = {along(observer.position, view, end_km), 0};

  std::vector<double> meets;
  std::vector<double> lit;
  double all_meets = 0.0;
  double all_lit = 0.0;
  for (const Piece& piece : pieces_) {
    const double own = shells.extinction_per_km(piece.layer) * piece.length_km;
    const PhotonPosition middle{along(observer.position, view, piece.start_km + 0.5 * piece.length_km),
                                piece.layer};
    meets.push_back(std::exp(-piece.depth_before) * -std::expm1(-own));
    lit.push_back(meets.back() * std::exp(-shells.depth_to_top(middle, to_sun)));
    all_meets += meets.back();
    all_lit += lit.back();
  }
  if (hits_ground_) {
    meets.push_back(std::exp(-depth_to_ground_));
    all_meets += meets.back();
    lit.push_back(kGroundShare * meets.back() * std::exp(-shells.depth_to_top(ground_, to_sun)));
    all_lit += lit.back();
  }
  if (!(all_meets > 0.0)) return;
  double sum = 0.0;
  for (std::size_t i = 0; i < meets.size(); ++i) {
    sum += 0.5 * meets[i] / all_meets + 0.5 * (all_lit > 0.0 ? lit[i] / all_lit : meets[i] / all_meets);
    cumulative_.push_back(sum);
  }
  for (double& share : cumulative_) share /= sum;
}

FirstCollision::Draw FirstCollision::at(double choice) const {
  const auto found = std::upper_bound(cumulative_.begin(), cumulative_.end() - 1, choice);
  const auto index = static_cast<std::size_t>(found - cumulative_.begin());
  const double before = index == 0 ? 0.0 : cumulative_[index - 1];
  const double share = cumulative_[index] - before;
  if (index == pieces_.size()) return {true, ground_, std::exp(-depth_to_ground_) / share};
  const Piece& piece = pieces_[index];
  const double inside = (choice - before) / share * piece.length_km;
  const double extinction = shells_.extinction_per_km(piece.layer);
  const double law = extinction * std::exp(-piece.depth_before - extinction * inside);
  return {false,
          {along(observer_.position, view_, piece.start_km + inside), piece.layer},
          law * piece.length_km / share};
}

}  // namespace skylut::monte_carlo
