// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/family/frequency_slopes.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <random>

namespace separated_motions_test {

using namespace trivet;
using Eigen::MatrixXd;

constexpr double round_off = 1e-13;

double real_part(std::complex<double> change) { return change.real(); }

std::vector<MatrixXd> symmetric_changes(unsigned seed, int count, int size) {
  std::mt19937 random(seed);
  std::normal_distribution<double> number;
  std::vector<MatrixXd> changes;
  for (int j = 0; j < count; ++j) {
    MatrixXd change(size, size);
    for (double& entry : change.reshaped()) entry = number(random);
    changes.emplace_back(change + change.transpose());
  }
  return changes;
}

std::vector<Eigen::MatrixXcd> complex_of(const std::vector<MatrixXd>& changes) {
  return {changes.begin(), changes.end()};
}

Eigen::VectorXd eigenvalues(const MatrixXd& change) {
  return Eigen::SelfAdjointEigenSolver<MatrixXd>(change).eigenvalues();
}

TEST(SeparatedMotions, HaveTheEigenvaluesAlongTheParameterThatPartsThemMost) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const std::vector<MatrixXd> changes = symmetric_changes(seed, 4, 3);
    const MatrixXd slopes = study::separated_motions(complex_of(changes), Eigen::Vector4d(1, 1, 1, 1), real_part);
    double widest = 0;
    Eigen::Index at = 0;
    for (std::size_t j = 0; j < changes.size(); ++j) {
      const Eigen::VectorXd all = eigenvalues(changes[j]);
      if (all(2) - all(0) <= widest) continue;
      widest = all(2) - all(0);
      at = static_cast<Eigen::Index>(j);
    }
    EXPECT_TRUE(slopes.col(at).isApprox(eigenvalues(changes[static_cast<std::size_t>(at)]), round_off));
  }
}

/// Whatever the direction: the least value grows at most so fast, and the values part at least so fast.
TEST(SeparatedMotions, BoundTheOneSidedSlopesInEveryDirection) {
  std::mt19937 random(7);
  std::normal_distribution<double> number;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const std::vector<MatrixXd> changes = symmetric_changes(seed, 4, 2);
    const MatrixXd slopes = study::separated_motions(complex_of(changes), Eigen::Vector4d(1, -2, 3, 1), real_part);
    for (int i = 0; i < 50; ++i) {
      Eigen::Vector4d direction;
      MatrixXd along = MatrixXd::Zero(2, 2);
      for (std::size_t j = 0; j < 4; ++j) {
        direction(static_cast<Eigen::Index>(j)) = number(random);
        along += direction(static_cast<Eigen::Index>(j)) * changes[j];
      }
      const Eigen::VectorXd found = slopes * direction, exact = eigenvalues(along);
      EXPECT_LE(exact(0), found.minCoeff() + round_off);
      EXPECT_GE(exact(1) - exact(0), found(1) - found(0) - round_off);
    }
  }
}

TEST(SeparatedMotions, TurnToTheOtherSideWhereAParameterMayOnlyFall) {
  const std::vector<MatrixXd> changes = symmetric_changes(3, 1, 2);
  const Eigen::VectorXd towards = Eigen::VectorXd::Constant(1, -1);
  const MatrixXd slopes = study::separated_motions(complex_of(changes), towards, real_part);
  const Eigen::VectorXd all = eigenvalues(changes[0]);
  EXPECT_NEAR(slopes(0, 0), all(1), round_off);
  EXPECT_NEAR(slopes(1, 0), all(0), round_off);
}

}  // namespace separated_motions_test
