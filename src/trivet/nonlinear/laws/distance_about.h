// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "trivet/elements/distance_force.h"

namespace trivet::nonlinear {

/// A distance force over the deviation from rest and its rate, beyond the stiffness and damping that the linear machine
/// contains in its place: the tangents at rest, or another stiffness.
class DistanceAbout {
 public:
  explicit DistanceAbout(elements::DistanceForce law, const Eigen::Vector3d& at_rest = Eigen::Vector3d::Zero());
  DistanceAbout(elements::DistanceForce law, const Eigen::Vector3d& at_rest, const Eigen::Matrix3d& stiffness);

  [[nodiscard]] elements::SpatialForce at(const Eigen::Vector3d& deviation, const Eigen::Vector3d& rate) const;
  /// ∫ over the deviation from 0, with that stiffness [J].
  [[nodiscard]] double energy(const Eigen::Vector3d& deviation) const;
  [[nodiscard]] double distance(const Eigen::Vector3d& deviation) const { return law_.distance(at_rest_ + deviation); }
  /// Distances for which all forces are known [m].
  [[nodiscard]] std::pair<double, double> range() const;
  /// Distances at which it is not smooth.
  [[nodiscard]] const std::vector<double>& kinks() const { return kinks_; }
  /// The deviation to the same length on the other side, along one axis: where a strut has snapped through.
  [[nodiscard]] double mirrored(Eigen::Index axis) const { return -2 * (law_.offset(axis) + at_rest_(axis)); }
  /// A stop within a ring.
  [[nodiscard]] bool is_ring() const { return law_.across; }
  [[nodiscard]] bool has_dampers() const { return has_dampers_; }
  /// Deviation that brings the points to their farthest kink, or a tenth of their distance if that is more [m].
  [[nodiscard]] double extent() const;

 private:
  elements::DistanceForce law_;
  Eigen::Vector3d at_rest_;
  elements::SpatialForce there_;  ///< by_deflection: the stiffness in the linear machine
  std::vector<double> kinks_;
  bool has_dampers_ = false;
};

}  // namespace trivet::nonlinear
