// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/project/project.h"
#include "trivet/results/scene/bounds.h"
#include "trivet/results/scene/solid_surface.h"

namespace trivet::results {

/// A machine as its drawing shows it: places in the ground frame [m], at rest.
struct DrawnMachine {
  struct Solid {
    std::size_t body = 0;
    SolidSurface surface;     ///< its vertices in the ground frame
    bool equivalent = false;  ///< the box of the inertia: no shape is given
  };
  struct Body {
    std::string name;
    spatial::Pose pose;
    Eigen::Vector3d centre;  ///< of mass; of a node its place
    double mass = 0;         ///< [kg]
    bool is_node = false;
  };
  struct Point {
    std::string name;  ///< "interferometer"
    Eigen::Vector3d at;
    std::size_t body = 0;
  };
  enum class Support { body, ground, foundation };
  struct Element {
    std::string name;
    Eigen::Vector3d n, k;  ///< its ends
    Eigen::Vector3d axis;  ///< e3, from N to K
    std::optional<std::size_t> n_body, k_body;
    Support support = Support::ground;  ///< what carries end N
    bool is_beam = false;
  };
  struct Foundation {
    std::string name;
    Eigen::Vector3d at;  ///< end N of the first element on it
  };
  /// A force, a moment or a motion of the ground, the largest one if it has orders.
  struct Excitation {
    std::string name;
    Eigen::Vector3d at;
    std::optional<std::size_t> body;
    Eigen::Vector3d force = Eigen::Vector3d::Zero();     ///< direction, or zero
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();    ///< direction, or zero
    Eigen::Vector3d rotation = Eigen::Vector3d::Zero();  ///< axis of a rotating force, instead of `force`
  };
  std::vector<Body> bodies;
  std::vector<Solid> solids;
  std::vector<Point> points;
  std::vector<Element> elements;
  std::vector<Foundation> foundations;
  std::vector<Excitation> excitations;

  /// Of all its places, without symbols.
  [[nodiscard]] Bounds bounds() const;
  /// The place of the solids of a body nearest to another place, by the boxes around them; its centre without solids.
  [[nodiscard]] Eigen::Vector3d nearest_on(std::size_t body, const Eigen::Vector3d& place) const;
};

[[nodiscard]] DrawnMachine drawn_machine(const project::Case& machine);

}  // namespace trivet::results
