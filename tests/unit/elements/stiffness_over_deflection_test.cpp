// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/stiffness_over_deflection.h"

#include <gmock/gmock.h>

#include "trivet/elements/checks.h"
#include "trivet/elements/law.h"
#include "trivet/foundation/invalid_input.h"

namespace stiffness_over_deflection_test {

using namespace trivet;
using elements::Matrix12;
using elements::StiffnessOverDeflection;

constexpr double arm = 0.03;

/// A block whose entries change with its deflection, and whose force turns with it.
StiffnessOverDeflection::State state(double z) {
  const double force = 2e5 * z * (1 - 20 * z);
  elements::Vector6 constants;
  constants << 4e4 * (1 + 9 * z), 5e4 * (1 - 7 * z), 2e5 * (1 - 40 * z), 60 * (1 + z), 50, 30 * (1 - 2 * z * z * 1e3);
  Matrix12 stiffness = elements::constants_at_point(constants, {0, 0, arm}, 0.5);
  for (const int across : {0, 1}) {
    stiffness(across, across) += force / arm;
    stiffness(across + 6, across + 6) += force / arm;
    stiffness(across, across + 6) -= force / arm;
    stiffness(across + 6, across) -= force / arm;
  }
  return {z, force, stiffness};
}

TEST(StiffnessOverDeflection, ARigidRotationTurnsTheForceBetweenTheStatesToo) {
  const StiffnessOverDeflection found({state(-0.006), state(-0.003), state(0), state(0.002)}, 2, arm);
  constexpr double round_off = 1e-9;
  for (const double z : {-0.006, -0.0041, -0.001, 0.0013}) {
    const double force = state(z).force;
    elements::Vector12 preload = elements::Vector12::Zero();
    preload(8) = force;
    preload(2) = -force;
    const Eigen::Matrix<double, 12, 6> moved =
        found.at(z, force) * elements::rigid_motions({0, 0, arm}, Eigen::Matrix3d::Identity());
    EXPECT_LT((moved - elements::turned_preload(preload, Eigen::Matrix3d::Identity())).norm(), round_off * 1e5) << z;
  }
}

/// A bush, whose ends are at one point: of its stiffness only the turning of the force is not elastic.
TEST(StiffnessOverDeflection, ARigidRotationTurnsTheForceAcrossABush) {
  elements::Vector6 constants;
  constants << 4e5, 3e5, 1e5, 60, 50, 30;
  const Matrix12 elastic = elements::constants_at_point(constants, {0, 0, 0}, 0.5);
  for (const int axis : {0, 1, 2}) {
    std::vector<StiffnessOverDeflection::State> states;
    for (const double z : {-0.002, 0.0, 0.002}) states.push_back({z, 0, elastic});
    const StiffnessOverDeflection found(states, axis, 0);
    constexpr double force = 700;
    elements::Vector12 preload = elements::Vector12::Zero();
    preload(axis + 6) = force;
    preload(axis) = -force;
    const Matrix12 there = found.at(0.001, force);
    EXPECT_EQ(there, there.transpose());
    const Eigen::Matrix<double, 12, 6> moved = there * elements::rigid_motions({0, 0, 0}, Eigen::Matrix3d::Identity());
    EXPECT_LT((moved - elements::turned_preload(preload, Eigen::Matrix3d::Identity())).norm(), 1e-9) << axis;
  }
}

TEST(StiffnessOverDeflection, HasItsStatesAndCubicsBetweenThem) {
  const StiffnessOverDeflection found({state(-0.006), state(-0.003), state(0), state(0.002)}, 2, arm);
  EXPECT_LT((found.at(-0.003, state(-0.003).force) - state(-0.003).stiffness).norm(), 1e-9 * 2e5);
  // Entries but the last one are linear in z, which a cubic with the slopes of parabolas is exactly.
  const Matrix12 between = found.at(-0.0017, state(-0.0017).force), expected = state(-0.0017).stiffness;
  EXPECT_NEAR(between(8, 8), expected(8, 8), 1e-9 * 2e5);
  EXPECT_NEAR(between(9, 9), expected(9, 9), 1e-9 * 2e5);
}

TEST(StiffnessOverDeflection, RejectsFewStatesNoAxisAndANegativeArm) {
  EXPECT_THROW(StiffnessOverDeflection({state(0), state(0.001)}, 2, arm), foundation::InvalidInput);
  EXPECT_THROW(StiffnessOverDeflection({state(0), state(0.002), state(0.001)}, 2, arm), foundation::InvalidInput);
  EXPECT_THROW(StiffnessOverDeflection({state(0), state(0.001), state(0.002)}, 2, -0.01), foundation::InvalidInput);
  EXPECT_THROW(StiffnessOverDeflection({state(0), state(0.001), state(0.002)}, 3, arm), foundation::InvalidInput);
}

}  // namespace stiffness_over_deflection_test
