// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/numerics/roots/designs.h"

namespace trivet::numerics {

// Single designs of a batch at one frequency, from their equations.

/// K − ω²A + i (D + ωB)
[[nodiscard]] Eigen::MatrixXcd driven_stiffness(const DrivenDesigns& designs, Eigen::Index design, double omega);

/// Σ sᵖ value_p over the terms of a load or a row, s = iω.
[[nodiscard]] Eigen::VectorXcd sum_of_terms(const std::vector<DesignTerm>& terms, Eigen::Index design, double omega);

/// |y| of all curves; NaN where the stiffness is singular.
[[nodiscard]] Eigen::ArrayXd driven_magnitudes(const DrivenDesigns& designs, Eigen::Index design, double omega);

}  // namespace trivet::numerics
