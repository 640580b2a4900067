// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <complex>
#include <memory>
#include <string>
#include <vector>

#include "trivet/elements/law.h"
#include "trivet/model/system.h"

namespace trivet::project {

/// Measured mobility v = Y F of one or several ground points in their compliant directions, ground axes. Y is symmetric
/// and interpolated linearly, which keeps Re Y positive semidefinite.
struct GroundMobility {
  struct Direction {
    std::size_t point = 0;
    int coordinate = 0;  ///< x, y, z, θx, θy, θz
    std::string name;    ///< of its driving-point mobility in the file: "y_z_z", "12:+z"
    double causality_rms =
        0;  ///< distance from the nearest passive, causal mobility, found by `judge_mobility` (mobility_checks.h)
  };
  std::vector<Direction> directions;
  std::vector<double> knots;           ///< [rad/s]
  std::vector<Eigen::MatrixXcd> rows;  ///< Y at each knot [(m/s)/N …]
  std::string source;                  ///< file, for messages
  std::vector<int> lines;              ///< of each knot in the file; empty if a knot has no line of its own

  /// Compliant coordinates of a point.
  [[nodiscard]] std::vector<int> coordinates(std::size_t point) const;
  /// Dynamic stiffness iω Y⁻¹ of all directions; for complex ω the piece of the table at `near` is continued.
  [[nodiscard]] Eigen::MatrixXcd dynamic_stiffness(std::complex<double> omega, double near) const;
};

/// Gives the element from the ground (N) to a ground point (K) the dynamic stiffness of that point with all other
/// points fixed.
void join_to_ground(const std::shared_ptr<const GroundMobility>& mobility, std::size_t point, model::Element& element);

/// Gives the element from one ground point (N) to another (K) their coupling: a motion of one relative to the ground
/// causes a force on the other.
void couple(const std::shared_ptr<const GroundMobility>& mobility, std::size_t n, std::size_t k,
            model::Element& element);

}  // namespace trivet::project
