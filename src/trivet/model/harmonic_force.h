// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>

#include "trivet/model/system.h"

/// Harmonic forces of a model, along one direction or rotating, as transmissibilities are about them.
namespace trivet::model {

/// Axis along which two quantities of the same kind are compared, ground axes.
struct Direction {
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< any length > 0
  bool rotation = false;  ///< moment or rotation about the axis instead of force or translation along it
  bool operator==(const Direction&) const = default;
};

/// Force (or moment) applied to determine force transmissibility.
struct AppliedForce {
  std::size_t body = 0;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< body frame [m]
  Direction direction;
};

/// Point and direction of a harmonic force excitation of the model.
/// @throws foundation::InvalidInput if there is no such excitation, or if it moves the ground, has both force and
/// moment, or components of different phase (a rotating force)
[[nodiscard]] AppliedForce applied_force(const System& system, const std::string& excitation);

/// The harmonic force, or the moment, of an excitation: exactly one of them, in body axes.
struct HarmonicForce {
  const Action& action;
  Eigen::Vector3cd vector;
  bool rotation = false;

  /// The vector times the factor e^{−iφ} that makes its largest component real.
  [[nodiscard]] Eigen::Vector3cd in_phase_with_largest() const;
  /// Do its components differ in phase, so that its direction is not constant?
  [[nodiscard]] bool rotates() const;
};
/// @throws foundation::InvalidInput if there is no such excitation, or if it moves the ground, or has both force and
/// moment
[[nodiscard]] HarmonicForce harmonic_force(const System& system, const std::string& excitation);

/// Why there is no transmissibility (response::excitation_transmission) of an excitation; empty if there is one.
[[nodiscard]] std::string reason_without_transmission(const System& system, const std::string& excitation);

}  // namespace trivet::model
