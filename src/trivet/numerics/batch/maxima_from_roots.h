// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/numerics/roots/root_table.h"

namespace trivet::numerics {

/// Largest |q_j| of eight designs over a list of frequencies, and the lowest ω [rad/s] at which it occurs.
struct TableMaxima {
  alignas(64) RootTable::Row amplitude[most_pairs], angular_frequency[most_pairs];
  bool known[table_lanes];  ///< known to nine digits: no sum cancels, and the load moves each coordinate by more than
                            ///< round-off or not at all (then the amplitude is 0)
};

/// From partial fractions of |q_j|² in ω², a few operations per frequency; for designs with good roots.
/// @param omega  at least one
void maxima_from_roots(const RootTable& table, const std::vector<double>& omega, TableMaxima& maxima);

}  // namespace trivet::numerics
