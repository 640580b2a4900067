// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace trivet::numerics {

/// Several rational functions with a common denominator, in barycentric form: r(x) = Σ_j w_j v_j/(x − x_j) / Σ_j w_j/(x
/// − x_j). They interpolate at their nodes for any weights.
struct RationalFit {
  Eigen::VectorXd nodes;     ///< x_j
  Eigen::VectorXcd weights;  ///< w_j
  Eigen::MatrixXcd values;   ///< functions × nodes
  double error = 0;          ///< largest at samples that are not nodes, in units of their scale

  /// Values, functions × points.
  [[nodiscard]] Eigen::MatrixXcd at(const Eigen::VectorXd& x) const;
  /// Shares of the nodes in a value, nodes × points: at(x) = values × shares(x).
  [[nodiscard]] Eigen::MatrixXcd shares(const Eigen::VectorXd& x) const;
  /// Zeros of the denominator, and an additional meaningless one at 0.
  [[nodiscard]] Eigen::VectorXcd poles() const;
};

/// Fits samples by the set-valued AAA algorithm: the sample with the largest error becomes a node until all errors are
/// ≤ `tolerance`, or there are as many weights as equations. The weights are the singular vector of the smallest
/// singular value of the Loewner matrix with rows divided by the scales. [Nakatsukasa, Sète, Trefethen 2018, SIAM J.
/// Sci. Comput. 40(3), A1494; set-valued: Lietaert, Meerbergen, Pérez, Vandereycken 2022, IMA J. Numer. Anal. 42(4),
/// 3087]
/// @param x        ascending, at least 2
/// @param values   functions × samples, finite
/// @param scales   functions × samples, > 0: an error of this size counts as 1
/// @param first    samples that become nodes at once, such as the nodes of a fit of fewer samples; may be empty
[[nodiscard]] RationalFit rational_fit(const Eigen::VectorXd& x, const Eigen::MatrixXcd& values,
                                       const Eigen::MatrixXd& scales, double tolerance,
                                       const Eigen::VectorXd& first = {});

/// From this number of functions on, the weights of a fit come from random combinations of them, which takes a fraction
/// of the time; the error is always that of all functions.
inline constexpr Eigen::Index many_functions = 48;

}  // namespace trivet::numerics
