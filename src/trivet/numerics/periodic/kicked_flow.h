// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "trivet/numerics/lanes/line_memory.h"

namespace trivet::numerics {

/// Steps of a linear flow in 2×2 blocks with a kick in the middle of each: y changes by kick · answer · seen · y.
struct KickedFlow {
  /// Row i becomes diagonal_i y_i + beside_i y_partner(i); the rows of a block follow each other.
  struct Step {
    const double *diagonal, *beside;
  };
  std::ptrdiff_t states = 0, forces = 0, values = 0, steps = 0;
  const double* seen = nullptr;     ///< values × states, by rows
  const double* answers = nullptr;  ///< forces × values of one step after another, by rows
  const double* kick = nullptr;     ///< states × forces, by rows
  const char* leads = nullptr;      ///< is this row the first of a block of two?
  Step half{}, whole{};
};

/// Takes them: half a step first and last, whole ones between the kicks.
/// @param y       states × columns, by rows, aligned to a cache line
/// @param columns  up to the stride; the rest of their last pack changes too
/// @param stride  numbers from row to row, a multiple of longest_pack
void take_kicked_steps(const KickedFlow& flow, double* y, std::ptrdiff_t columns, std::ptrdiff_t stride);

}  // namespace trivet::numerics
