// SPDX-License-Identifier: BSD-3-Clause
// Modes of many designs in lanes against Eigen in extended precision, design by design.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <random>

#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/lanes/instruction_set.h"
#include "trivet/numerics/roots/design_modes.h"

namespace design_modes_test {

using namespace trivet;
using numerics::DesignModes;
using numerics::Designs;
using Extended = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

struct RestoreInstructionSet {
  ~RestoreInstructionSet() { numerics::use_instruction_set(""); }
};

Eigen::MatrixXd random_matrix(std::mt19937& generator, int n) {
  std::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(n, n, [&] { return normal(generator); });
}

Designs empty_designs(Eigen::Index count, int n) {
  const Eigen::Index entries = n * (n + 1) / 2;
  return {Eigen::ArrayXXd(count, entries), Eigen::ArrayXXd::Zero(count, entries), Eigen::ArrayXXd(count, entries),
          Eigen::ArrayXXd::Ones(1, n)};
}

/// Rows and columns in units that differ by up to 1e6, like metres and radians.
Designs random_designs(Eigen::Index count, int n, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> exponent(-3, 3);
  Designs designs = empty_designs(count, n);
  for (Eigen::Index design = 0; design < count; ++design) {
    const Eigen::MatrixXd g = random_matrix(generator, n), h = random_matrix(generator, n);
    const Eigen::VectorXd unit = Eigen::VectorXd::NullaryExpr(n, [&] { return std::pow(10.0, exponent(generator)); });
    const Eigen::MatrixXd mass = g * g.transpose() + 0.5 * n * Eigen::MatrixXd::Identity(n, n),
                          stiffness = h * h.transpose() + Eigen::MatrixXd::Identity(n, n);
    numerics::pack(unit.asDiagonal() * mass * unit.asDiagonal(), designs.A, design);
    numerics::pack(1e4 * (unit.asDiagonal() * stiffness * unit.asDiagonal()), designs.K, design);
  }
  return designs;
}

/// λ of K φ = λ A φ for positive definite K, ascending. For small λ singular values lose half as many digits as an
/// eigensolver.
Eigen::VectorXd squared_singular_values(const Extended& K, const Extended& A) {
  const Extended k = K.llt().matrixL(), a = A.llt().matrixL();
  const Extended ratio = a.triangularView<Eigen::Lower>().solve(k);
  return Eigen::JacobiSVD<Extended>(ratio).singularValues().reverse().cwiseAbs2().cast<double>();
}

void expect_modes(const Designs& designs, const DesignModes& found, int n, double tolerance) {
  const double of_stiffness = 10 * tolerance;  // over √(λ_i λ_j), and λ spans several decades
  for (Eigen::Index design = 0; design < designs.A.rows(); ++design) {
    const Extended A = numerics::unpacked(designs.A, design).cast<long double>(),
                   K = numerics::unpacked(designs.K, design).cast<long double>();
    const Eigen::VectorXd exact = squared_singular_values(K, A), values = found.lambda.row(design);
    ASSERT_TRUE(found.definite[design]);
    for (int i = 0; i < n; ++i)
      EXPECT_NEAR(values(i), exact(i), tolerance * exact(i)) << "n = " << n << ", design " << design;
    if (found.shapes.size() == 0) continue;
    const Extended phi = Eigen::VectorXd(found.shapes.row(design)).reshaped(n, n).cast<long double>();
    const Extended mass = phi.transpose() * A * phi, stiffness = phi.transpose() * K * phi;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        EXPECT_NEAR(static_cast<double>(mass(i, j)), i == j ? 1 : 0, tolerance) << "n = " << n << ", design " << design;
        const double relative = static_cast<double>(stiffness(i, j)) / std::sqrt(values(i) * values(j));
        EXPECT_NEAR(relative, i == j ? 1 : 0, of_stiffness) << "n = " << n << ", design " << design;
      }
  }
}

// Errors grow with the condition of the matrices, here below 1e3, and with n.
constexpr double round_off = 4000 * epsilon;

TEST(DesignModes, AreThoseOfExtendedPrecisionForAnyNumberOfCoordinatesOnEveryInstructionSet) {
  const RestoreInstructionSet restore;
  for (const std::string& set : numerics::instruction_sets()) {
    numerics::use_instruction_set(set);
    for (int n = 1; n <= 14; ++n) {
      const Designs designs = random_designs(19, n, 1);
      expect_modes(designs, numerics::design_modes(designs), n, round_off);
      expect_modes(designs, numerics::design_modes(designs, {.shapes = false}), n, round_off);
    }
  }
}

