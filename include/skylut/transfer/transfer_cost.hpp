#pragma once

#include <cstddef>

#include "skylut/transfer/sky_radiance.hpp"

namespace skylut {

/// What solve_sky_radiance would take, estimated from the sizes of its arrays and measured speeds.
struct TransferCost {
  std::size_t blocks = 0;            ///< of columns solved at once
  double most_sublayers = 0.0;       ///< of a column: grows with its optical depth
  double geometry_bytes = 0.0;       ///< shared by the columns of one discretisation, all of them
  double largest_field_bytes = 0.0;  ///< diffuse field of one block, while it is solved
  double fields_bytes = 0.0;         ///< of all blocks that are held or worked on at a time
  double all_fields_bytes = 0.0;     ///< of all blocks under all suns together
  double rays_bytes = 0.0;           ///< lines of sight worked on at a time
  double results_bytes = 0.0;        ///< the radiances
  double largest_block_cpu_s = 0.0;
  double cpu_s = 0.0;  ///< of all threads; rough, within a factor of 3 on a processor of 2020

  double memory_bytes() const { return geometry_bytes + fields_bytes + rays_bytes + results_bytes; }
};

/// @throws InputError  for values out of range, as solve_sky_radiance does; not for too much work
TransferCost estimate_cost(const Context& context, const Shells& shells,
                           std::span<const OpticalColumn> columns, std::span<const Sight> sights,
                           const TransferOptions& options);

/// Memory of this machine, or what its control group leaves to this process, bytes.
double machine_memory_bytes();

}  // namespace skylut
