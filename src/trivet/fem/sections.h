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

/// Ends, from 0 to 1, of `count` intervals that get shorter as tanh towards 1, down to the length `smallest`; equal
/// intervals if `smallest` is longer than these.
[[nodiscard]] std::vector<double> graded_to_one(int count, double smallest);
/// The same towards both ends; `count` is even.
[[nodiscard]] std::vector<double> graded_to_both(int count, double smallest);

/// Grid between the given lines, x and y [m].
[[nodiscard]] Section rectangle(const std::vector<double>& x, const std::vector<double>& y);
/// Bulged square of core × core quadrilaterals, of about 0.55 of the radius, and 4 · core columns around it; `to_rim`:
/// divisions from core (0) to rim (1).
[[nodiscard]] Section disc(double radius, int core, const std::vector<double>& to_rim);
/// `around` columns between two circles; `to_outside`: divisions from the inner (0) to the outer (1).
[[nodiscard]] Section ring(double inner_radius, double outer_radius, int around, const std::vector<double>& to_outside);

}  // namespace trivet::fem
