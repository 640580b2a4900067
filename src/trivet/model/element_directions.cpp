// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/model/element_directions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "trivet/elements/stiffness_properties.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::model {

ElementDirections element_directions(const std::vector<Body>& bodies, const Element& element) {
  const Span span = model::span(bodies, element.n, element.k);
  const elements::Matrix12 stiffness = element.law.scale * element.law.nominal_stiffness;
  ElementDirections result;
  result.centre = elements::stiffness_properties(stiffness).elastic_centre;
  Eigen::Matrix<double, 6, 12> of_k;
  of_k << -spatial::rigid_motion(span.arm) * spatial::both_blocks(span.n_from_k).transpose(),
      spatial::Matrix6::Identity();
  result.deformation = spatial::rigid_motion(result.centre) * of_k;
  const spatial::Matrix6 from_centre = spatial::rigid_motion(-result.centre);
  result.stiffness = from_centre.transpose() * stiffness.bottomRightCorner<6, 6>() * from_centre;
  return result;
}

elements::Matrix12 between_ends(const ElementDirections& directions, const spatial::Matrix6& stiffness) {
  return directions.deformation.transpose() * stiffness * directions.deformation;
}

std::string direction_words(const Element& element, int direction) {
  static constexpr std::array<const char*, 5> along_z = {"coil_spring", "rubber_disc", "rubber_bush", "beam", "damper"};
  const char axis = "xyz"[direction % 3];
  const bool has_axis = std::ranges::any_of(along_z, [&](const char* type) { return element.type == type; });
  if (!has_axis) return fmt::format("stiffness {} {}", direction < 3 ? "along" : "about", axis);
  if (direction == 2) return "axial stiffness";
  if (direction == 5) return "torsional stiffness";
  return direction < 3 ? fmt::format("lateral stiffness along {}", axis)
                       : fmt::format("tilting stiffness about {}", axis);
}

}  // namespace trivet::model
