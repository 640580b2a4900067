// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>
#include <complex>
#include <random>
#include <string>

#include "trivet/numerics/lanes/instruction_set.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/lane_lu.h"
#include "trivet/numerics/periodic/fourier_basis.h"
#include "trivet/numerics/periodic/fourier_products.h"
#include "trivet/numerics/periodic/linear_flow.h"

/// Kernels of steps along a curve in lanes against the plain ones, under every instruction set.
namespace lane_steps_test {

using namespace trivet;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns, std::mt19937& random) {
  std::normal_distribution<double> normal;
  return MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
}

template <typename Check>
void under_each_instruction_set(const Check& check) {
  for (const std::string& name : numerics::instruction_sets()) {
    numerics::use_instruction_set(name);
    SCOPED_TRACE(name);
    check();
    numerics::use_instruction_set("");
  }
}

TEST(LaneLu, SolvesAsThePivotedOne) {
  under_each_instruction_set([] {
    std::mt19937 random(7);
    for (const Eigen::Index n : {1, 2, 3, 4, 5, 7, 8, 9, 12, 16, 17, 31, 64, 77, 103, 200, 243}) {
      const MatrixXd A = random_matrix(n, n, random);
      const VectorXd b = random_matrix(n, 1, random), x = numerics::LaneLu(A).solve(b);
      const double size = A.cwiseAbs().rowwise().sum().maxCoeff() * x.cwiseAbs().maxCoeff();
      constexpr double backward = 1e-14;  // ε times the growth of pivoted elimination, which stays below 10
      EXPECT_LE((A * x - b).cwiseAbs().maxCoeff(), backward * size) << n << " rows";
      EXPECT_EQ(numerics::LaneLu(A).determinant_sign(), A.determinant() < 0 ? -1 : 1) << n << " rows";
      const VectorXd other = numerics::PivotedLu<double>(A).solve(b);
      constexpr double round_off = 1e-10;  // ε times the condition of random matrices of 200 rows, up to 1e5
      EXPECT_LE((x - other).norm(), round_off * other.norm()) << n << " rows";
    }
  });
}

TEST(LaneLu, ExchangesRowsAndHasNoUsableSolutionOfSingularMatrices) {
  under_each_instruction_set([] {
    MatrixXd A{{0, 2, 1}, {1, 0, 0}, {0, 0, 4}};
    const VectorXd x = numerics::LaneLu(A).solve(VectorXd{{3, 5, 8}});
    EXPECT_EQ(x, (VectorXd{{5, 0.5, 2}}));
    A.row(2) = A.row(0);
    EXPECT_FALSE(numerics::LaneLu(A).solve(VectorXd{{3, 5, 8}}).allFinite());
    EXPECT_EQ(numerics::LaneLu(A).determinant_sign(), 0);
    const VectorXd by_round_off = numerics::LaneLu(MatrixXd{{1, 2}, {3, 6}}).solve(VectorXd{{1, 1}});
    EXPECT_FALSE(by_round_off.allFinite() && by_round_off.norm() < 1e15);
  });
}

TEST(HarmonicReceptance, AreThoseOfComplexAmplitudes) {
  under_each_instruction_set([] {
    std::mt19937 random(13);
    for (const Eigen::Index harmonics : {1, 2, 3, 4, 7, 9, 16}) {
      constexpr Eigen::Index first = 1, count = 2, courses = 3;
      const Eigen::Index C = numerics::coefficient_count(harmonics);
      // g_r and g_i of each harmonic; the mean has a real receptance alone.
      const MatrixXd real = random_matrix(harmonics + 1, first + count, random),
                     imaginary = random_matrix(harmonics + 1, first + count, random);
      numerics::HarmonicReceptance receptances{MatrixXd(C, first + count), MatrixXd(C, first + count)};
      for (Eigen::Index i = 0; i < first + count; ++i) {
        receptances.on_own(0, i) = real(0, i);
        receptances.on_other(0, i) = 0;
        for (Eigen::Index k = 1; k <= harmonics; ++k) {
          receptances.on_own(2 * k - 1, i) = receptances.on_own(2 * k, i) = real(k, i);
          receptances.on_other(2 * k - 1, i) = imaginary(k, i);
          receptances.on_other(2 * k, i) = -imaginary(k, i);
        }
      }
      const MatrixXd of = random_matrix(C, courses, random), before = random_matrix(count * C, courses, random);
      MatrixXd sums = before;
      numerics::add_responses(receptances, first, count, of, sums);
      constexpr double round_off = 1e-14;
      for (Eigen::Index j = 0; j < courses; ++j)
        for (Eigen::Index i = 0; i < count; ++i) {
          const auto added = (sums - before).col(j).segment(i * C, C);
          EXPECT_NEAR(added(0), real(0, first + i) * of(0, j), round_off);
          for (Eigen::Index k = 1; k <= harmonics; ++k) {
            const std::complex<double> amplitude(of(2 * k - 1, j), -of(2 * k, j)),
                result = std::complex<double>(real(k, first + i), imaginary(k, first + i)) * amplitude;
            EXPECT_NEAR(added(2 * k - 1), result.real(), round_off);
            EXPECT_NEAR(added(2 * k), -result.imag(), round_off);
          }
        }
    }
  });
}

TEST(LinearFlow, KicksInLanesAreThoseOneByOne) {
  under_each_instruction_set([] {
    std::mt19937 random(11);
    for (const Eigen::Index n : {2, 5, 9, 12, 17, 31}) {  // one to nine packs of columns
      const numerics::LinearFlow flow(random_matrix(n, n, random));
      ASSERT_TRUE(flow.is_diagonalizable());
      const Eigen::Index forces = 1 + n / 3, values = 2 * forces, resting = 2, steps = 9;
      const numerics::LinearFlow::Kicks kicks{random_matrix(n + resting, forces, random),
                                              random_matrix(values, n + resting, random),
                                              0.1 * random_matrix(forces * steps, values, random)};
      constexpr double step = 0.07;
      numerics::RowMatrix y = random_matrix(n + resting, n + resting, random), expected = y;
      flow.apply_with_kicks(step, kicks, y);
      const auto half_step = [&] {
        numerics::RowMatrix moving = expected.topRows(n);
        flow.apply(flow.step(step / 2), moving);
        expected.topRows(n) = moving;
      };
      for (Eigen::Index s = 0; s < steps; ++s) {
        half_step();
        expected += (kicks.kick * kicks.jacobians.middleRows(s * forces, forces) * kicks.seen * expected).eval();
        half_step();
      }
      constexpr double round_off = 1e-12;  // of a hundred operations per entry
      EXPECT_LE((y - expected).norm(), round_off * expected.norm()) << n << " states";
    }
  });
}

}  // namespace lane_steps_test
