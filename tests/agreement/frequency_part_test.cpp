// SPDX-License-Identifier: BSD-3-Clause
// Sweeps of systems with a frequency-dependent part, against pivoted LU in extended precision, one frequency at a time.
#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "support/matchers.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/lanes/instruction_set.h"
#include "trivet/numerics/linalg/refined_solution.h"
#include "trivet/numerics/sweep/frequency_sweep.h"

namespace frequency_part_test {

using namespace trivet;
using namespace trivet::numerics;
using Eigen::Index;

/// Backward stability allows round-off times the condition, and a little for the sums over many rows.
constexpr double condition_share = 64 * test::epsilon;

/// A chain of bodies with constant elements, and springs of fractional-derivative stiffness between some of its bodies;
/// the other end of one spring is driven.
class Springs {
 public:
  Springs(Index n, bool symmetric) : n_(n), generator_(static_cast<unsigned>(n)), load_(n) {
    system_ = {
        Eigen::MatrixXd::Identity(n, n), Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, n), {}, symmetric};
    for (Index i = 0; i < n; ++i) system_.A(i, i) = 1 + static_cast<double>(i % 4);  // different masses and inertias
    std::vector<Index> rows;
    for (Index first = 0; first < n; first += 6) {
      system_.blocks.push_back(first);
      rows = range(first, std::min(first + 12, n));
      const Eigen::MatrixXd stiffness = positive(static_cast<Index>(rows.size()));
      system_.K(rows, rows) += 1000 * stiffness;
      system_.B(rows, rows) += 5 * stiffness;
    }
    for (const Index first : {Index(0), Index(n - 6), n / 2 - 2}) {
      groups_.push_back(range(first, first + 3));
      for (const Index row : range(n - 3, n)) groups_.back().push_back(row);
      stiffness_.push_back(800 * positive(6));
    }
    if (!symmetric) stiffness_[1](0, 3) += 100;
    Eigen::VectorXcd h(n);
    for (Complex& x : h) x = {normal_(generator_), normal_(generator_)};
    load_.add({0, 0, h});
    load_.add({1, 0.02, 0.1 * h.reverse()});
  }

  [[nodiscard]] const DynamicMatrices& constant() const { return system_; }
  [[nodiscard]] const Load& load() const { return load_; }

  void add(double omega, Eigen::MatrixXcd& z, Eigen::VectorXcd& h) const {
    for (std::size_t e = 0; e < groups_.size(); ++e) {
      const Complex law = 1.0 + 0.3 * std::pow(Complex(0, omega / 20), 0.4);
      z(groups_[e], groups_[e]) += law * stiffness_[e];
      if (e == 0) h(groups_[e]) += law * stiffness_[e].col(0);
    }
  }

  /// The frequency-dependent part; it declares the rows of the first `coupled` springs only.
  [[nodiscard]] FrequencyPart part(std::size_t coupled = 3) const {
    return {[this](double omega, Eigen::MatrixXcd& z, Eigen::VectorXcd& h) { add(omega, z, h); },
            {groups_.begin(), groups_.begin() + static_cast<std::ptrdiff_t>(coupled)}};
  }

  void expect_solved(const SweepResult& found, const std::vector<double>& omega, const std::string& name) const {
    const Eigen::VectorXd d = unit_scale(system_);
    for (std::size_t i = 0; i < omega.size(); ++i) {
      Eigen::MatrixXcd z = system_.at(omega[i]);
      Eigen::VectorXcd h = load_.at(omega[i]);
      add(omega[i], z, h);
      const ExtendedMatrix exact_z = (d.asDiagonal() * z * d.asDiagonal()).cast<std::complex<long double>>();
      const RefinedSolver exact(exact_z);
      const ExtendedVector truth = exact.solve((d.asDiagonal() * h).cast<std::complex<long double>>());
      const ExtendedVector q =
          (d.cwiseInverse().asDiagonal() * found.response.col(static_cast<Index>(i))).cast<std::complex<long double>>();
      EXPECT_LE(static_cast<double>((q - truth).norm() / truth.norm()),
                condition_share * static_cast<double>(n_) * exact.condition())
          << name << " at " << omega[i];
      if (found.backward_error.size() > 0) {
        EXPECT_LE(found.backward_error(static_cast<Index>(i)), accepted_backward_error) << name << " at " << omega[i];
      }
    }
  }

