// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/distance_force.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "support/matchers.h"
#include "support/random_system.h"
#include "trivet/elements/beam.h"
#include "trivet/elements/checks.h"
#include "trivet/spatial/rigid_motion.h"

namespace force_at_rest_test {

using namespace trivet;
using namespace trivet::elements;

constexpr double round_off = 1e-12;  // a hundred operations on entries of one size

/// Forces on both ends that balance.
Vector12 on_both_ends(const Vector6& on_k, const Eigen::Vector3d& arm, const Eigen::Matrix3d& n_from_k) {
  Vector12 both;
  both << -(spatial::both_blocks(n_from_k) * (spatial::rigid_motion(arm).transpose() * on_k)), on_k;
  return both;
}

TEST(ForceAtRest, TurnsWithTheElement) {
  test::RandomSystem random(11);
  for (int round = 0; round < 20; ++round) {
    Vector6 on_k;
    on_k << random.vector(100), random.vector(30);
    const Eigen::Vector3d arm = random.vector(0.7);
    const Eigen::Matrix3d n_from_k = random.rotation();
    const Matrix12 added = stiffness_of_turning(on_k, arm, n_from_k);
    EXPECT_LE((added - added.transpose()).cwiseAbs().maxCoeff(), round_off * added.cwiseAbs().maxCoeff());
    const Eigen::Matrix<double, 12, 6> turned = added * rigid_motions(arm, n_from_k),
                                       expected = turned_preload(on_both_ends(on_k, arm, n_from_k), n_from_k);
    EXPECT_LE((turned - expected).cwiseAbs().maxCoeff(), round_off * added.cwiseAbs().maxCoeff());
    EXPECT_TRUE((added.bottomRightCorner<6, 6>().isZero(0)));  // end N on the ground
  }
}

/// The tension of a beam or a link turns with it too, and holds it against deflections.
TEST(ForceAtRest, OfASlenderElementIncludesItsTension) {
  const Metal steel = metal("structural_steel").value();
  const Beam beam{steel, rectangular_section(0.03, 0.02, steel), 0.8};
  Law law;
  for (const Matrix12& per_tension : {beam_stiffness_per_tension(beam), link_stiffness_per_tension(0.8)}) {
    law.per_tension = per_tension;
    const Eigen::Vector3d arm(0, 0, 0.8);
    const Vector6 on_k = (Vector6() << 20, -30, 500, 4, 5, 6).finished();
    const Matrix12 added = stiffness_of_force_at_rest(law, on_k, arm, Eigen::Matrix3d::Identity());
    const Eigen::Matrix<double, 12, 6> turned = added * rigid_motions(arm, Eigen::Matrix3d::Identity()),
                                       expected = turned_preload(on_both_ends(on_k, arm, Eigen::Matrix3d::Identity()),
                                                                 Eigen::Matrix3d::Identity());
    EXPECT_LE((turned - expected).cwiseAbs().maxCoeff(), round_off * added.cwiseAbs().maxCoeff());
  }
}

/// Lateral stiffness of a column clamped at its foot, its top free to turn: P κ/(tan κL − κL), κ² = P/EI.
TEST(ForceAtRest, OfAColumnIsThatOfItsExactDeflection) {
  const Metal steel = metal("structural_steel").value();
  Section section = rectangular_section(0.03, 0.03, steel);
  section.shear_factor_1 = section.shear_factor_2 = std::numeric_limits<double>::infinity();
  const Beam beam{steel, section, 1.2};
  const double bending = steel.young_modulus * section.moment_1,
               buckling = bending * std::pow(std::numbers::pi / (2 * beam.length), 2);
  for (const double share : {0.01, 0.1}) {
    const double force = share * buckling, k = std::sqrt(force / bending);
    const Matrix12 whole = beam_stiffness(beam) - force * beam_stiffness_per_tension(beam);
    const double condensed = whole(6, 6) - whole(6, 10) * whole(10, 6) / whole(10, 10);
    const double exact = force * k / (std::tan(k * beam.length) - k * beam.length);
    // What is left out is of second order in the share.
    EXPECT_THAT(condensed, test::RelativelyNear(exact, 0.02 * share * share));
    const double plain =
        beam_stiffness(beam)(6, 6) - std::pow(beam_stiffness(beam)(6, 10), 2) / beam_stiffness(beam)(10, 10);
    EXPECT_THAT(condensed, testing::Not(test::RelativelyNear(plain, 0.5 * share)));
  }
}

}  // namespace force_at_rest_test
