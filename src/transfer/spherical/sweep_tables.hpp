#pragma once

#include <optional>
#include <vector>

#include "block_optics.hpp"
#include "discretisation.hpp"
#include "kernel_problem.hpp"

namespace skylut::transfer {

/// Plain view of a discretisation for the kernels, with the few tables that only they need.
class SweepTables {
 public:
  explicit SweepTables(const Discretisation& grid);
  SweepTables(const SweepTables&) = delete;
  SweepTables& operator=(const SweepTables&) = delete;
  const SweepView& view() const { return view_; }

 private:
  SweepView view_{};
  std::vector<const float*> polar_synthesis_[2];
  std::vector<const float*> polar_analysis_[2];
  std::vector<int> moment_offset_;
  std::vector<int> moment_degree_;
  std::vector<float> flux_weight_;
  std::vector<float> beam_moment_;
  std::vector<float> sun_cosine_;
  std::optional<HorizonPeakTables> horizon_;
};

}  // namespace skylut::transfer
