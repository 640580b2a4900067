// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "trivet/numerics/linalg/complete_pivoting.h"
#include "trivet/numerics/linalg/pivoted_lu.h"
#include "trivet/numerics/linalg/symmetric_eigen.h"
#include "trivet/plausibility/body_picture.h"
#include "trivet/plausibility/suspicion.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::plausibility {
namespace {

/// Share of the tilting stiffness that gravity may take before it is reported: the tilting frequency is then 13 %
/// lower.
constexpr double worth_a_word = 0.25;
/// Share of the stiffest direction below which one is unrestrained.
constexpr double unheld = 1e-9;

using Matrix32 = Eigen::Matrix<double, 3, 2>;

/// Contribution of the weight to the stiffness against rotations: mounts at r_i from the centre of mass carry it by
/// forces F_i, and a rotation θ moves their ends by an additional ½ θ × (θ × r_i); this adds Σ [(F_i·r_i) I − sym(F_i
/// r_iᵀ)]. Body frame.
Eigen::Matrix3d geometric_stiffness(const BodyPicture& picture, const spatial::Vector6& sag) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  const Eigen::Vector3d shift = sag.head<3>(), turn = sag.tail<3>();
  for (const Attachment& a : picture.attachments) {
    if (!a.elastic()) continue;
    const Eigen::Vector3d r = a.at - picture.mass.centre;
    const Eigen::Vector3d force = -(a.translation * (shift + turn.cross(r)) + a.coupling * turn);
    const Eigen::Matrix3d outer = force * r.transpose();
    sum += force.dot(r) * Eigen::Matrix3d::Identity() - 0.5 * (outer + outer.transpose());
  }
  return sum;
}

/// True if all elements of a body are on rigid ground and have no preload, which would include the effect of gravity.
bool is_alone(const model::System& system, const BodyPicture& picture) {
  return std::all_of(picture.attachments.begin(), picture.attachments.end(), [&](const Attachment& a) {
    const model::Element& element = system.elements()[a.element];
    return !element.law.preload && !(element.n.body && element.k.body) && !element.n.foundation &&
        !element.k.foundation;
  });
}

}  // namespace

std::vector<std::string> overturning_notes(const model::System& system) {
  std::vector<std::string> notes;
  const auto& gravity = system.description().gravity;
  if (!gravity || gravity->isZero(0)) return notes;
  for (const BodyPicture& picture : pictures(system, {}, {})) {
    if (!is_alone(system, picture)) continue;
    const spatial::Matrix6 k = stiffness_about_centre(picture);
    if (!k.allFinite() || !numerics::is_regular(k)) continue;
    const Eigen::Vector3d down = system.bodies()[picture.body].pose.rotation.transpose() * *gravity;
    spatial::Vector6 weight = spatial::Vector6::Zero();
    weight.head<3>() = picture.mass.mass * down;
    Matrix32 horizontal;  // axes of tilting
    horizontal.col(0) = down.unitOrthogonal();
    horizontal.col(1) = down.normalized().cross(horizontal.col(0));
    const Eigen::Matrix3d condensed = k.bottomRightCorner<3, 3>() -
        k.bottomLeftCorner<3, 3>() * numerics::inverse(Eigen::Matrix3d(k.topLeftCorner<3, 3>())) *
            k.topRightCorner<3, 3>();
    const Eigen::Matrix2d held = horizontal.transpose() * condensed * horizontal,
                          taken = -(horizontal.transpose() *
                                    geometric_stiffness(picture, numerics::completely_pivoted_solution(k, weight)) *
                                    horizontal);
    const Eigen::Vector2d alone = numerics::symmetric_eigen(held).values;
    if (!(alone(0) > unheld * alone(1))) continue;
    const numerics::SymmetricEigen<Eigen::Matrix2d> both = numerics::symmetric_eigen(taken, held);
    const double share = both.values(1);
    if (!(share > worth_a_word)) continue;
    const Eigen::Vector2d axis = both.vectors.col(1).normalized();
    notes.push_back(
        fmt::format("body {}: when it tilts, its weight causes an overturning moment of {:.4g} N m/rad, its mounts a "
                    "restoring moment of {:.4g} N m/rad: {}. Elements without preload have no "
                    "geometric stiffness, so natural frequencies of tilting {}",
                    system.bodies()[picture.body].name, axis.dot(taken * axis), axis.dot(held * axis),
                    share >= 1 ? "it falls over" : fmt::format("{:.0f} % of the stiffness is lost", 100 * share),
                    share >= 1 ? "are computed that do not exist" : "are computed too high"));
  }
  return notes;
}

}  // namespace trivet::plausibility
