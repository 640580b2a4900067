// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace trivet::numerics {

/// A matrix of up to 12 rows and columns without heap memory.
template <typename Scalar>
using UpToTwelve = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 12, 12>;

}  // namespace trivet::numerics
