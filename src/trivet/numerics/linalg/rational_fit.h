// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace trivet::numerics {

/// Several rational functions with one denominator, in barycentric form: r(x) = Σ_j w_j v_j/(x − x_j) / Σ_j w_j/(x −
/// x_j). They pass through their nodes, whatever the weights.
struct RationalFit {
  Eigen::VectorXd nodes;     ///< x_j
  Eigen::VectorXcd weights;  ///< w_j
  Eigen::MatrixXcd values;   ///< functions × nodes
  double error = 0;          ///< largest at the samples that are no nodes, in units of their scale

  /// Functions × points.
  [[nodiscard]] Eigen::MatrixXcd at(const Eigen::VectorXd& x) const;
  /// Zeros of the denominator, with one more at 0 that means nothing.
  [[nodiscard]] Eigen::VectorXcd poles() const;
};

/// Fits samples by the set-valued AAA algorithm: the sample that is worst becomes a node, until none is off by more
/// than `tolerance`, or there are as many weights as equations for them. Weights are the singular vector of the
/// smallest singular value of the Loewner matrix whose rows are divided by the scales. [Nakatsukasa, Sète, Trefethen
/// 2018, SIAM J. Sci. Comput. 40(3), A1494; set-valued: Lietaert, Meerbergen, Pérez, Vandereycken 2022, IMA J. Numer.
/// Anal. 42(4), 3087]
/// @param x        ascending, at least 2
/// @param values   functions × samples, finite
/// @param scales   likewise, > 0: in what an error counts as 1
[[nodiscard]] RationalFit rational_fit(const Eigen::VectorXd& x, const Eigen::MatrixXcd& values,
                                       const Eigen::MatrixXd& scales, double tolerance);

}  // namespace trivet::numerics
