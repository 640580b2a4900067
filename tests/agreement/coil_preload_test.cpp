// SPDX-License-Identifier: BSD-3-Clause
// The compressed coil spring against equilibrium, finite differences and its limits.
#include <gmock/gmock.h>

#include "support/coil_springs.h"
#include "support/matchers.h"
#include "trivet/elements/coil_preload.h"
#include "trivet/elements/coil_reduction.h"
#include "trivet/elements/helical_rod.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/spatial/rigid_motion.h"

namespace coil_preload_test {

using namespace trivet;
using elements::CoilSpring;
using elements::Matrix12;
using test::literature_spring;
using test::random_spring;

/// Transfer along the wire of up to 20 turns against a closed form, and sums of large moments.
constexpr double round_off = 1e-9;

double open_length(const CoilSpring& spring) {
  return spring.active_length - spring.active_coils * wire_height(spring);
}

spatial::Vector12 unit_scale(const CoilSpring& spring) { return stiffness(spring).diagonal().cwiseSqrt(); }

TEST(CompressedCoil, UnloadedItIsTheSpringItself) {
  std::mt19937 random(1);
  for (int i = 0; i < 20; ++i) {
    const CoilSpring spring = random_spring(random);
    EXPECT_THAT(compressed_by(spring, 0).stiffness, test::NearInUnits(stiffness(spring), unit_scale(spring), round_off))
        << i;
  }
}

TEST(CompressedCoil, ForceAndCompressionAreInverse) {
  constexpr double settled = 1e-10;  // of the length: the iteration for the lead ends at round-off
  std::mt19937 random(2);
  for (int i = 0; i < 20; ++i) {
    const CoilSpring spring = random_spring(random);
    for (const double part : {-0.5, 0.3, 0.9}) {
      const elements::CompressedCoil state = compressed_by(spring, part * open_length(spring));
      EXPECT_NEAR(state.compression, part * open_length(spring), settled * spring.active_length) << i;
      EXPECT_NEAR(compressed_with(spring, state.axial_force).compression, state.compression,
                  settled * spring.active_length)
          << i;
    }
  }
}

TEST(CompressedCoil, IsStretchedUpToTheLengthOfItsWire) {
  constexpr double rounding = 1e-8;
  std::mt19937 random(4);
  for (int i = 0; i < 20; ++i) {
    const CoilSpring spring = random_spring(random);
    const double to_wire = helical_rod(spring).length - spring.active_length;
    double previous = 0;
    for (const double part : {1e-12, 1e-6, 0.5, 0.9, 0.99, 0.999}) {
      const elements::CompressedCoil state = compressed_by(spring, -part * to_wire);
      EXPECT_LT(state.axial_force, previous) << i << ' ' << part;
      previous = state.axial_force;
      EXPECT_NEAR(compressed_with(spring, state.axial_force).compression, -part * to_wire, rounding * to_wire) << i;
    }
    EXPECT_THAT([&] { (void)compressed_by(spring, -1.001 * to_wire); },
                testing::ThrowsMessage<foundation::NotComputable>(testing::HasSubstr("length of its wire")));
  }
}

TEST(CompressedCoil, AForceBeyondEveryEquilibriumIsRefused) {
  const CoilSpring spring = literature_spring();
  for (const double force : {1e3, 1e6, 1e12})
    EXPECT_THROW((void)compressed_with(spring, force), foundation::InvalidInput) << "its coils touch";
  for (const double force : {-1e12, -1e300, 1e300})
    EXPECT_THROW((void)compressed_with(spring, force), foundation::NotComputable) << force;
}

TEST(CompressedCoil, ARigidRotationTurnsItsPreload) {
  std::mt19937 random(3);
  for (int i = 0; i < 40; ++i) {
    const CoilSpring spring = random_spring(random);
    const elements::CompressedCoil state = compressed_by(spring, (i % 4 - 1) * 0.3 * open_length(spring));
    Eigen::Matrix<double, 12, 6> expected = Eigen::Matrix<double, 12, 6>::Zero();
    for (const int end : {0, 6}) {
      expected.block<3, 3>(end, 3) = -spatial::cross_matrix(state.preload.segment<3>(end));
      expected.block<3, 3>(end + 3, 3) = -0.5 * spatial::cross_matrix(state.preload.segment<3>(end + 3));
    }
    const Eigen::Matrix<double, 12, 6> motions =
        elements::rigid_motions({0, 0, state.seat_distance}, Eigen::Matrix3d::Identity());
    const spatial::Vector12 scale = unit_scale(spring);
    elements::Vector6 motion_scale;
    for (int j = 0; j < 6; ++j) motion_scale(j) = motions.col(j).cwiseAbs().cwiseProduct(scale).maxCoeff();
    EXPECT_THAT((state.stiffness * motions).eval(), test::NearInUnitsOf(expected, scale, motion_scale, round_off)) << i;
    EXPECT_THAT(state.stiffness, test::NearInUnits(state.stiffness.transpose().eval(), scale, round_off)) << i;
  }
}

TEST(CompressedCoil, AxialTangentIsTheSlopeOfTheForce) {
  // The ends of the uniform helix may slide radially; the tangent holds them on the seats.
  constexpr double end_effect = 6e-3;
  const CoilSpring spring = literature_spring();
  for (const double part : {-0.5, 0.0, 0.5, 0.95}) {
    const double at = part * open_length(spring), step = 1e-7;
    const double slope =
        (compressed_by(spring, at + step).axial_force - compressed_by(spring, at - step).axial_force) / (2 * step);
    EXPECT_THAT(compressed_by(spring, at).stiffness(8, 8), test::RelativelyNear(slope, end_effect)) << part;
  }
}

TEST(CompressedCoil, ClampedLateralFrequencyVanishesAtBuckling) {
  CoilSpring spring = literature_spring();
  spring.active_coils *= 2;
  spring.active_length *= 2;
  const double limit = buckling(spring, elements::SeatsHeld::both).value().compression;
  const double unloaded = natural_frequencies(spring, elements::SeatsHeld::both, 1)[0];
  const auto lowest = [&](double part) {
    return natural_frequencies(compressed_by(spring, part * limit).coil, elements::SeatsHeld::both, 1)[0] / unloaded;
  };
  constexpr double nearly_zero = 0.1;  // the frequency falls with the root of the distance: √0.001 is 0.03
  EXPECT_LT(lowest(0.999), nearly_zero);
  EXPECT_LT(lowest(0.999), lowest(0.9));
  EXPECT_EQ(modes_below(compressed_by(spring, 1.001 * limit).coil, 0, elements::SeatsHeld::both), 1);
  EXPECT_TRUE(check_compression(spring, 1.001 * limit).has_errors());
  EXPECT_EQ(check_compression(spring, 0.9 * limit).list().size(), 1u);
  EXPECT_TRUE(check_compression(spring, 0.5 * limit).list().empty());
}

TEST(CompressedCoil, TouchingCoilsAreRejected) {
  const CoilSpring spring = literature_spring();
  EXPECT_THROW((void)compressed_by(spring, 1.001 * open_length(spring)), foundation::InvalidInput);
  EXPECT_THROW((void)compressed_with(spring, 1e3), foundation::InvalidInput);
  EXPECT_TRUE(check_compression(spring, 1.001 * open_length(spring)).has_errors());
  EXPECT_THROW((void)compressed_by(spring, std::nan("")), foundation::InvalidInput);
  EXPECT_THROW((void)compressed_by(spring, -100.0), foundation::NotComputable) << "longer than its wire";
}

TEST(CompressedCoil, ItsReductionKeepsTheTangentAndTheMass) {
  const elements::CompressedCoil state = compressed_by(literature_spring(), 0.005);
  const elements::ReducedCoil r = reduced(state.coil, 4);
  EXPECT_THAT(r.stiffness, test::NearInUnits(state.stiffness, unit_scale(literature_spring()), round_off));
  Eigen::Matrix<double, 12, 1> along = Eigen::Matrix<double, 12, 1>::Zero();
  along(2) = along(8) = 1;
  const double mass = 7900 * wire_section(literature_spring()).area * state.coil.rod.length;
  EXPECT_THAT(along.dot(r.mass * along), test::RelativelyNear(mass, round_off));
}

}  // namespace coil_preload_test
