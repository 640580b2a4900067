// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/numerics/roots/designs.h"

namespace trivet::numerics {

inline constexpr int most_pairs = 12;  ///< of roots, and most coordinates, in kernels for designs
inline constexpr int table_lanes = 8;  ///< designs of one table

/// Roots and residues of eight designs: q(s) = Σ_k r_k / (s − λ_k) over all roots. Roots come in pairs, as (re, im > 0)
/// of one of two conjugates, or as two real ones; residues likewise.
struct RootTable {
  using Row = double[table_lanes];
  int coordinates = 0;
  alignas(64) Row first[most_pairs], second[most_pairs];
  alignas(64) Row real[most_pairs];                                                   ///< 1: two real roots, else 0
  alignas(64) Row r_first[most_pairs][most_pairs], r_second[most_pairs][most_pairs];  ///< [pair][coordinate]
  alignas(64) Row mass[most_pairs];                                                   ///< A_jj
  alignas(64) Row round_off;   ///< of sums over these roots, against the sums of their terms' moduli
  bool definite[table_lanes];  ///< A is positive definite
  bool good[table_lanes];      ///< all roots found, decaying, and far enough from defective
};

/// Designs first … first + 7 (the last of all again where they end), at most twelve coordinates.
void roots_of_designs(const Designs& designs, Eigen::Index first, RootTable& table);

/// One design by an eigensolver of its states, with a check by the sums that residues keep. @return whether they are
/// good
bool roots_of_states(const DynamicMatrices& matrices, const Eigen::VectorXd& load, RootTable& table, int lane);

}  // namespace trivet::numerics
