// SPDX-License-Identifier: BSD-3-Clause
// Kernels of the frequency sweep, one frequency per lane: compiled for each instruction set, chosen at run time. A
// plane holds one number at all frequencies of a batch in sequence; omega and planes are padded to whole packs by
// repeating the last frequency.
#pragma once

#include <vector>

#include "trivet/numerics/lanes/planes.h"
#include "trivet/numerics/linalg/dynamic_matrices.h"
#include "trivet/numerics/linalg/refined_solution.h"

namespace trivet::numerics::sweep_kernels {

/// Frequencies in the widest pack: batches are padded to a multiple of it, those of `solve_fixed` to a multiple of two
/// packs.
inline constexpr long widest_pack = 8;
inline constexpr long granule = 2 * widest_pack;
constexpr long filled_up(long count, long whole) { return (count + whole - 1) / whole * whole; }
/// Largest number of coordinates with unrolled loops.
inline constexpr int most_fixed = 6;

/// Largest √Σ_j (|d_j| ‖l_j‖²)² / ‖Z‖_F over the columns of L and pivots d for which a factorisation without pivoting
/// is trusted: docs/decisions/no-pivoting-first.md.
inline constexpr double growth_allowed = 16;

/// Z(ω) = K + iK_loss + iωB − ω²A in scaled coordinates, all n × n in rows.
struct Coefficients {
  Coefficients(const DynamicMatrices& m);

  int n = 0;
  std::vector<double> K, A, B, K_loss;
  double norm[4] = {};   ///< ‖Z‖²_F ≥ norm[0] + norm[1] ω + norm[2] ω² + norm[3] ω⁴
  double first[4] = {};  ///< the same for the sum of squares of the first column, but ≤
};

/// Coordinates q = T q̃ in which a real load acts on the last one only. To go back, q̃_n −= Σ ratio_i q̃_i, then
/// coordinate i is `order[i]`.
struct Aim {
  std::vector<double> ratio;  ///< n − 1, each ≤ 1 in magnitude
  std::vector<int> order;     ///< n
};

/// Inputs and outputs of one batch. Solutions are in physical coordinates, q = scale · q̃.
struct Batch {
  const double* omega = nullptr;
  long count = 0;  ///< padded: see `widest_pack`
  Planes load;     ///< n planes in scaled coordinates; for an aimed system only the last one
  Planes extra;    ///< n² planes added to Z, or null: frequency-dependent parts
  const double* scale = nullptr;
  Planes q;
  double* error = nullptr;  ///< growth or backward error, see each kernel
};

/// LDLᵀ without pivoting, n ≤ `most_fixed`, with unrolled loops. `z` is in the coordinates of `aim`; null: any load in
/// plain coordinates. error: 1 if growth above `growth_allowed` or a negligible pivot makes the result unusable.
/// @return whether all results are usable
[[nodiscard]] bool solve_fixed(const Coefficients& z, const Aim* aim, const Batch& batch);

/// LU with partial pivoting, lane by lane with masks, any n, symmetric or not. error: 1 if a pivot is negligible, else
/// 0.
[[nodiscard]] bool solve_pivoted(const Coefficients& z, const Batch& batch);

/// error: ‖Zq − h‖∞ / (‖Z‖∞ ‖q‖∞ + ‖h‖∞) in scaled coordinates, |re| + |im| for the modulus (within √2).
void backward_errors(const Coefficients& z, const Batch& batch);

}  // namespace trivet::numerics::sweep_kernels
