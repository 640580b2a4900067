// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/spatial/rigid_motion.h"

#include <Eigen/Geometry>

#include <cmath>

#include "trivet/foundation/invalid_input.h"

namespace trivet::spatial {

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

Matrix6 rigid_motion(const Eigen::Vector3d& r) {
  Matrix6 x = Matrix6::Identity();
  x.topRightCorner<3, 3>() = -cross_matrix(r);
  return x;
}

Matrix6 both_blocks(const Eigen::Matrix3d& rotation) {
  Matrix6 m = Matrix6::Zero();
  m.topLeftCorner<3, 3>() = rotation;
  m.bottomRightCorner<3, 3>() = rotation;
  return m;
}

Eigen::Matrix3d rotation_about(const Eigen::Vector3d& axis, double angle) {
  if (!(axis.norm() > 0)) throw foundation::InvalidInput("rotation_about: the axis has no direction");
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

Eigen::Matrix3d axes_along(const Eigen::Vector3d& axis) {
  if (!(axis.norm() > 0)) throw foundation::InvalidInput("axes_along: the axis has no direction");
  const Eigen::Vector3d e3 = axis.normalized();
  const Eigen::Vector3d guide = std::abs(e3.x()) > 0.9 ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitX();
  const Eigen::Vector3d e1 = (guide - guide.dot(e3) * e3).normalized();
  Eigen::Matrix3d axes;
  axes << e1, e3.cross(e1), e3;
  return axes;
}

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
