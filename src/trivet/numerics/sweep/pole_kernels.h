// SPDX-License-Identifier: BSD-3-Clause
// Kernels of PoleSweep in lanes.
#pragma once

#include <Eigen/Core>

#include "trivet/numerics/roots/root_table.h"

namespace trivet::numerics {

/// Modal data of one system for its roots: one root per lane, each with its own order of the modes, the root's own mode
/// last.
struct RootsOfSystem {
  using Row = double[most_pairs];  ///< by root
  int n = 0;
  Row centre, below[most_pairs], above[most_pairs];  ///< i centre + offset; centre ∓ Ω of each mode
  Row b[most_pairs * (most_pairs + 1) / 2];          ///< by entry
  Row offset_re, offset_im;                          ///< start values, then results
  Row v_re[most_pairs], v_im[most_pairs];            ///< by mode
  Row slope_re, slope_im;
  bool converged = false;
};

/// Real coefficients of pairs of poles, and some frequencies; `stride` from one coordinate to the next in re and im.
struct PairsAtFrequencies {
  int n = 0;
  const double* pairs = nullptr;
  const double* omega = nullptr;
  Eigen::Index count = 0;
  double *re = nullptr, *im = nullptr;
  Eigen::Index stride = 0;
};

/// Z q = h of one system at some frequencies.
struct EquationAtFrequencies {
  int n = 0;
  const double *A = nullptr, *B = nullptr, *K = nullptr, *by_scale = nullptr, *load_re = nullptr, *load_im = nullptr;
  const double *omega = nullptr, *re = nullptr, *im = nullptr;
  Eigen::Index count = 0, stride = 0;
};

/// Iterates the roots from their start values.
void roots_of_system(RootsOfSystem& system);

/// Sums over the pairs, at eight frequencies or more. @param complex_load  each pair has residues for both parts
void pairs_at(const PairsAtFrequencies& sums, bool complex_load);

/// Largest backward error, with |re| + |im| for the modulus; infinite if a number is not finite.
[[nodiscard]] double worst_backward_error(const EquationAtFrequencies& equation);

}  // namespace trivet::numerics
