// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <complex>
#include <limits>
#include <vector>

#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/sparse_system.h"

namespace trivet::numerics {

/// Share of the norm below which a pivot is only round-off.
constexpr double negligible_pivot(int n) { return 16 * n * std::numeric_limits<double>::epsilon(); }

/// Solution of Z x = h by LU with partial pivoting and one step of refinement.
struct PivotedSolution {
  Eigen::VectorXcd x;         ///< NaN if Z is singular
  double backward_error = 0;  ///< ‖Zx − h‖∞ / (‖Z‖∞ ‖x‖∞ + ‖h‖∞); NaN if Z is singular
  double condition = 0;       ///< condition number of Z, estimated, if requested; infinite if Z is singular
};

/// @param Z  scaled so that its rows and columns are comparable in size
[[nodiscard]] PivotedSolution pivoted_solution(const Eigen::MatrixXcd& Z, const Eigen::VectorXcd& h,
                                               bool with_condition = false);

/// One entry of a matrix in extended precision that is mostly zero.
struct ExtendedEntry {
  Eigen::Index row, column;
  std::complex<long double> value;
};

/// Solves Z x = b to nearly extended precision: pivoted LU in double (sparse if Z is) with residuals in long double,
/// refined until converged; if it does not converge, LU in long double. Accurate even at a resonance with damping ratio
/// 1e-6, where plain double keeps ten digits.
class RefinedSolver {
 public:
  /// Z in extended precision, scaled so that its rows and columns are comparable in size.
  explicit RefinedSolver(const ExtendedMatrix& Z);
  /// The same of the entries that are not zero, each place once.
  RefinedSolver(Eigen::Index size, std::vector<ExtendedEntry> entries);

  [[nodiscard]] ExtendedVector solve(const ExtendedVector& b) const;
  /// Condition number ‖Z⁻¹‖₁ ‖Z‖₁, estimated from the factors by a few solutions. (Hager 1984)
  [[nodiscard]] double condition() const;

 private:
  Eigen::Index size_;
  std::vector<ExtendedEntry> entries_;
  SparseSystem system_;
  SystemFactors factors_;
};

}  // namespace trivet::numerics
