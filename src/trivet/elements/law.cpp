// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/law.h"

#include "trivet/spatial/rigid_motion.h"

namespace trivet::elements {
namespace {

using Matrix6x12 = Eigen::Matrix<double, 6, 12>;

/// Motion of the K side relative to the N side, both rigidly extended to the point at the fraction `centre` of the arm.
Matrix6x12 relative_motion(const Eigen::Vector3d& arm, double centre) {
  Matrix6x12 e;
  e << -spatial::rigid_motion(centre * arm), spatial::rigid_motion((centre - 1) * arm);
  return e;
}

}  // namespace

Matrix12 stiffness(const Law& law) {
  Matrix12 sum = law.scale * law.nominal_stiffness;
  if (law.nonlinear) sum += law.nonlinear->tangent;
  if (law.inner) sum += stiffness_of_inner_parts(law, 0).real();
  return sum;
}

namespace {

Matrix12 linear_damping(const Law& law) {
  if (const auto* proportional = std::get_if<ProportionalDamping>(&law.damping))
    return proportional->factor * (proportional->of_nominal ? 1.0 : law.scale) * law.nominal_stiffness;
  if (const auto* given = std::get_if<DampingMatrix>(&law.damping)) return given->matrix;
  if (const auto* relaxing = std::get_if<Viscoelastic>(&law.damping))
    if (const auto* viscous = std::get_if<KelvinVoigt>(relaxing))
      return viscous->time * law.scale * law.nominal_stiffness;
  return Matrix12::Zero();
}

}  // namespace

Matrix12 viscous_damping(const Law& law) {
  const Matrix12 linear = linear_damping(law);
  return law.nonlinear ? Matrix12(linear + law.nonlinear->damping) : linear;
}

double loss_factor(const Law& law) {
  const auto* loss = std::get_if<LossFactor>(&law.damping);
  return loss ? loss->value : 0;
}

Eigen::Matrix<double, 3, 12> difference_rows(const Eigen::Matrix3d& n_from_k) {
  Eigen::Matrix<double, 3, 12> rows = Eigen::Matrix<double, 3, 12>::Zero();
  rows.leftCols<3>() = -n_from_k.transpose();
  rows.middleCols<3>(6).setIdentity();
  return rows;
}

Matrix12 from_moved_end(const Matrix6& moved_end, const Eigen::Vector3d& arm) {
  const Matrix6x12 e = relative_motion(arm, 1);
  return e.transpose() * moved_end * e;
}

Matrix12 constants_at_point(const Vector6& constants, const Eigen::Vector3d& arm, double centre) {
  const Matrix6x12 e = relative_motion(arm, centre);
  return e.transpose() * constants.asDiagonal() * e;
}

Matrix12 constant_along_line(double constant, const Eigen::Vector3d& axis, const Eigen::Vector3d& arm, double centre) {
  const Eigen::Matrix<double, 1, 12> stretch = axis.transpose() * relative_motion(arm, centre).topRows<3>();
  return constant * stretch.transpose() * stretch;
}

Eigen::Matrix<double, 1, 12> deflection_row(int axis, const Eigen::Vector3d& arm, const Eigen::Matrix3d& n_from_k,
                                            double centre) {
  Eigen::Matrix<double, 1, 12> row = relative_motion(arm, centre).row(axis);
  row.head<6>() = (row.head<6>() * spatial::both_blocks(n_from_k).transpose()).eval();
  return row;
}

Matrix12 in_end_axes(const Matrix12& in_axes_of_k, const Eigen::Matrix3d& n_from_k) {
  Matrix12 turn = Matrix12::Identity();
  turn.topLeftCorner<6, 6>() = spatial::both_blocks(n_from_k);
  return turn * in_axes_of_k * turn.transpose();
}

Eigen::Matrix<double, 12, 6> rigid_motions(const Eigen::Vector3d& arm, const Eigen::Matrix3d& n_from_k) {
  Eigen::Matrix<double, 12, 6> g;
  g << spatial::both_blocks(n_from_k) * spatial::rigid_motion(-arm), Matrix6::Identity();
  return g;
}

}  // namespace trivet::elements
