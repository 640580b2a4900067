// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "trivet/model/system.h"

namespace trivet::plausibility {

/// One end of an element on a body, the other end held still. Body frame, from the pole.
struct Attachment {
  std::size_t element = 0;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  Eigen::Matrix3d translation = Eigen::Matrix3d::Zero();  ///< K = [translation, coupling; couplingᵀ, rotation] at `at`
  Eigen::Matrix3d coupling = Eigen::Matrix3d::Zero();
  /// rotation − couplingᵀ translation⁺ coupling: what remains about its elastic centre
  Eigen::Matrix3d own_rotation = Eigen::Matrix3d::Zero();
  /// trace of its translational viscous damping [N s/m], without what is proportional to its stiffness
  double viscous = 0;
  double proportional = 0;  ///< B = proportional · K [s]
  bool typed = false;       ///< its stiffness was given as a number with a unit, not by dimensions

  [[nodiscard]] bool elastic() const { return translation.trace() > 0; }
};

/// A body as it looks at first sight: mass, what holds it, and the places of its points and forces.
struct BodyPicture {
  std::size_t body = 0;
  spatial::MassProperties mass;
  bool inertia_about_pole = false, from_solids = false;
  bool allowed = false;  ///< impossible, and allowed to be: only magnitudes are looked at
  std::vector<Attachment> attachments;
  std::vector<Eigen::Vector3d> points;  ///< of points and forces, from the pole [m]
};

/// One single slip of unit, undone: the factors that lead from the numbers typed to those meant.
struct Slip {
  const char* kind = "";
  const char* words = "";  ///< "typed in grams"
  double mass = 1, inertia = 1, centre = 1, stiffness = 1, rotation = 1, places = 1, points = 1, damping = 1;
};

/// What an engineer compares with experience. Empty where a picture says nothing of it.
struct Features {
  std::optional<double> density;  ///< mass over the cube whose mass is as far from its centre, rms [kg/m³]
  /// rms distance of the attachments from the centre of mass over that of the mass
  std::optional<double> spread;
  std::optional<double> lever;      ///< the same of the stiffness: how far out the springs act
  std::optional<double> reach;      ///< median distance of points and forces over that of the mass
  std::optional<double> frequency;  ///< geometric mean of the natural frequencies of translation, rotation held [Hz]
  std::optional<double> sag;        ///< of these springs under the weight over the size of the body
  std::optional<double> damping_ratio;  ///< at that frequency, by the viscous damping of the elements
  std::optional<double> lowest,
      highest;           ///< natural frequencies of the body alone on its elements, zeros left out [Hz]
  bool possible = true;  ///< false if no real body has such a mass
};

/// Pictures of the bodies that can be judged: those that are free in all six coordinates.
[[nodiscard]] std::vector<BodyPicture> pictures(const model::System& system,
                                                const std::vector<bool>& inertia_about_pole,
                                                const std::vector<bool>& from_solids);

/// The features after one slip is undone.
[[nodiscard]] Features features(const BodyPicture& picture, const Slip& undone);

/// Of all its elements at the centre of mass, their other ends held still; body frame.
[[nodiscard]] spatial::Matrix6 stiffness_about_centre(const BodyPicture& picture);

/// Rms distance of the mass from its centre [m].
[[nodiscard]] double mass_radius(const spatial::MassProperties& mass);

}  // namespace trivet::plausibility
