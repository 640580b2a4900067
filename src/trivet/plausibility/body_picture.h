// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "trivet/model/system.h"

namespace trivet::plausibility {

/// One end of an element on a body, with the other end fixed. Body frame, from the pole.
struct Attachment {
  std::size_t element = 0;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  Eigen::Matrix3d translation = Eigen::Matrix3d::Zero();  ///< K = [translation, coupling; couplingᵀ, rotation] at `at`
  Eigen::Matrix3d coupling = Eigen::Matrix3d::Zero();
  /// rotation − couplingᵀ translation⁺ coupling: what remains about its elastic centre
  Eigen::Matrix3d own_rotation = Eigen::Matrix3d::Zero();
  /// trace of its translational viscous damping [N s/m], without the part proportional to its stiffness
  double viscous = 0;
  double proportional = 0;  ///< B = proportional · K [s]
  bool typed = false;       ///< its stiffness was given as a number with a unit, not by dimensions
  /// On a foundation with modes: its index, and sᵀ K s over the stiffness of each mode s.
  std::optional<std::size_t> foundation;
  Eigen::VectorXd over_modes;

  [[nodiscard]] bool elastic() const { return translation.trace() > 0; }
};

/// Data of a body that are checked: mass, elements that hold it, positions of its points and forces.
struct BodyPicture {
  std::size_t body = 0;
  spatial::MassProperties mass;
  bool inertia_about_pole = false, from_solids = false;
  bool allowed = false;  ///< unphysical, but allowed: only magnitudes are checked
  std::vector<Attachment> attachments;
  std::vector<Eigen::Vector3d> points;  ///< of points and forces, from the pole [m]
};

/// One possible unit error: the factors from the values typed to those intended.
struct Slip {
  const char* kind = "";
  const char* words = "";  ///< "typed in grams"
  double mass = 1, inertia = 1, centre = 1, stiffness = 1, rotation = 1, places = 1, points = 1, damping = 1;
};

/// Quantities that are compared with experience; empty if the picture does not determine them.
struct Features {
  std::optional<double> density;  ///< mass / (2 × rms distance of the mass from its centre)³ [kg/m³]
  /// rms distance of the attachments from the centre of mass / that of the mass
  std::optional<double> spread;
  std::optional<double> lever;      ///< the same of the stiffness: lever arm of the springs
  std::optional<double> reach;      ///< median distance of points and forces / that of the mass
  std::optional<double> frequency;  ///< geometric mean of the natural frequencies of translation, rotation fixed [Hz]
  std::optional<double> sag;        ///< static deflection under the weight / size of the body
  std::optional<double> damping_ratio;  ///< at that frequency, from the viscous damping of the elements
  std::optional<double> over_floor;  ///< stiffness of all elements on a foundation over its own, largest of its modes
  std::optional<double> lowest,
      highest;           ///< natural frequencies of the body alone on its elements, without zeros [Hz]
  bool possible = true;  ///< false if no real body has such mass properties
};

/// Pictures of the bodies that can be checked: those that are free in all six coordinates.
[[nodiscard]] std::vector<BodyPicture> pictures(const model::System& system,
                                                const std::vector<bool>& inertia_about_pole,
                                                const std::vector<bool>& from_solids);

/// The features after correction of one slip.
[[nodiscard]] Features features(const BodyPicture& picture, const Slip& undone);

/// Stiffness of all its elements about the centre of mass, their other ends fixed; body frame.
[[nodiscard]] spatial::Matrix6 stiffness_about_centre(const BodyPicture& picture);

/// Rms distance of the mass from its centre [m].
[[nodiscard]] double mass_radius(const spatial::MassProperties& mass);

}  // namespace trivet::plausibility
