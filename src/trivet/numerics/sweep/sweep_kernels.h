// SPDX-License-Identifier: BSD-3-Clause
// Kernels of the frequency sweep, one frequency per lane: compiled for each instruction set, chosen at run time. Planes
// hold one number of all frequencies of a batch side by side; omega and planes are filled up to whole packs by
// repeating the last frequency.
#pragma once

#include <vector>

#include "trivet/numerics/lanes/planes.h"
#include "trivet/numerics/linalg/dynamic_matrices.h"
#include "trivet/numerics/linalg/pivoted_solution.h"

namespace trivet::numerics::sweep_kernels {

/// Frequencies in the widest pack: batches are filled up to a multiple of it, those of `solve_fixed` to a multiple of
/// two packs.
inline constexpr long widest_pack = 8;
inline constexpr long granule = 2 * widest_pack;
constexpr long filled_up(long count, long whole) { return (count + whole - 1) / whole * whole; }
/// Coordinates up to which loops are written out.
inline constexpr int most_fixed = 6;

/// Most √Σ_j (|d_j| ‖l_j‖²)² / ‖Z‖_F over the columns of L and pivots d for which a factorisation without pivoting is
/// trusted: docs/decisions/no-pivoting-first.md.
inline constexpr double growth_allowed = 16;

/// Z(ω) = K + iK_loss + iωB − ω²A in scaled coordinates, all n × n in rows.
struct Coefficients {
  Coefficients(const DynamicMatrices& m);

  int n = 0;
  std::vector<double> K, A, B, K_loss;
  double norm[4] = {};   ///< ‖Z‖²_F ≥ norm[0] + norm[1] ω + norm[2] ω² + norm[3] ω⁴
  double first[4] = {};  ///< the sum of squares of the first column likewise, ≤
};

/// Coordinates q = T q̃ in which a real load lies along the last one: q̃_n −= Σ ratio_i q̃_i leads back, then coordinate i
/// is `order[i]`.
struct Aim {
  std::vector<double> ratio;  ///< n − 1, each ≤ 1 in magnitude
  std::vector<int> order;     ///< n
};

/// One batch: where to read and write. Solutions leave in physical coordinates, q = scale · q̃.
struct Batch {
  const double* omega = nullptr;
  long count = 0;  ///< filled up: see `widest_pack`
  Planes load;     ///< n planes in scaled coordinates; of an aimed system one, the last
  Planes extra;    ///< n² planes added to Z, or null: frequency-dependent parts
  const double* scale = nullptr;
  Planes q;
  double* error = nullptr;  ///< growth or backward error, see each kernel
};

/// LDLᵀ without pivoting, n ≤ `most_fixed`, loops written out. `z` is in the coordinates of `aim`; null: any load in
/// plain coordinates. error: set to 1 where `growth_allowed` or a negligible pivot forbids the result.
/// @return whether all are allowed
[[nodiscard]] bool solve_fixed(const Coefficients& z, const Aim* aim, const Batch& batch);

/// LU with partial pivoting, lane by lane by masks, any n, symmetric or not. error: 1 where a pivot is negligible, else
/// 0.
[[nodiscard]] bool solve_pivoted(const Coefficients& z, const Batch& batch);

/// error: ‖Zq − h‖∞ / (‖Z‖∞ ‖q‖∞ + ‖h‖∞) in scaled coordinates, |re| + |im| for the modulus (within √2).
void backward_errors(const Coefficients& z, const Batch& batch);

/// Raises square[j] to the largest |q_j|² of a batch and tells its frequency, the first of equals.
void raise_maxima(int n, const Batch& batch, double* square, double* angular_frequency);

}  // namespace trivet::numerics::sweep_kernels
