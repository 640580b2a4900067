// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <complex>
#include <utility>
#include <vector>

#include "trivet/assembly/assembled.h"

namespace trivet::assembly {

/// Translations and rotations as linear functions of the coordinates and of the ground coordinates in space.
struct MotionRows {
  Eigen::Matrix<double, 6, Eigen::Dynamic> on_coordinates, on_ground;
};

/// Motion of one place less that of another, along and about the columns of `axes` (ground frame). The ground moves
/// rigidly; its motion is that at the other place. Directions of nodes that are left out count as zero.
[[nodiscard]] MotionRows motion_between(const model::System& system, const Assembled& assembled, const model::Place& of,
                                        const model::Place& to, const Eigen::Matrix3d& axes);

/// A wrench as a linear function of the coordinates, of the ground coordinates, and of their derivatives.
struct WrenchRows {
  using Real = Eigen::Matrix<double, 6, Eigen::Dynamic>;
  using Complex = Eigen::Matrix<std::complex<double>, 6, Eigen::Dynamic>;
  Complex on_displacement, ground_displacement;
  Real on_velocity, on_acceleration, ground_velocity, ground_acceleration;
  std::vector<std::pair<std::size_t, Eigen::Matrix<double, 6, 12>>> dynamic;  ///< element, rows on D(ω)
  spatial::Vector6 at_rest = spatial::Vector6::Zero();  ///< preload, and gravity on the element's own mass

  /// No wrench.
  explicit WrenchRows(const Assembled& assembled);
  /// Adds another wrench times a matrix, which carries it to another point or turns it.
  void add(const spatial::Matrix6& carry, const WrenchRows& other);
};

/// Wrench that element e exerts on its N side, ground axes, about the reference point of N.
[[nodiscard]] WrenchRows wrench_on_n(const model::System& system, const Assembled& assembled, std::size_t e);

/// Sum of the wrenches on the N sides of the elements of a section.
[[nodiscard]] WrenchRows section_wrench(const model::System& system, const Assembled& assembled,
                                        const model::Section& section);

}  // namespace trivet::assembly
