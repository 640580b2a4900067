// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace trivet::fem {

/// Plane mesh of nine-node quadrilaterals, their lattice 3×3 row by row, counter-clockwise.
struct Section {
  Eigen::Matrix2Xd points;  ///< [m]
  std::vector<std::array<int, 9>> quads;
  std::vector<int> inner, outer;  ///< nodes of the inner and outer circle of a ring
};

/// Places 0 … 1 of the ends of `count` intervals that shrink as tanh towards 1, down to the length `smallest` (even if
/// that is longer).
[[nodiscard]] std::vector<double> graded_to_one(int count, double smallest);
/// The same towards both ends; `count` is even.
[[nodiscard]] std::vector<double> graded_to_both(int count, double smallest);

/// Grid between the given lines, x and y [m].
[[nodiscard]] Section rectangle(const std::vector<double>& x, const std::vector<double>& y);
/// Bulged square of core × core quadrilaterals, of about 0.55 of the radius, and 4 · core columns around it, divided at
/// 0 … 1 from core to rim.
[[nodiscard]] Section disc(double radius, int core, const std::vector<double>& to_rim);
/// `around` columns between two circles, divided at 0 … 1 from the inner to the outer.
[[nodiscard]] Section ring(double inner_radius, double outer_radius, int around, const std::vector<double>& to_outside);

}  // namespace trivet::fem
