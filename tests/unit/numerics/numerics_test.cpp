// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <rapidcheck/gtest.h>

#include "support/matchers.h"
#include "support/random_system.h"
#include "trivet/assembly/assembled.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/generalized_modes.h"
#include "trivet/numerics/linalg/quadratic_roots.h"
#include "trivet/numerics/peaks/peak_count.h"
#include "trivet/numerics/peaks/response_series.h"
#include "trivet/numerics/sweep/frequency_sweep.h"

namespace numerics_test {

using namespace trivet;
using namespace trivet::numerics;

constexpr double round_off = 1e-12;  // some hundred operations on entries of equal scaled size

/// Coefficients of Π (τ − root).
std::vector<double> polynomial(const std::vector<double>& roots) {
  std::vector<double> c = {1};
  for (const double root : roots) {
    std::vector<double> next(c.size() + 1, 0.0);
    for (std::size_t k = 0; k < c.size(); ++k) next[k + 1] += c[k], next[k] -= root * c[k];
    c = next;
  }
  return c;
}

TEST(SignChanges, FindAllSimpleRootsAndTheirDirection) {
  const auto found = sign_changes(polynomial({-0.9, -0.2, -0.1999, 0.5, 0.50001, 1.7}), -1, 1);
  ASSERT_EQ(found.size(), 5u);
  const double expected[] = {-0.9, -0.2, -0.1999, 0.5, 0.50001};
  constexpr double of_close_roots = 1e-9;  // the round-off of the coefficients over a slope of 8e-6
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(found[i].at, expected[i], of_close_roots);
  for (std::size_t i = 1; i < 5; ++i) EXPECT_NE(found[i].falling, found[i - 1].falling);
}

TEST(SignChanges, ATouchingRootIsNotCounted) { EXPECT_TRUE(sign_changes(polynomial({0.3, 0.3}), -1, 1).empty()); }

TEST(SignChanges, ATripleRootIsOneWithItsUncertainty) {
  const auto found = sign_changes(polynomial({0.3, 0.3, 0.3}), -1, 1);
  ASSERT_EQ(found.size(), 1u);
  constexpr double cube_root_of_round_off = 1e-4, far_above_round_off = 1e-7;  // ∛1e-16 is 5e-6
  EXPECT_NEAR(found[0].at, 0.3, cube_root_of_round_off);
  EXPECT_GT(found[0].uncertainty, far_above_round_off);
}

TEST(SignChanges, NoiseIsNoSignChange) {
  std::vector<double> c(20, 0.0);
  c[0] = 1e-17, c[1] = -1e-17, c[19] = 1;
  EXPECT_LE(sign_changes(c, -1, 1).size(), 1u);
  EXPECT_TRUE(sign_changes(std::vector<double>(10, 0.0), -1, 1).empty());
}

RC_GTEST_PROP(SignChanges, FindEverySeparatedRoot, ()) {
  const auto count = *rc::gen::inRange(1, 8);
  std::vector<double> roots;
  double last = -0.95;
  for (int i = 0; i < count; ++i) {
    last += 0.02 + 0.2 * static_cast<double>(*rc::gen::inRange(0, 1000)) / 1000;
    if (last < 0.95) roots.push_back(last);
  }
  const auto found = sign_changes(polynomial(roots), -1, 1);
  RC_ASSERT(found.size() == roots.size());
  constexpr double of_close_roots = 1e-6;  // seven roots 0.02 apart: the round-off over a slope of 2e-9
  for (std::size_t i = 0; i < roots.size(); ++i) RC_ASSERT(std::abs(found[i].at - roots[i]) < of_close_roots);
}

DynamicMatrices random_matrices(unsigned seed) {
  return assembly::assemble(test::checked(test::RandomSystem(seed).description(2, test::RandomDamping::viscous)))
      .matrices;
}

TEST(Sweep, IsTheSameForAnyNumberOfFrequencies) {
  const DynamicMatrices m = random_matrices(2);
  const Eigen::VectorXcd h = Eigen::VectorXcd::Constant(m.size(), Complex(1, -0.5));
  std::vector<double> omega;
  for (int i = 0; i < 19; ++i) omega.push_back(7.0 * i);
  const SweepResult together = sweep(m, h, omega);
  for (std::size_t i = 0; i < omega.size(); ++i)
    EXPECT_EQ(together.response.col(to_index(i)), sweep(m, h, {omega[i]}).response.col(0))
        << "a lane must not depend on its neighbours";
}

TEST(Sweep, ASingularMatrixIsReported) {
  DynamicMatrices m{
      Eigen::MatrixXd::Identity(2, 2), Eigen::MatrixXd::Zero(2, 2), Eigen::Vector2d(4, 9).asDiagonal(), {}, true};
  const SweepResult found = sweep(m, Eigen::VectorXcd::Ones(2), {1.0, 2.0, 2.5});
  EXPECT_EQ(found.singular, 1);
  EXPECT_TRUE(found.response.col(0).allFinite());
  EXPECT_FALSE(found.response.col(1).allFinite());
}

TEST(Sweep, ASkewFreeSystemHasNoResponseAtRest) {
  for (unsigned seed = 1; seed < 8; ++seed) {
    const DynamicMatrices m =
        assembly::assemble(test::checked(test::RandomSystem(seed).description(2, test::RandomDamping::viscous, false)))
            .matrices;
    const SweepResult found = sweep(m, Eigen::VectorXcd::Ones(m.size()), {0.0, 1.0});
    EXPECT_EQ(found.singular, 1) << "seed " << seed;
    EXPECT_TRUE(found.response.col(1).allFinite());
  }
}

TEST(Sweep, NoLoadNoResponse) {
  const SweepResult found = sweep(random_matrices(2), Eigen::VectorXcd::Zero(12), {0.0, 5.0});
  EXPECT_EQ(found.response.cwiseAbs().maxCoeff(), 0);
}

TEST(ResponseSeries, SumsToTheResponseAndAtInfinityToo) {
  const DynamicMatrices m = random_matrices(5);
  const Eigen::VectorXcd h = Eigen::VectorXcd::Constant(m.size(), Complex(1, 2));
  const double centre = 5000, radius = 40;
  const Eigen::MatrixXcd c = ResponseSeries(m, h).about(centre, radius, 30);
  const Eigen::MatrixXcd far = ResponseSeries(m, h).at_infinity(1 / 8000.0, 36).coefficients;
  Eigen::VectorXcd sum = Eigen::VectorXcd::Zero(m.size()), far_sum = sum;
  for (Eigen::Index j = 0; j <= 30; ++j) sum += c.col(j) * std::pow(0.7, static_cast<double>(j));
  for (Eigen::Index j = 0; j <= 36; ++j) far_sum += far.col(j) * std::pow(0.5, static_cast<double>(j));
  EXPECT_THAT(sum, test::NearVector(sweep(m, h, {centre + 0.7 * radius}).response.col(0).eval(), round_off));
  EXPECT_THAT((far_sum / (16000.0 * 16000.0)).eval(),
              test::NearVector(sweep(m, h, {16000.0}).response.col(0).eval(), round_off));
}

TEST(QuadraticRoots, ModalBasisAndCompanionAgree) {
  constexpr double relative = 1e-10, absolute = 1e-9;  // [rad/s] two eigensolvers, 24 states
  for (unsigned seed = 1; seed < 6; ++seed) {
    const DynamicMatrices m = random_matrices(seed);
    const GeneralizedModes modes = generalized_modes(m.K, m.A, true);
    QuadraticRoots one =
        roots_in_modal_basis(modes.lambda.cwiseSqrt(), modes.shapes.transpose() * m.B * modes.shapes, {});
    const QuadraticRoots two = roots_from_states(m);
    ASSERT_EQ(one.lambda.size(), two.lambda.size());
    for (Eigen::Index k = 0; k < one.lambda.size(); ++k)
      EXPECT_LE((two.lambda.array() - one.lambda(k)).abs().minCoeff(), relative * std::abs(one.lambda(k)) + absolute);
  }
}

TEST(QuadraticRoots, ValuesAloneAreThoseThatHaveVectors) {
  constexpr double relative = 1e-7;  // of the largest: a double root of a free body splits to √ε
  for (unsigned seed = 1; seed < 12; ++seed)
    for (const auto damping : {test::RandomDamping::none, test::RandomDamping::viscous, test::RandomDamping::loss}) {
      const bool supported = seed % 3 > 0;
      const DynamicMatrices m =
          assembly::assemble(test::checked(test::RandomSystem(seed).description(2, damping, supported))).matrices;
      const SystemRoots both = system_roots(m), alone = system_roots(m, RootParts::values);
      EXPECT_EQ(alone.roots.vectors.cols(), 0);
      ASSERT_EQ(alone.roots.lambda.size(), both.roots.lambda.size()) << "seed " << seed;
      const double scale = both.roots.lambda.cwiseAbs().maxCoeff();
      for (const Complex& root : both.roots.lambda)
        EXPECT_LE((alone.roots.lambda.array() - root).abs().minCoeff(), relative * scale) << "seed " << seed;
    }
}

TEST(QuadraticRoots, RefinementRecoversALightDampingRatio) {
  // ζ = 1e-7 and a second, stiff, well-damped coordinate: a double eigensolver gives few digits of Re λ.
  DynamicMatrices m{Eigen::MatrixXd::Identity(2, 2),
                    Eigen::Vector2d(2e-7, 1e4).asDiagonal(),
                    Eigen::Vector2d(1, 1e10).asDiagonal(),
                    {},
                    true};
  QuadraticRoots roots = roots_from_states(m);
  roots.lambda += Eigen::VectorXcd::Constant(4, Complex(3e-9, 0));
  refine_roots(m, roots);
  Eigen::Index nearest = 0;
  (roots.lambda.array() - Complex(0, 1)).abs().minCoeff(&nearest);
  constexpr double last_digit = 1e-9;  // a double of |λ| = 1 resolves 2e-9 of its real part
  EXPECT_THAT(roots.lambda(nearest).real(), test::RelativelyNear(-1e-7, last_digit));
}

TEST(QuadraticRoots, RefinementOfLossySystemsIsOfThoseThatAreMotions) {
  // λ² + 1 + iη = 0: λ = ±i√(1 + iη); with η in K only that with Im λ > 0 is a motion.
  constexpr double eta = 0.1, off = 1e-9;
  DynamicMatrices m{Eigen::MatrixXd::Identity(1, 1), Eigen::MatrixXd::Zero(1, 1), Eigen::MatrixXd::Identity(1, 1),
                    Eigen::MatrixXd::Constant(1, 1, eta), true};
  QuadraticRoots roots = roots_from_states(m);
  roots.lambda += Eigen::VectorXcd::Constant(2, Complex(off, 0));
  const Eigen::VectorXcd starts = roots.lambda;
  refine_roots(m, roots);
  const Complex exact = Complex(0, 1) * std::sqrt(Complex(1, eta));
  constexpr double few_roundings = 1e-15;
  for (Eigen::Index k = 0; k < 2; ++k)
    if (starts(k).imag() > 0) EXPECT_LT(std::abs(roots.lambda(k) - exact), few_roundings);
    else EXPECT_EQ(roots.lambda(k), starts(k));
}

TEST(GeneralizedModes, ASoftModeAmongStiffOnesKeepsItsDigits) {
  const Eigen::Matrix3d K = Eigen::Vector3d(1e-6, 1e6, 1e8).asDiagonal();
  const auto modes = generalized_modes(K, Eigen::Matrix3d::Identity(), true);
  constexpr double few_roundings = 1e-14;  // a diagonal matrix needs scaling only
  EXPECT_THAT(modes.lambda(0), test::RelativelyNear(1e-6, few_roundings));
}

TEST(GeneralizedModes, UnsymmetricSystemsReportComplexPairs) {
  Eigen::Matrix2d K;
  K << 10, 4, -4, 10;  // circulatory: λ = 10 ± 4i
  const auto modes = generalized_modes(K, Eigen::Matrix2d::Identity(), false);
  EXPECT_EQ(modes.lambda.size(), 0);
  EXPECT_EQ(modes.complex_pairs, 1);
}

}  // namespace numerics_test
