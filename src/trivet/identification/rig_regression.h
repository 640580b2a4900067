// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "trivet/identification/grouped_regression.h"
#include "trivet/identification/stiffness_fit.h"

namespace trivet::identification {

/// The matrix as a sum of constants: C = Σ constant_p · matrices[p]. Constants are scaled to similar size.
struct Basis {
  std::vector<Matrix12> matrices;
  std::vector<std::array<int, 2>> entry;  ///< row and column of each constant in the 12×12
  Eigen::VectorXd unit;                   ///< value of a constant that is 1 in the regression
};

/// Regression with the meaning of its rows.
struct Rig {
  Basis basis;
  Regression regression;
  std::vector<std::array<int, 2>> reading;  ///< load case and channel of each row
  std::vector<int> offset_channel;          ///< channel of each offset column
};

/// Typical translation and rotation of the load cases (1 if there is none).
[[nodiscard]] std::array<double, 2> typical_motion(const std::vector<LoadCase>& cases);

/// The load cases as a regression for the constants, and, if requested, for zero offsets.
[[nodiscard]] Rig rig_regression(const std::vector<LoadCase>& cases, const Eigen::Vector3d& arm,
                                 const StiffnessFitOptions& options);

}  // namespace trivet::identification
