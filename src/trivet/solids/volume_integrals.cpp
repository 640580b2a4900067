// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/solids/volume_integrals.h"

namespace trivet::solids {

VolumeIntegrals placed(const VolumeIntegrals& v, const spatial::Pose& pose) {
  return {v.volume, pose.position + pose.rotation * v.centre,
          pose.rotation * v.second_moment * pose.rotation.transpose()};
}

VolumeIntegrals sum(const VolumeIntegrals& a, const VolumeIntegrals& b) {
  VolumeIntegrals total;
  total.volume = a.volume + b.volume;
  if (total.volume == 0) return total;
  const Eigen::Vector3d between = b.centre - a.centre;
  total.centre = a.centre + b.volume / total.volume * between;
  total.second_moment =
      a.second_moment + b.second_moment + a.volume * b.volume / total.volume * between * between.transpose();
  return total;
}

spatial::MassProperties mass_properties(const VolumeIntegrals& v, double density) {
  const Eigen::Matrix3d inertia = v.second_moment.trace() * Eigen::Matrix3d::Identity() - v.second_moment;
  return {density * v.volume, v.centre, density * inertia};
}

}  // namespace trivet::solids
