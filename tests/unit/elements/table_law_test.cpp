// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/table_law.h"

#include <gmock/gmock.h>

#include <random>

#include "support/matchers.h"
#include "trivet/elements/checks.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"

namespace table_law_test {

using namespace trivet;
using namespace trivet::elements;

constexpr double round_off = 1e-14;  // the ten operations of an interpolation between numbers of equal size

StiffnessTable over_frequencies(std::vector<double> frequencies, const std::vector<double>& storage,
                                Interpolation interpolation) {
  StiffnessTable table{.angular_frequencies = std::move(frequencies),
                       .amplitudes = {},
                       .storage = {},
                       .loss = {},
                       .interpolation = interpolation};
  table.storage = Eigen::Map<const Eigen::VectorXd>(storage.data(), to_index(storage.size()));
  table.loss = 0.1 * table.storage;
  return table;
}

TEST(StiffnessTable, PassesThroughItsKnots) {
  for (const Interpolation way : {Interpolation::linear, Interpolation::monotone_cubic}) {
    const StiffnessTable table = over_frequencies({0, 10, 30, 100}, {1e5, 3e5, 2.5e5, 8e5}, way);
    for (int i = 0; i < 4; ++i) {
      const auto k = dynamic_stiffness(table, table.angular_frequencies[i], 0);
      EXPECT_THAT(k.real(), test::RelativelyNear(table.storage(i, 0), round_off));
      EXPECT_THAT(k.imag(), test::RelativelyNear(table.loss(i, 0), round_off));
    }
  }
}

TEST(StiffnessTable, FollowsAStraightLineExactly) {
  for (const Interpolation way : {Interpolation::linear, Interpolation::monotone_cubic}) {
    const StiffnessTable table = over_frequencies({1, 2, 5, 7, 20}, {3, 5, 11, 15, 41}, way);
    for (double w = 1; w <= 20; w += 0.37)
      EXPECT_THAT(dynamic_stiffness(table, w, 0).real(), test::RelativelyNear(2 * w + 1, round_off));
  }
}

TEST(StiffnessTable, TheMonotoneCubicNeverOvershoots) {
  std::mt19937 engine(5);
  std::uniform_real_distribution<> random(0.1, 1);
  for (int round = 0; round < 200; ++round) {
    std::vector<double> frequencies{0}, storage{random(engine)};
    for (int i = 0; i < 5; ++i)
      frequencies.push_back(frequencies.back() + random(engine)), storage.push_back(random(engine));
    const StiffnessTable table = over_frequencies(frequencies, storage, Interpolation::monotone_cubic);
    for (std::size_t i = 0; i < 5; ++i)
      for (int j = 0; j <= 20; ++j) {
        const double value =
            dynamic_stiffness(
                table, std::min(frequencies[i] + j / 20.0 * (frequencies[i + 1] - frequencies[i]), frequencies.back()),
                0)
                .real();
        EXPECT_GE(value, std::min(storage[i], storage[i + 1]) - round_off);
        EXPECT_LE(value, std::max(storage[i], storage[i + 1]) + round_off);
      }
  }
}

TEST(StiffnessTable, TheMonotoneCubicConvergesFasterThanTheChord) {
  const auto error = [](int count, Interpolation way) {
    std::vector<double> frequencies, storage;
    for (int i = 0; i <= count; ++i)
      frequencies.push_back(1 + 9.0 * i / count), storage.push_back(std::log(frequencies.back()) + 1);
    const StiffnessTable table = over_frequencies(frequencies, storage, way);
    double worst = 0;
    for (double w = 1; w <= 10; w += 0.013)
      worst = std::max(worst, std::abs(dynamic_stiffness(table, w, 0).real() - std::log(w) - 1));
    return worst;
  };
  EXPECT_LT(error(40, Interpolation::monotone_cubic), error(40, Interpolation::linear) / 5);  // of higher order
  EXPECT_LT(error(80, Interpolation::linear), error(40, Interpolation::linear) / 3.5);        // second order
}

TEST(StiffnessTable, InterpolatesOverAmplitudeAndNeedsNoFrequencies) {
  StiffnessTable rope{.angular_frequencies = {},
                      .amplitudes = {1e-4, 1e-3},
                      .storage = Eigen::MatrixXd(1, 2),
                      .loss = Eigen::MatrixXd(1, 2)};
  rope.storage << 8e4, 3e4;
  rope.loss << 1e4, 1.5e4;
  EXPECT_TRUE(check(rope, "z").list().empty());
  const auto k = dynamic_stiffness(rope, 1234, 0.00055);
  EXPECT_THAT(k.real(), test::RelativelyNear(5.5e4, round_off));
  EXPECT_THAT(k.imag(), test::RelativelyNear(1.25e4, round_off));
}

TEST(StiffnessTable, RejectsFrequenciesOutsideItsRange) {
  const StiffnessTable table = over_frequencies({10, 100}, {1e5, 2e5}, Interpolation::linear);
  EXPECT_THROW((void)dynamic_stiffness(table, 9.99, 0), foundation::InvalidInput);
  EXPECT_THROW((void)dynamic_stiffness(table, 100.1, 0), foundation::InvalidInput);
  EXPECT_THROW((void)dynamic_stiffness(table, std::nan(""), 0), foundation::InvalidInput);
  EXPECT_NO_THROW((void)dynamic_stiffness(table, 100, 5));
}

TEST(TableLaw, ResistsNoRigidMotion) {
  TableLaw law;
  for (std::size_t i = 0; i < 6; ++i)
    law.directions[i] =
        over_frequencies({0, 10, 100}, {1e5 * (1.0 + static_cast<double>(i)), 2e5, 3e5}, Interpolation::monotone_cubic);
  law.directions[4] = {};
  law.centre = 0.3;
  const Eigen::Vector3d arm(0.1, -0.2, 0.4);
  const ComplexMatrix12 k = dynamic_stiffness(law, arm, 37, Vector6::Zero());
  for (const Matrix12& part : {Matrix12(k.real()), Matrix12(k.imag())}) {
    const MatrixVerdict verdict = examine(part, rigid_motions(arm, Eigen::Matrix3d::Identity()));
    constexpr double matrix_round_off = 1e-13;  // a dozen operations per scaled entry
    EXPECT_LE(verdict.rigid_residual, matrix_round_off);
    EXPECT_TRUE(is_semidefinite(verdict));
  }
  EXPECT_EQ(frequency_range(law).to, 100);
}

TEST(TableLaw, ChecksNameTheTableAndTheRow) {
  TableLaw law;
  EXPECT_TRUE(check(law).has_errors());
  law.directions[2] = over_frequencies({10, 5}, {1, 2}, Interpolation::linear);
  EXPECT_EQ(check(law).list().front().subject, "z");
  law.directions[2] = over_frequencies({10, 50}, {1, 2}, Interpolation::linear);
  EXPECT_TRUE(check(law).list().empty());
  law.directions[2].loss(1, 0) = -0.1;
  EXPECT_THAT(check(law).list().front().finding, testing::HasSubstr("row 2"));
  law.directions[2].loss.resize(3, 1);
  EXPECT_TRUE(check(law).has_errors());
  law.directions[2] = over_frequencies({10, 50}, {1, 2}, Interpolation::linear);
  law.directions[0] = over_frequencies({60, 70}, {1, 2}, Interpolation::linear);
  EXPECT_THAT(check(law).list().front().finding, testing::HasSubstr("have no common frequency"));
}

}  // namespace table_law_test
