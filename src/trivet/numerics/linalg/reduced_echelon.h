// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace trivet::numerics {

/// Another basis of the space of the rows, which are orthonormal: each row has a 1 where the others have 0, in a column
/// as far left as possible. Entries below 1e-9 are zero.
[[nodiscard]] Eigen::MatrixXd reduced_echelon(Eigen::MatrixXd rows);

}  // namespace trivet::numerics
