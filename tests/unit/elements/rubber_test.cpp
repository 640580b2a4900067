// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <random>

#include "support/matchers.h"
#include "trivet/elements/checks.h"
#include "trivet/elements/pressure_modulus.h"
#include "trivet/elements/rubber_layer.h"
#include "trivet/elements/rubber_mounts.h"
#include "trivet/foundation/invalid_input.h"

namespace rubber_test {

using namespace trivet;
using namespace trivet::elements;

constexpr double round_off = 1e-12;            // a few hundred operations on entries of equal scaled size
constexpr double long_sum_round_off = 1e-11;   // series of up to 10 000 terms that cancel up to three digits
constexpr double inversion_round_off = 1e-11;  // eight inversions of 6 × 6 matrices

class Dimensions {
 public:
  double between(double low, double high) {
    return low * std::pow(high / low, std::uniform_real_distribution<>(0, 1)(engine_));
  }
  Rubber rubber() { return {between(2e5, 3e6), between(1e9, 3e9)}; }
  RubberDisc disc() {
    const double radius = between(0.01, 0.3);
    return {.rubber = rubber(),
            .radius = radius,
            .hole_radius = radius * between(0.15, 0.8),
            .thickness = radius * between(0.02, 2)};
  }
  RubberBlock block() {
    return {.rubber = rubber(),
            .width_1 = between(0.02, 0.5),
            .width_2 = between(0.02, 0.5),
            .thickness = between(0.005, 0.1)};
  }
  RubberBush bush() {
    const double inner = between(0.005, 0.1), wall = inner * between(0.15, 4);
    return {.rubber = rubber(), .inner_radius = inner, .outer_radius = inner + wall, .length = wall * between(0.6, 20)};
  }