 private:
  static std::vector<Index> range(Index from, Index to) {
    std::vector<Index> rows;
    for (Index i = from; i < to; ++i) rows.push_back(i);
    return rows;
  }

  Eigen::MatrixXd positive(Index n) {
    Eigen::MatrixXd x(n, n);
    for (double& entry : x.reshaped()) entry = normal_(generator_);
    return x * x.transpose() / static_cast<double>(n) + 0.3 * Eigen::MatrixXd::Identity(n, n);
  }

  Index n_;
  std::mt19937 generator_;
  std::normal_distribution<double> normal_;
  DynamicMatrices system_;
  std::vector<std::vector<Index>> groups_;
  std::vector<Eigen::MatrixXd> stiffness_;
  Load load_;
};

std::vector<double> frequencies(Index count) {
  std::vector<double> omega;
  for (Index i = 0; i < count; ++i) omega.push_back(90 * (static_cast<double>(i) + 0.3) / static_cast<double>(count));
  return omega;
}

TEST(FrequencyPart, SmallAndLargeSystemsAgreeWithOneFrequencyAfterAnother) {
  const std::vector<double> omega = frequencies(41);
  for (const Index n : {11, 20, 60})
    for (const bool symmetric : {true, false})
      for (const bool every : {true, false}) {
        const Springs springs(n, symmetric);
        const SweepOptions options{.every_backward_error = every, .threads = 1, .progress = {}};
        const SweepResult found = sweep(springs.constant(), springs.load(), springs.part(), omega, options);
        EXPECT_EQ(found.fallbacks + found.singular, 0) << n;
        springs.expect_solved(found, omega, std::to_string(n));
        springs.expect_solved(sweep(springs.constant(), springs.load(), springs.part(0), omega, options), omega,
                              std::to_string(n) + ", couples all");
      }
}

TEST(FrequencyPart, EveryInstructionSetSolvesIt) {
  const std::vector<double> omega = frequencies(19);
  const Springs springs(20, true);
  for (const std::string& name : instruction_sets()) {
    use_instruction_set(name);
    const SweepResult found = sweep(springs.constant(), springs.load(), springs.part(), omega);
    use_instruction_set("");
    springs.expect_solved(found, omega, name);
  }
}

TEST(FrequencyPart, OneThatAddsOutsideItsRowsIsRejected) {
  const Springs springs(20, true);
  EXPECT_THROW((void)sweep(springs.constant(), springs.load(), springs.part(2), frequencies(5)),
               foundation::InvalidInput);
}

TEST(FrequencyPart, AVanishingPivotIsRejectedAndSolvedWithPivoting) {
  // The part cancels the mass of a coordinate without stiffness and damping; only couplings hold it.
  DynamicMatrices m = Springs(20, true).constant();
  m.K(19, 19) = m.B(19, 19) = 0;
  const FrequencyPart part{
      [mass = m.A(19, 19)](double omega, Eigen::MatrixXcd& z, Eigen::VectorXcd&) { z(19, 19) += omega * omega * mass; },
      {{19}}};
  const Load load(Eigen::VectorXcd::Ones(20));
  const std::vector<double> omega = {9.5, 10};
  constexpr double residual = 1e-9;  // far below 1, with entries up to some 1000
  const SweepResult found = sweep(m, load, part, omega);
  EXPECT_EQ(found.singular, 0);
  EXPECT_LE(found.backward_error.maxCoeff(), accepted_backward_error);
  for (Index i = 0; i < 2; ++i) {
    Eigen::MatrixXcd z = m.at(omega[i]);
    z(19, 19) = 0;
    EXPECT_LE((z * found.response.col(i) - Eigen::VectorXcd::Ones(20)).norm(), residual);
  }
}

TEST(FrequencyPart, SixteenThreadsGiveTheBytesOfOne) {
  const Springs springs(20, true);
  const std::vector<double> omega = frequencies(20001);
  SweepOptions one{.every_backward_error = true, .threads = 1, .progress = {}}, sixteen = one;
  sixteen.threads = 16;
  const SweepResult a = sweep(springs.constant(), springs.load(), springs.part(), omega, one),
                    b = sweep(springs.constant(), springs.load(), springs.part(), omega, sixteen);
  EXPECT_EQ(a.response, b.response);
  EXPECT_EQ(a.backward_error, b.backward_error);
}

}  // namespace frequency_part_test