TEST(DesignModes, SoftModesBesideStiffOnesKeepTheirDigits) {
  Designs designs = empty_designs(8, 6);
  for (Eigen::Index design = 0; design < 8; ++design) {
    std::mt19937 generator(static_cast<unsigned>(design));
    const Eigen::MatrixXd g = random_matrix(generator, 6);
    const Eigen::VectorXd stiff = (Eigen::VectorXd(6) << 1e-3, 1, 1e3, 1e4, 1e6, 1e8).finished().cwiseSqrt();
    numerics::pack(Eigen::MatrixXd::Identity(6, 6), designs.A, design);
    numerics::pack(stiff.asDiagonal() * (0.1 * (g + g.transpose()) / g.norm() + Eigen::MatrixXd::Identity(6, 6)) *
                       stiff.asDiagonal(),
                   designs.K, design);
  }
  expect_modes(designs, numerics::design_modes(designs), 6, round_off);
}

TEST(DesignModes, CoincidentAndRigidModesStayOrthonormal) {
  std::mt19937 generator(3);
  Designs designs = empty_designs(9, 6);
  for (Eigen::Index design = 0; design < 9; ++design) {
    const Eigen::MatrixXd g = random_matrix(generator, 6), a = g * g.transpose() + Eigen::MatrixXd::Identity(6, 6);
    const Eigen::MatrixXd basis =
        Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(g + g.transpose(), a).eigenvectors().inverse();
    const Eigen::VectorXd lambda = (Eigen::VectorXd(6) << 0, 0, 7, 7, 7, 100).finished();
    numerics::pack(a, designs.A, design);
    numerics::pack(basis.transpose() * lambda.asDiagonal() * basis, designs.K, design);
  }
  const DesignModes found = numerics::design_modes(designs);
  for (Eigen::Index design = 0; design < 9; ++design) {
    const Eigen::MatrixXd phi = Eigen::VectorXd(found.shapes.row(design)).reshaped(6, 6),
                          A = numerics::unpacked(designs.A, design), K = numerics::unpacked(designs.K, design);
    EXPECT_LE((phi.transpose() * A * phi - Eigen::MatrixXd::Identity(6, 6)).cwiseAbs().maxCoeff(), round_off);
    const Eigen::VectorXd expected = (Eigen::VectorXd(6) << 0, 0, 7, 7, 7, 100).finished();
    EXPECT_LE((phi.transpose() * K * phi - Eigen::MatrixXd(expected.asDiagonal())).cwiseAbs().maxCoeff(),
              round_off * expected.maxCoeff());
    EXPECT_LE((found.lambda.row(design).transpose() - expected.array()).abs().maxCoeff(),
              round_off * expected.maxCoeff());
  }
}

TEST(DesignModes, AMassThatIsNotDefiniteIsFlaggedAndNeverSolved) {
  Designs designs = random_designs(20, 6, 5);
  const auto spoil = [&](Eigen::Index design, double smallest) {
    Eigen::MatrixXd mass = Eigen::MatrixXd::Ones(6, 6) * 0.5 + 0.5 * Eigen::MatrixXd::Identity(6, 6);
    mass(5, 4) = mass(4, 5) = 1 - smallest;  // rows 4 and 5 are equal except for this
    numerics::pack(mass, designs.A, design);
  };
  spoil(3, 0);
  spoil(4, 1e-15);
  spoil(9, -1e-3);
  spoil(10, 1e-10);
  designs.A(11, 2) = std::numeric_limits<double>::quiet_NaN();
  designs.K(17, 7) = std::numeric_limits<double>::infinity();
  const DesignModes found = numerics::design_modes(designs),
                    without = numerics::design_modes(designs, {.shapes = false});
  const DesignModes good = numerics::design_modes(random_designs(20, 6, 5));
  for (Eigen::Index design = 0; design < 20; ++design) {
    const bool bad = design == 3 || design == 4 || design == 9 || design == 11 || design == 17;
    EXPECT_EQ(found.definite[design], !bad) << design;
    EXPECT_EQ(without.definite[design], !bad) << design;
    EXPECT_EQ(found.lambda.row(design).isNaN().all(), bad) << design;
    EXPECT_EQ(found.shapes.row(design).isNaN().all(), bad) << design;
    if (bad || design == 10) continue;
    EXPECT_LE((found.lambda.row(design) / good.lambda.row(design) - 1).abs().maxCoeff(), round_off)
        << "a neighbour in the lanes spoils design " << design;
  }
}

TEST(DesignModes, AreTheSameBytesForOneAndSixteenThreads) {
  const Designs designs = random_designs(1500, 6, 8);
  const DesignModes one = numerics::design_modes(designs, {.threads = 1}),
                    sixteen = numerics::design_modes(designs, {.threads = 16});
  EXPECT_TRUE((one.lambda == sixteen.lambda).all());
  EXPECT_TRUE((one.shapes == sixteen.shapes).all());
}

TEST(DesignModes, NeedMatricesOfOneShape) {
  Designs designs = random_designs(4, 3, 1);
  designs.K.conservativeResize(4, 5);
  EXPECT_THROW(static_cast<void>(numerics::design_modes(designs)), foundation::InvalidInput);
}

}  // namespace design_modes_test
