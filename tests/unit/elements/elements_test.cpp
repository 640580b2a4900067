// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "support/random_system.h"
#include "trivet/elements/checks.h"
#include "trivet/elements/law.h"
#include "trivet/spatial/rigid_motion.h"

namespace elements_test {

using namespace trivet;
using namespace trivet::elements;

const Eigen::Vector3d arm(0.1, -0.3, 0.25);

constexpr double residual_round_off = 1e-13;  // a few dozen operations per scaled entry
constexpr double norm_round_off = 1e-12;      // sums of products in another order, over up to 144 entries

Matrix12 sound_matrix() { return from_moved_end(test::RandomSystem(8).stiffness(1e5, 0.3), arm); }

MatrixVerdict verdict(const Matrix12& matrix) {
  return examine(matrix, rigid_motions(arm, Eigen::Matrix3d::Identity()));
}

TEST(Laws, ResistNoRigidMotion) {
  const Vector6 constants = (Vector6() << 1e5, 2e5, 3e5, 10, 20, 30).finished();
  for (const double centre : {0.0, 0.2, 1.0})
    EXPECT_LE(verdict(constants_at_point(constants, arm, centre)).rigid_residual, residual_round_off);
  EXPECT_LE(verdict(constant_along_line(500, Eigen::Vector3d(1, 1, 0).normalized(), arm, 0.5)).rigid_residual,
            residual_round_off);
  EXPECT_LE(verdict(sound_matrix()).rigid_residual, residual_round_off);
}

TEST(Laws, AStrutAlongAnyAxisPassesItsOwnCheck) {
  for (const Eigen::Vector3d& line :
       {Eigen::Vector3d(1, 1, 1), {1, 0, 0.5}, {0.1, 0.2, 0.3}, {1, -1, 2}, {0.2, 0.9, -0.4}, {0.3, 0.5, -1}})
    for (const Eigen::Vector3d& span :
         {Eigen::Vector3d(0, 0, 0), {0, 0.2, 0.1}, {0, 0.2, 0.6}, {-1.3, 0.21, 0.37}, {10, -7, 3}})
      for (const double constant : {500.0, 1e9}) {
        const Eigen::Matrix3d axes = spatial::axes_along(line);
        const Matrix12 matrix = in_end_axes(constant_along_line(constant, Eigen::Vector3d::UnitZ(), span, 0.5), axes);
        const MatrixVerdict v = examine(matrix, rigid_motions(span, axes));
        EXPECT_LE(v.rigid_residual, silent_residual);
        EXPECT_LE(v.asymmetry, rounding_of_data);
        EXPECT_TRUE(is_semidefinite(v));
      }
}

TEST(Laws, EndForcesBalance) {
  Vector6 at_n, at_k;
  const spatial::Vector12 d = spatial::Vector12::LinSpaced(12, -1, 2);
  const spatial::Vector12 f = sound_matrix() * d;
  at_n = f.head<6>();
  at_k = spatial::rigid_motion(arm).transpose() * f.tail<6>();  // transformed from K to N
  EXPECT_LE((at_n + at_k).norm(), norm_round_off * at_n.norm());
}

TEST(FromMovedEnd, KeepsTheGivenBlock) {
  const Matrix6 k = test::RandomSystem(8).stiffness(1e5, 0.3);
  const Matrix6 moved_end = from_moved_end(k, arm).bottomRightCorner<6, 6>();
  EXPECT_LE((moved_end - k).norm(), norm_round_off * k.norm());
}

TEST(Examine, FindsAWrongLeverArmBySize) {
  const Matrix12 wrong = from_moved_end(test::RandomSystem(8).stiffness(1e5, 0.3), 1.5 * arm);
  EXPECT_GT(verdict(wrong).rigid_residual, refused_residual);
}

TEST(Examine, AFlippedSignIsCaught) {
  Matrix12 flipped = sound_matrix();
  flipped.block<3, 3>(0, 9) *= -1;
  flipped.block<3, 3>(9, 0) *= -1;
  EXPECT_GT(verdict(flipped).rigid_residual, refused_residual);
}

TEST(Examine, MeasuresTheResidualAgainstTheStiffnessOfTheEntry) {
  constexpr double of_the_scale = 0.2;  // the changed entry is the scale as well: error / (1 + error)
  for (const double error : {1e-7, 0.01, 0.1}) {
    Matrix12 matrix =
        constants_at_point((Vector6() << 1e5, 2e5, 3e5, 10, 20, 30).finished(), Eigen::Vector3d::Zero(), 0.5);
    matrix(9, 9) *= 1 + error;  // the softest entry, which a norm would hide
    const MatrixVerdict v = examine(matrix, rigid_motions(Eigen::Vector3d::Zero(), Eigen::Matrix3d::Identity()));
    EXPECT_NEAR(v.rigid_residual, error, of_the_scale * error);
    EXPECT_EQ(v.residual_row, 9);
    EXPECT_TRUE(is_semidefinite(v));
  }
}

TEST(Examine, AsymmetryIsScaledAndLocated) {
  Matrix12 matrix = sound_matrix();
  matrix(3, 7) += 1e-3 * std::sqrt(matrix(3, 3) * matrix(7, 7));
  const MatrixVerdict v = verdict(matrix);
  EXPECT_NEAR(v.asymmetry, 1e-3, rounding_of_data);
  EXPECT_EQ(v.asymmetric_row, 3);
  EXPECT_EQ(v.asymmetric_column, 7);
}

TEST(Examine, NegativeStiffnessIsIndefinite) {
  EXPECT_FALSE(is_semidefinite(verdict(-sound_matrix())));
  EXPECT_TRUE(is_semidefinite(verdict(sound_matrix())));
  EXPECT_TRUE(is_semidefinite(verdict(Matrix12::Zero())));
}

TEST(Law, ScaleMultipliesStiffnessAndWhatFollowsItOnly) {
  Law law{sound_matrix(), 3, ProportionalDamping{0.1, false}};
  EXPECT_LE((viscous_damping(law) - 0.3 * law.nominal_stiffness).norm(), norm_round_off * law.nominal_stiffness.norm());
  law.damping = ProportionalDamping{0.1, true};
  EXPECT_LE((viscous_damping(law) - 0.1 * law.nominal_stiffness).norm(), norm_round_off * law.nominal_stiffness.norm());
  law.damping = DampingMatrix{sound_matrix()};
  EXPECT_EQ(viscous_damping(law), sound_matrix());
  law.damping = LossFactor{0.2};
  EXPECT_EQ(viscous_damping(law), Matrix12::Zero());
  EXPECT_EQ(loss_factor(law), 0.2);
}

}  // namespace elements_test
