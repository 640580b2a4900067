// SPDX-License-Identifier: BSD-3-Clause
// The largest amplitudes of many designs against those of their full sweeps.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/batch/sweep_maxima.h"
#include "trivet/numerics/lanes/instruction_set.h"

namespace {

using namespace trivet::numerics;

constexpr double round_off = 4 * 2.3e-16;  // of a square, a sum and a root
constexpr double two_ways = 1e-11;         // by poles or directly: ε/ζ, ζ mostly above 1e-4
constexpr double undamped_too = 1e-9;      // ε over the distance to a resonance, without damping in one design

Eigen::MatrixXd random_matrix(std::mt19937& generator, Eigen::Index rows, Eigen::Index columns) {
  std::uniform_real_distribution<double> number(-1, 1);
  Eigen::MatrixXd result(rows, columns);
  for (double& entry : result.reshaped()) entry = number(generator);
  return result;
}

Designs random_designs(Eigen::Index count, Eigen::Index n, bool one_load) {
  std::mt19937 generator(11);
  Designs designs;
  designs.load = random_matrix(generator, one_load ? 1 : count, n).array();
  for (Eigen::ArrayXXd* each : {&designs.A, &designs.B, &designs.K}) each->resize(count, n * (n + 1) / 2);
  for (Eigen::Index d = 0; d < count; ++d) {
    const Eigen::MatrixXd r = random_matrix(generator, n, n), s = random_matrix(generator, n, n),
                          q = random_matrix(generator, n, n);
    const Eigen::MatrixXd A = Eigen::MatrixXd::Identity(n, n) + r * r.transpose(), B = 0.05 * q * q.transpose(),
                          K = 100 * s * s.transpose();
    pack(A, designs.A, d);
    pack(B, designs.B, d);
    pack(K, designs.K, d);
  }
  return designs;
}

std::vector<double> frequencies(std::size_t count) {
  std::vector<double> omega(count);
  for (std::size_t i = 0; i < count; ++i) omega[i] = 0.05 * static_cast<double>(i + 1);
  return omega;
}

TEST(SweepMaxima, AreTheLargestOfTheWholeSweep) {
  const SweepOptions quick{.every_backward_error = false, .threads = 1, .progress = {}};
  for (const Eigen::Index n : {1, 4, 6, 9}) {
    const Designs designs = random_designs(7, n, n == 4);
    const std::vector<double> omega = frequencies(517);
    const SweepMaxima together = sweep_maxima(designs, omega, quick);
    for (Eigen::Index d = 0; d < designs.count(); ++d) {
      const Eigen::VectorXcd load =
          designs.load.row(designs.load.rows() > 1 ? d : 0).matrix().transpose().cast<Complex>();
      const Eigen::MatrixXd all = sweep(matrices_of(designs, d), load, omega, quick).response.cwiseAbs();
      const SweepMaxima found = sweep_maxima(matrices_of(designs, d), load, omega, quick);
      for (Eigen::Index j = 0; j < n; ++j) {
        Eigen::Index where = 0;
        EXPECT_NEAR(found.amplitude(0, j), all.row(j).maxCoeff(&where), round_off * found.amplitude(0, j));
        EXPECT_EQ(found.angular_frequency(0, j), omega[trivet::to_size(where)]);
      }
      EXPECT_LE((together.amplitude.row(d) / found.amplitude.row(0) - 1).abs().maxCoeff(), two_ways);
      EXPECT_TRUE((together.angular_frequency.row(d) == found.angular_frequency.row(0)).all());
    }
  }
}

/// Undamped to overdamped designs, by poles if these are accurate, against direct solutions with every residual
/// computed.
TEST(SweepMaxima, ByPolesAreThoseOfDirectSolutionsOnEveryInstructionSet) {
  struct Restore {
    ~Restore() { trivet::numerics::use_instruction_set(""); }
  } restore;
  const std::vector<double> omega = frequencies(400);
  for (const Eigen::Index n : {1, 2, 6, 7, 12}) {
    Designs designs = random_designs(61, n, n == 2);
    for (Eigen::Index d = 0; d < designs.count(); ++d)
      designs.B.row(d) *= d == 5 ? 0.0 : std::pow(10.0, 4.0 * static_cast<double>(d) / 60 - 1);
    const SweepMaxima direct = sweep_maxima(designs, omega);
    for (const std::string& set : trivet::numerics::instruction_sets()) {
      trivet::numerics::use_instruction_set(set);
      const SweepMaxima found =
          sweep_maxima(designs, omega, {.every_backward_error = false, .threads = 2, .progress = {}});
      EXPECT_LE((found.amplitude / direct.amplitude - 1).abs().maxCoeff(), undamped_too) << set << ", n = " << n;
      EXPECT_EQ((found.angular_frequency != direct.angular_frequency).count(), 0) << set << ", n = " << n;
    }
  }
}

TEST(SweepMaxima, AreTheSameByteForByteOnOneThreadAndSixteen) {
  const Designs designs = random_designs(300, 6, true);
  const std::vector<double> omega = frequencies(100);
  const SweepMaxima one = sweep_maxima(designs, omega, {.every_backward_error = false, .threads = 1, .progress = {}});
  const SweepMaxima sixteen =
      sweep_maxima(designs, omega, {.every_backward_error = false, .threads = 16, .progress = {}});
  EXPECT_EQ(std::memcmp(one.amplitude.data(), sixteen.amplitude.data(),
                        sizeof(double) * trivet::to_size(one.amplitude.size())),
            0);
  EXPECT_EQ(one.fallbacks, sixteen.fallbacks);
}

TEST(SweepMaxima, AnUndampedResonanceInTheListIsInfinite) {
  const DynamicMatrices m{
      Eigen::MatrixXd::Identity(2, 2), Eigen::MatrixXd::Zero(2, 2), Eigen::Vector2d(4, 9).asDiagonal(), {}, true};
  const SweepMaxima found = sweep_maxima(m, Eigen::VectorXcd::Ones(2), {1.0, 2.0, 2.5, 3.0});
  EXPECT_TRUE(std::isinf(found.amplitude(0, 0)));
  EXPECT_EQ(found.angular_frequency(0, 0), 2.0);
  EXPECT_EQ(found.singular, 2);
}

TEST(SweepMaxima, AnEmptyListOfFrequenciesIsRejected) {
  EXPECT_THROW(static_cast<void>(sweep_maxima(random_designs(1, 2, true), {})), trivet::foundation::InvalidInput);
  Designs ragged = random_designs(3, 2, true);
  ragged.B.conservativeResize(2, ragged.B.cols());
  EXPECT_THROW(static_cast<void>(sweep_maxima(ragged, {1.0})), trivet::foundation::InvalidInput);
}

}  // namespace
