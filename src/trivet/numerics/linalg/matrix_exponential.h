// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace trivet::numerics {

/// e^A by scaling, squaring and a Padé approximant of degree 7, to round-off of the largest entries. Directions that
/// decay quickly come out as zero. Not finite if A is not. [Higham, SIAM J. Matrix Anal. Appl. 26 (2005) 1179–1193]
[[nodiscard]] Eigen::MatrixXd matrix_exponential(const Eigen::MatrixXd& A);

}  // namespace trivet::numerics
