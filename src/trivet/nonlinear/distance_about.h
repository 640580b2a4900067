// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/elements/distance_force.h"

namespace trivet::nonlinear {

/// A distance force over the deviation from rest and its rate, beyond the tangents at rest, which the linear machine
/// contains in its place.
class DistanceAbout {
 public:
  explicit DistanceAbout(elements::DistanceForce law, const Eigen::Vector3d& at_rest = Eigen::Vector3d::Zero());

  [[nodiscard]] elements::SpatialForce at(const Eigen::Vector3d& deviation, const Eigen::Vector3d& rate) const;
  /// ∫ over the deviation from 0, with the tangent [J].
  [[nodiscard]] double energy(const Eigen::Vector3d& deviation) const;
  [[nodiscard]] double distance(const Eigen::Vector3d& deviation) const { return law_.distance(at_rest_ + deviation); }
  /// Distances at which it is not smooth.
  [[nodiscard]] const std::vector<double>& kinks() const { return kinks_; }
  [[nodiscard]] bool has_dampers() const { return has_dampers_; }
  /// Deviation that brings the points to their nearest kink, or a tenth of their distance.
  [[nodiscard]] double extent() const;

 private:
  elements::DistanceForce law_;
  Eigen::Vector3d at_rest_;
  elements::SpatialForce there_;
  std::vector<double> kinks_;
  bool has_dampers_ = false;
};

}  // namespace trivet::nonlinear
