#pragma once

#include "kernel_problem.hpp"
#include "skylut/core/context.hpp"

namespace skylut::transfer {

/// The build of the solver that was asked for.
/// @throws InputError  if this machine (or this build of skylut) cannot run it
const Kernel& kernel_for(Simd simd);

}  // namespace skylut::transfer
