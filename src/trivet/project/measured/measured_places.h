// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <complex>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "trivet/exchange/universal/universal_file.h"
#include "trivet/foundation/problems.h"
#include "trivet/model/system.h"

namespace trivet::project {

/// A place where something is measured: a body, a node or a point of a body.
struct MeasuredPlace {
  std::string name;
  std::size_t body = 0;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();        ///< body frame [m]
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< ground frame [m]
};

/// Places of the model, and the nodes of a measurement at them.
class MeasuredPlaces {
 public:
  /// @param nodes  positions of nodes of the file in the ground frame
  /// @param axes   of displacements of nodes of the file as columns, where they are not those of the ground
  MeasuredPlaces(const model::Description& description, std::map<int, Eigen::Vector3d> nodes,
                 std::map<int, Eigen::Matrix3d> axes);

  /// Puts a node at the place of this name; false if there is no such place.
  [[nodiscard]] bool put(int node, const std::string& place);

  /// True if `put` gave this node its place.
  [[nodiscard]] bool is_put(int node) const { return put_.contains(node); }

  /// The place of a node: where it was put, or the place within 1 mm of its position. None if places of different
  /// bodies are equally near.
  [[nodiscard]] const MeasuredPlace* place(int node) const;
  /// Position of a node in the ground frame: that of its place, or of the file.
  [[nodiscard]] std::optional<Eigen::Vector3d> position(int node) const;

  /// Unit vector of a direction ±1 … ±6 of a node, in the ground frame.
  [[nodiscard]] Eigen::Vector3d direction_in_ground(const exchange::UniversalPoint& point) const;

  /// A component of the motion of a place, and the sign of the measured one.
  struct Component {
    std::string result;  ///< "machine.seat.z"
    double sign = 1;
  };
  /// The component that a node and direction measure; none without a place, or if the direction is not an axis of it.
  [[nodiscard]] std::optional<Component> component(const exchange::UniversalPoint& point) const;

  /// "3:+z at frame.seat" of a node and a direction; without a place "3:+z".
  [[nodiscard]] std::string words(const exchange::UniversalPoint& point) const;
  [[nodiscard]] std::vector<std::string> names() const;

 private:
  const model::Description& description_;
  std::map<int, Eigen::Vector3d> nodes_;
  std::map<int, Eigen::Matrix3d> axes_;
  std::vector<MeasuredPlace> places_;
  std::map<int, std::size_t> put_;
};

/// Distance within which places are the same [m].
inline constexpr double same_place = 1e-3;

/// The harmonic force by which functions per force are multiplied.
class MeasuredForce {
 public:
  MeasuredForce(const model::Description& description, const MeasuredPlaces& places, const model::Excitation& force)
      : description_(description), places_(places), force_(force) {}

  /// Reason why functions per force cannot be compared with this excitation: it is no force on a body.
  [[nodiscard]] std::optional<std::string> unsuitable() const;

  /// Amplitude along the reference of a function (its delay excluded); none if body, place or direction do not fit. A
  /// moment may be measured at any place of its body. Without a reference in the file (node 0), the measured force is
  /// positive along the axis of the body on which the excitation acts; a force along no axis is positive in its own
  /// direction.
  [[nodiscard]] std::optional<std::complex<double>> amplitude(const exchange::UniversalPoint& reference) const;

  [[nodiscard]] double delay() const { return force_.action.delay; }
  /// "force of push at (0.1, 0, 0) m along (0, 0, 10) of "frame"": place in the ground frame [m], magnitudes of the
  /// components along the axes of the body [N or N m].
  [[nodiscard]] std::string words() const;

 private:
  [[nodiscard]] std::optional<std::complex<double>> along_itself() const;
  /// True for a node at the place of a force, or at any place of the body of a moment.
  [[nodiscard]] bool acts_at(int node) const;

  const model::Description& description_;
  const MeasuredPlaces& places_;
  const model::Excitation& force_;
};

/// Nodes with functions (response or reference) or mode shapes whose position or whose directions are in a coordinate
/// system that the file does not define.
[[nodiscard]] std::vector<exchange::UniversalNode> nodes_in_systems(const exchange::UniversalFile& file);

/// A point with its direction along an axis of the ground; none if the axis of its node is not along one.
[[nodiscard]] std::optional<exchange::UniversalPoint> in_ground(const exchange::UniversalPoint& point,
                                                                const std::vector<exchange::UniversalNode>& nodes);

/// Turns mode shapes from the axes of their nodes to those of the ground.
void turn_to_ground(const std::vector<exchange::UniversalNode>& nodes, std::vector<exchange::UniversalMode>& modes);

/// Warns of those whose directions are in such a system: they are read as axes of the ground.
[[nodiscard]] foundation::Problems judge_directions(const std::vector<exchange::UniversalNode>& nodes);

/// Warns that nodes in coordinate systems have no place by their position.
[[nodiscard]] foundation::Problems judge_positions(const std::vector<exchange::UniversalNode>& nodes);

}  // namespace trivet::project
