// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <compare>
#include <vector>

#include "trivet/foundation/problems.h"

/// Matrices from other programs, in the units, axes and order of their files.
namespace trivet::exchange {

/// Largest number of rows; such a matrix takes 288 MB.
inline constexpr int largest_order = 6000;

/// One degree of freedom of a finite-element model: 1, 2, 3 translations along and 4, 5, 6 rotations about x, y, z of a
/// node; component 0 is a scalar point.
struct Label {
  int node = 0;
  int component = 0;
  auto operator<=>(const Label&) const = default;
};

/// A square matrix with the labels of its rows (and columns).
struct NamedMatrix {
  Eigen::MatrixXd values;     ///< real part
  Eigen::MatrixXd imaginary;  ///< empty if the file is real
  std::vector<Label> labels;  ///< one per row; empty if the format has none
  foundation::Problems warnings;
};

}  // namespace trivet::exchange
