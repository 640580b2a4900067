// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>

#include "trivet/plausibility/body_picture.h"
#include "trivet/plausibility/suspicion.h"

namespace trivet::plausibility {
namespace {

/// Share of the stiffness against tilting that gravity may take before it is named: the frequency of tilting is 13 % lower then.
constexpr double worth_a_word = 0.25;

/// An inverted pendulum: tilting by θ about a horizontal axis takes (k − m g h) θ, with h the height of the centre of mass over the
/// point about which the mounts let it turn.
struct Tilt {
  double stiffness = 0;   ///< k [N m/rad]
  double overturning = 0; ///< m g h [N m/rad]
};

/// Of a body alone on its elements, about one horizontal axis; body frame.
Tilt tilt(const spatial::Matrix6& k, const Eigen::Vector3d& axis, const Eigen::Vector3d& up, double weight) {
  const Eigen::Matrix3d translation = k.topLeftCorner<3, 3>(), coupling = k.topRightCorner<3, 3>();
  const Eigen::Matrix3d free = k.bottomRightCorner<3, 3>() - coupling.transpose() * translation.inverse() * coupling;
  const Eigen::Vector3d moved = -translation.inverse() * coupling * axis;  // of the centre of mass, per unit of the angle
  return {axis.dot(free * axis), weight * moved.dot(axis.cross(up))};
}

}  // namespace

std::vector<std::string> overturning_notes(const model::System& system) {
  std::vector<std::string> notes;
  const auto& gravity = system.description().gravity;
  if (!gravity || gravity->isZero(0)) return notes;
  for (const BodyPicture& picture : pictures(system, {}, {})) {
    const bool preloaded = std::any_of(picture.attachments.begin(), picture.attachments.end(),
        [&](const Attachment& a) { return system.elements()[a.element].law.preload.has_value(); });
    const bool on_bodies = std::any_of(picture.attachments.begin(), picture.attachments.end(), [&](const Attachment& a) {
      return system.elements()[a.element].n.body && system.elements()[a.element].k.body;
    });
    if (preloaded || on_bodies) continue;  // preloads bring gravity's part, and other bodies move as well
    const spatial::Matrix6 k = stiffness_about_centre(picture);
    if (!(k.topLeftCorner<3, 3>().determinant() > 0)) continue;
    const Eigen::Vector3d up = -(system.bodies()[picture.body].pose.rotation.transpose() * gravity->normalized());
    const Eigen::Vector3d e1 = up.unitOrthogonal(), e2 = up.cross(e1);
    Tilt worst;
    double share = 0;
    for (const Eigen::Vector3d& axis : {e1, e2, Eigen::Vector3d((e1 + e2).normalized()), Eigen::Vector3d((e1 - e2).normalized())}) {
      const Tilt one = tilt(k, axis, up, picture.mass.mass * gravity->norm());
      if (!(one.stiffness > 0) || one.overturning <= share * one.stiffness) continue;
      worst = one;
      share = one.overturning / one.stiffness;
    }
    if (share <= worth_a_word) continue;
    notes.push_back(fmt::format(
        "body {}: tilted by an angle, its weight turns it on by {:.4g} N m/rad, its mounts hold it by {:.4g} N m/rad: {}. Elements without preload have no "
        "geometric stiffness, so natural frequencies of tilting {}",
        system.bodies()[picture.body].name, worst.overturning, worst.stiffness,
        share >= 1 ? "it falls over" : fmt::format("{:.0f} % of the stiffness are lost", 100 * share),
        share >= 1 ? "are computed that it does not have" : "are computed too high"));
  }
  return notes;
}

}  // namespace trivet::plausibility
