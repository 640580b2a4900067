// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/spatial/screw.h"

#include <Eigen/Geometry>

namespace trivet::spatial {

Screw screw(const Displacement& at_origin, double length, const Eigen::Vector3d& about) {
  constexpr double negligible = 1e-9;
  const Eigen::Vector3d& theta = at_origin.rotation;
  const Eigen::Vector3d translation = at_origin.translation + theta.cross(about);
  Screw result;
  const double angle = theta.norm();
  if (angle * length <= negligible * translation.norm() || angle == 0) {
    if (translation.norm() > 0) result.direction = translation.normalized();
    return result;
  }
  result.pure_translation = false;
  result.rotation = angle;
  result.direction = theta / angle;
  result.pitch = result.direction.dot(translation) / angle;
  result.point = about + theta.cross(translation) / (angle * angle);
  return result;
}

}  // namespace trivet::spatial
