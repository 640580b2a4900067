// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "trivet/numerics/periodic/branch.h"

namespace trivet::test {

/// u³ − 3u = λ: folds at u = ±1, λ = ∓2.
inline void cubic_with_two_folds(const Eigen::VectorXd& u, double parameter, numerics::Equations& equations) {
  equations.value = Eigen::VectorXd::Constant(1, u(0) * u(0) * u(0) - 3 * u(0) - parameter);
  equations.by_unknowns = Eigen::MatrixXd::Constant(1, 1, 3 * u(0) * u(0) - 3);
  equations.by_parameter = Eigen::VectorXd::Constant(1, -1);
}

}  // namespace trivet::test
