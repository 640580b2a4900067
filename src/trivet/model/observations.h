// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

/// What is observed between parts of a model: relative motions, section forces, clearances. Frames and signs:
/// docs/conventions.md.
namespace trivet::model {

struct Body;
struct Description;

/// The pole or a point of a body, a node, or the rigid ground at the place of the other end.
struct Place {
  std::string name;                              ///< "machine.flange", "machine", "ground"
  std::optional<std::size_t> body;               ///< none: the ground
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< in the frame of the body [m]
};

/// Motion of one place less that of another, along and about the columns of `axes`.
struct RelativeMotion {
  std::string name;
  Place of, to;
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< e3 is the axis of the joint; ground frame
};

/// Components of a relative motion, in the order of three translations and three rotations about e1, e2, e3.
inline constexpr std::array<const char*, 6> relative_components = {"radial_1",  "radial_2",  "axial",
                                                                   "angular_1", "angular_2", "torsion"};

/// Sum of the wrenches that elements exert on their N side, about a point.
struct Section {
  std::string name;
  std::vector<std::size_t> elements;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();        ///< ground frame, at rest [m]
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< as columns, ground frame
};

/// Free distance between two places, without gravity and constant forces.
struct Clearance {
  std::string name;
  Place of, to;
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< from `of` to `to`: unit vector, ground frame
  double gap = 0;                                        ///< [m]
};

/// Name of the result of a clearance: how far its places move towards each other, NAME.approach.
inline constexpr const char* approach_component = "approach";

/// In the ground frame, at rest; none for the ground.
[[nodiscard]] std::optional<Eigen::Vector3d> position(const std::vector<Body>& bodies, const Place& place);

/// True if no element holds a direction of a node that this component of the place's motion contains: it is left out of
/// the model. @param axis  unit vector of the translation (j < 3) or rotation, ground frame
[[nodiscard]] bool is_left_out(const std::vector<Body>& bodies, const Place& place, const Eigen::Vector3d& axis,
                               bool rotation);
/// True for component j of a relative motion, if it is left out at one of its places.
[[nodiscard]] bool is_left_out(const std::vector<Body>& bodies, const RelativeMotion& motion, int j);

}  // namespace trivet::model
