// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/pair_form.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <vector>

namespace pair_form_test {

using namespace trivet;

/// Products of matrices of some ten rows whose projectors have norms of a hundred at most.
constexpr double round_off = 1e4 * std::numeric_limits<double>::epsilon();
constexpr Eigen::Index multiple = 8;

/// Displacements and velocities of n oscillators of unit mass with dampers between neighbours.
Eigen::MatrixXd damped_oscillators(Eigen::Index n) {
  Eigen::MatrixXd F = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double omega = 1 + 0.7 * static_cast<double>(i);
    F(i, n + i) = omega;
    F(n + i, i) = -omega;
    F(n + i, n + i) = -0.3 - 0.02 * static_cast<double>(i * i);
    if (i > 0) F(n + i, n + i - 1) = F(n + i - 1, n + i) = 0.12;
  }
  return F;
}

double largest(const Eigen::MatrixXd& m) { return m.cwiseAbs().maxCoeff(); }

void expect_form_of(const Eigen::MatrixXd& F, const numerics::PairForm& form) {
  const Eigen::Index n = F.rows();
  EXPECT_LE(largest(form.X * form.D * form.Y - F), round_off * largest(F));
  EXPECT_LE(largest(form.X * form.Y - Eigen::MatrixXd::Identity(n, n)), round_off);
}

TEST(PairForm, SeparatesDampedOscillatorsIntoPairs) {
  const Eigen::MatrixXd F = damped_oscillators(6);
  const numerics::PairForm form = numerics::pair_form(F, multiple);
  expect_form_of(F, form);
  EXPECT_EQ(form.groups.pairs, 8);
  EXPECT_THAT(form.groups.dense, testing::IsEmpty());
  for (Eigen::Index i = 0; i < 16; ++i)
    for (Eigen::Index j = 0; j < 16; ++j)
      if (i % 8 != j % 8) {
        EXPECT_EQ(form.D(i, j), 0) << i << " " << j;
      }
}

TEST(PairForm, SeparatesRealPolesAndAnOddNumberOfStates) {
  // One oscillator, one state that decays, and one over-damped oscillator, all coupled.
  Eigen::MatrixXd F = Eigen::MatrixXd::Zero(5, 5);
  F << 0, 3, 0, 0, 0, -3, -0.2, 0.4, 0, 0.1, 0, 0.5, -7, 0, 0, 0, 0, 0, 0, 2, 0, 0.3, 0, -2, -9;
  const numerics::PairForm form = numerics::pair_form(F, multiple);
  expect_form_of(F, form);
  EXPECT_EQ(form.groups.pairs, 8);
  EXPECT_THAT(form.groups.dense, testing::IsEmpty());
}

TEST(PairForm, KeepsUndampedModesAndRigidBodyModesAsTheyAre) {
  // The second oscillator has no stiffness: its pair of poles at 0 has one vector only.
  Eigen::MatrixXd F = Eigen::MatrixXd::Zero(4, 4);
  F(0, 2) = 5;
  F(2, 0) = -5;
  F(1, 3) = 1;
  const numerics::PairForm form = numerics::pair_form(F, multiple);
  EXPECT_EQ(largest(form.X * form.D * form.Y - F), 0);
  EXPECT_THAT(form.groups.dense, testing::IsEmpty());
}

TEST(PairForm, KeepsStatesWithParallelVectorsInOneGroup) {
  // Three nearly equal poles with nearly parallel vectors, driven by an oscillator.
  Eigen::MatrixXd F = Eigen::MatrixXd::Zero(5, 5);
  F << -1, 1, 0, 0, 0, 0, -1.001, 1, 0, 0, 0, 0, -1.002, 0.5, 0, 0, 0, 0, 0, 4, 0, 0, 0, -4, 0;
  const numerics::PairForm form = numerics::pair_form(F, multiple);
  EXPECT_EQ(form.groups.pairs, 0);
  EXPECT_THAT(form.groups.dense, testing::ElementsAre(5));
  EXPECT_EQ(largest(form.X * form.D * form.Y - F), 0);
}

TEST(PairForm, KeepsTheDigitsOfSlowPolesBesideFastOnes) {
  // ω = 1 … 1e6 rad/s, coupled by damping. Eigenvectors without improvement miss the slow entries by 1e-12.
  constexpr double some_roundings = 1e-14;
  constexpr Eigen::Index n = 6;
  const double omega[n] = {1, 1.3, 1.6, 6e4, 2e5, 1e6};
  Eigen::MatrixXd F = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  for (Eigen::Index i = 0; i < n; ++i) {
    F(i, n + i) = omega[i];
    F(n + i, i) = -omega[i];
    for (Eigen::Index j = 0; j < n; ++j)
      F(n + i, n + j) =
          -(i == j ? 0.06 : 0.02 * std::sin(static_cast<double>(1 + i * j + i + j))) * std::sqrt(omega[i] * omega[j]);
  }
  const numerics::PairForm form = numerics::pair_form(F, multiple);
  EXPECT_THAT(form.groups.dense, testing::IsEmpty());
  const Eigen::MatrixXd missed = form.X * form.D * form.Y - F;
  const std::vector<Eigen::Index> slow = {0, 1, 2, n, n + 1, n + 2};
  EXPECT_LE(largest(missed(slow, slow)), some_roundings);
}

}  // namespace pair_form_test