 private:
  std::mt19937 engine_{7};
};

void expect_sound(const Matrix12& matrix, const Eigen::Vector3d& arm) {
  const MatrixVerdict verdict = examine(matrix, rigid_motions(arm, Eigen::Matrix3d::Identity()));
  EXPECT_LE(verdict.rigid_residual, round_off);
  EXPECT_LE(verdict.asymmetry, round_off);
  EXPECT_TRUE(is_semidefinite(verdict));
}

TEST(RubberElements, ResistNoRigidMotionInRandomDimensions) {
  Dimensions random;
  for (int round = 0; round < 100; ++round) {
    RubberDisc disc = random.disc();
    expect_sound(rubber_disc(disc), {0, 0, disc.thickness});
    disc.hole_radius = 0;
    expect_sound(rubber_disc(disc), {0, 0, disc.thickness});
    const RubberBlock block = random.block();
    expect_sound(rubber_block(block), {0, 0, block.thickness});
    expect_sound(rubber_bush(random.bush()), Eigen::Vector3d::Zero());
    const Sandwich stack{.layer = block, .layers = 1 + round % 9, .plate_thickness = 0.003};
    expect_sound(sandwich(stack), {0, 0, height(stack)});
  }
}

TEST(RubberElements, ScaleWithModulusSizeAndDynamicFactor) {
  Dimensions random;
  for (int round = 0; round < 20; ++round) {
    RubberBlock block = random.block();
    const Matrix12 before = rubber_block(block);
    block.dynamic_factor = 1.5;
    block.rubber.shear_modulus *= 2;
    block.rubber.bulk_modulus *= 2;
    EXPECT_LE((rubber_block(block) - 3 * before).norm(), round_off * before.norm());
    const LayerConstants small = layer_constants(block);
    block.width_1 *= 3, block.width_2 *= 3, block.thickness *= 3;
    const LayerConstants large = layer_constants(block);
    EXPECT_THAT(large.axial, test::RelativelyNear(3 * small.axial, round_off));
    EXPECT_THAT(large.bending_2, test::RelativelyNear(27 * small.bending_2, long_sum_round_off));
    EXPECT_THAT(large.torsion, test::RelativelyNear(27 * small.torsion, long_sum_round_off));
  }
}

TEST(RubberBlock, ExchangingTheWidthsTurnsTheElement) {
  const RubberBlock block{.rubber = {1e6}, .width_1 = 0.1, .width_2 = 0.25, .thickness = 0.03};
  RubberBlock turned = block;
  std::swap(turned.width_1, turned.width_2);
  const LayerConstants a = layer_constants(block), b = layer_constants(turned);
  EXPECT_THAT(a.shear_1, test::RelativelyNear(b.shear_2, round_off));
  EXPECT_THAT(a.bending_1, test::RelativelyNear(b.bending_2, round_off));
  EXPECT_THAT(a.torsion, test::RelativelyNear(b.torsion, round_off));
  constexpr double series_end = 1e-9;  // two series, along either side, that end after 10 000 terms of 1/n⁴
  EXPECT_THAT(a.axial, test::RelativelyNear(b.axial, series_end));
  EXPECT_GT(a.bending_1, a.bending_2);
}

TEST(PressureModulus, TendsToTheIncompressibleOneForARing) {
  constexpr double compressibility = 1e-5;  // (κ times the width)², by which the pressure decays
  const double h = 0.02;
  const Rubber stiff{1e6, 1e13}, rigid{1e6, std::numeric_limits<double>::infinity()};
  EXPECT_THAT(ring_pressure_modulus(stiff, 0.1, 0.04, h),
              test::RelativelyNear(ring_pressure_modulus(rigid, 0.1, 0.04, h), compressibility));
  EXPECT_THAT(ring_pressure_bending_modulus(stiff, 0.1, 0.04, h),
              test::RelativelyNear(ring_pressure_bending_modulus(rigid, 0.1, 0.04, h), compressibility));
}

TEST(PressureModulus, IsThatOfAStripForAThinRingAndALongBlock) {
  const double w = 0.01, h = 0.002;
  const Rubber rigid{1e6, std::numeric_limits<double>::infinity()};
  const double strip = 1e6 * w * w / (h * h);  // G w²/h²
  constexpr double curvature = 1e-3;           // width over radius
  constexpr double free_ends = 1e-4;           // ten times width over length
  EXPECT_THAT(ring_pressure_modulus(rigid, 10 + w, 10, h), test::RelativelyNear(strip, curvature));
  EXPECT_THAT(block_pressure_modulus(rigid, w, 1000, h), test::RelativelyNear(strip, free_ends));
  EXPECT_THAT(block_pressure_bending_modulus(rigid, w, 1000, h), test::RelativelyNear(strip / 5, free_ends));
}

TEST(PressureModulus, IsTheBulkModulusForAVeryWideLayer) {
  const Rubber rubber{1e6, 2e9};
  constexpr double free_edge = 0.01;  // pressure decays within 0.13 m of the edges of 100 m
  EXPECT_THAT(disc_pressure_modulus(rubber, 100, 0.01), test::RelativelyNear(2e9, free_edge));
  EXPECT_THAT(block_pressure_modulus(rubber, 100, 100, 0.01), test::RelativelyNear(2e9, free_edge));
}

TEST(Sandwich, IsTheLayerIfThereIsOnlyOne) {
  const RubberDisc disc{.rubber = {1e6}, .radius = 0.1, .thickness = 0.02};
  const Matrix12 one = rubber_disc(disc);
  EXPECT_LE((sandwich({.layer = disc, .layers = 1}) - one).cwiseAbs().maxCoeff(),
            round_off * one.cwiseAbs().maxCoeff());
}

TEST(Sandwich, BendsLikeATimoshenkoColumn) {
  // n layers: the flexibility of a parallel shift of the ends is n/k_shear plus that of tilting layers,
  // Σ z_i²/k_bending about the middle.
  const RubberDisc disc{.rubber = {1e6}, .radius = 0.1, .thickness = 0.01};
  const int n = 7;
  const double plate = 0.003, pitch = disc.thickness + plate;
  const LayerConstants c = layer_constants(disc);
  double levers = 0;
  for (int i = 0; i < n; ++i) levers += std::pow((i - (n - 1) / 2.0) * pitch, 2);
  const Matrix12 k = sandwich({.layer = disc, .layers = n, .plate_thickness = plate});
  EXPECT_THAT(k(6, 6), test::RelativelyNear(1 / (n / c.shear_1 + levers / c.bending_2), inversion_round_off));
  EXPECT_THAT(k(8, 8), test::RelativelyNear(c.axial / n, round_off));
  EXPECT_THAT(k(11, 11), test::RelativelyNear(c.torsion / n, round_off));
}

TEST(RubberChecks, NameEveryBadNumber) {
  EXPECT_TRUE(check(RubberDisc{.rubber = {1e6}, .radius = 0.1, .thickness = 0.02}).list().empty());
  const auto bad = check(
      RubberDisc{.rubber = {-1, 0}, .radius = 0, .hole_radius = 0.2, .thickness = std::nan(""), .dynamic_factor = 0});
  EXPECT_EQ(bad.list().size(), 5u);  // the hole of a disc without a radius is not counted
  EXPECT_TRUE(check(RubberDisc{.rubber = {1e6}, .radius = 0.1, .hole_radius = 0.005, .thickness = 0.02}).has_errors());
  for (const double thickness : {0.5, 0.001}) {  // shape factors 0.1 and 50
    const auto warned = check(RubberDisc{.rubber = {1e6}, .radius = 0.1, .thickness = thickness});
    EXPECT_EQ(warned.list().size(), 1u);
    EXPECT_FALSE(warned.has_errors());
  }
  EXPECT_TRUE(
      check(RubberBush{.rubber = {1e6}, .inner_radius = 0.03, .outer_radius = 0.01, .length = 0.05}).has_errors());
  EXPECT_TRUE(check(Sandwich{.layer = RubberDisc{.rubber = {1e6}, .radius = 0.1, .thickness = 0.02}, .layers = 0})
                  .has_errors());
  EXPECT_THROW((void)rubber_block({.rubber = {1e6}, .width_1 = -0.1, .width_2 = 0.1, .thickness = 0.01}),
               foundation::InvalidInput);
  EXPECT_THROW((void)in_series({}, {}), foundation::InvalidInput);
}

TEST(Hardness, IsCheckedAgainstItsRange) {
  EXPECT_TRUE(check_hardness(55).list().empty());
  EXPECT_EQ(check_hardness(85).list().front().severity, foundation::Severity::warning);
  EXPECT_TRUE(check_hardness(100).has_errors());
  EXPECT_THROW((void)young_modulus_from_hardness(100), foundation::InvalidInput);
  EXPECT_THROW((void)shear_modulus_from_irhd(76), foundation::InvalidInput);
}

}  // namespace rubber_test
