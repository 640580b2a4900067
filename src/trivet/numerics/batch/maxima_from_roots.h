// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/numerics/roots/root_table.h"

namespace trivet::numerics {

/// Largest |q_j| of eight designs over a list of frequencies, and the lowest ω where it stands [rad/s].
struct TableMaxima {
  alignas(64) RootTable::Row amplitude[most_pairs], angular_frequency[most_pairs];
  bool known[table_lanes];  ///< to nine digits: no sum cancels, and the load moves each coordinate beyond round-off or
                            ///< not at all (then the amplitude is 0)
};

/// By partial fractions of |q_j|² in ω², a few operations a frequency; of designs whose roots are good.
/// @param omega  one at least
void maxima_from_roots(const RootTable& table, const std::vector<double>& omega, TableMaxima& maxima);

}  // namespace trivet::numerics
