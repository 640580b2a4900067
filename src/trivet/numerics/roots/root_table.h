// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/numerics/roots/designs.h"

namespace trivet::numerics {

inline constexpr int most_pairs = 12;  ///< largest number of root pairs and of coordinates in kernels for designs
inline constexpr int table_lanes = 8;  ///< designs per table

/// Roots and residues of eight designs: q(s) = Σ_k r_k / (s − λ_k) over all roots. Roots come in pairs: (re, im > 0) of
/// one of two conjugates, or two real roots; residues in the same form.
struct RootTable {
  using Row = double[table_lanes];
  int coordinates = 0;
  alignas(64) Row first[most_pairs], second[most_pairs];
  alignas(64) Row real[most_pairs];                                                   ///< 1: two real roots, else 0
  alignas(64) Row r_first[most_pairs][most_pairs], r_second[most_pairs][most_pairs];  ///< [pair][coordinate]
  alignas(64) Row mass[most_pairs];                                                   ///< A_jj
  alignas(64) Row round_off;   ///< of sums over these roots, relative to the sums of the moduli of their terms
  bool definite[table_lanes];  ///< A is positive definite
  bool good[table_lanes];      ///< all roots found, decaying, and not nearly defective
};

/// Roots of designs first … first + 7 (past the end, the last design is repeated), at most twelve coordinates.
void roots_of_designs(const Designs& designs, Eigen::Index first, RootTable& table);

/// Roots of one design by an eigensolver of its states, checked by sum rules of the residues. @return whether they are
/// good
bool roots_of_states(const DynamicMatrices& matrices, const Eigen::VectorXd& load, RootTable& table, int lane);

}  // namespace trivet::numerics
