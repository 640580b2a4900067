// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/model/guides.h"

#include <fmt/format.h>

#include "trivet/foundation/index.h"
#include "trivet/model/checks.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::model {

std::string coordinates_left_behind(const Body& body, const Action::Amplitude& motion, const Eigen::Vector3d& at) {
  constexpr double round_off = 1e-12;
  const Eigen::Vector3d arm = body.pose.position - at;
  const spatial::Matrix6 carried = spatial::both_blocks(body.pose.rotation).transpose() * spatial::rigid_motion(arm);
  const Action::Amplitude here = carried.cast<std::complex<double>>() * motion;
  const double turning = motion.tail<3>().norm(), moving = motion.head<3>().norm() + arm.norm() * turning;
  std::string names;
  for (int j = 0; j < 6; ++j)
    if (body.is_constrained(to_size(j)) && std::abs(here(j)) > round_off * (j < 3 ? moving : turning))
      names += (names.empty() ? "" : ", ") + std::string(coordinate_names[j]);
  return names;
}

void warn_of_guides(const Body& body, const std::string& coordinates, const std::string& cause,
                    foundation::Problems& problems) {
  problems.warning(path_of(body) + ".free",
                   fmt::format("the {} is constrained in {}, and {} moves the ground there",
                               body.is_node ? "node" : "body", coordinates, cause),
                   "constraints are fixed in space: the ground moves away under the body, and only its free "
                   "coordinates respond to the motion of its mounts",
                   "if the constraints move with the ground, add these coordinates to free and hold them by an element "
                   "that is stiff there; otherwise change nothing");
}

void check_guides(const Description& description, foundation::Problems& problems) {
  for (const Body& body : description.bodies)
    for (const Excitation& excitation : description.excitations) {
      const Action& action = excitation.action;
      if (action.body || !action.elements.empty())
        continue;  // single supports move relative to the constraints in any case
      if (const std::string names = coordinates_left_behind(body, action.amplitude, action.at); !names.empty()) {
        warn_of_guides(body, names, "\"" + excitation.name + "\"", problems);
        break;
      }
    }
}

}  // namespace trivet::model
