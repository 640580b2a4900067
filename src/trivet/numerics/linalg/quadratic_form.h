// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace trivet::numerics {

/// vᵀ M v of a symmetric M, summed in extended precision.
[[nodiscard]] long double quadratic_form(const Eigen::MatrixXd& M, const Eigen::Ref<const Eigen::VectorXd>& v);

}  // namespace trivet::numerics
