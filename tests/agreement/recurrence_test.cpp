// SPDX-License-Identifier: BSD-3-Clause
// Steps of pairs and results over time in lanes, compared with plain matrix products, on every instruction set.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "trivet/numerics/lanes/instruction_set.h"
#include "trivet/numerics/recurrence/pair_steps.h"
#include "trivet/numerics/recurrence/rows_over_time.h"

namespace recurrence_test {

using namespace trivet;
using Eigen::Index;

/// Sums of some ten products of numbers near one, and 37 steps of them.
constexpr double round_off = 1000 * std::numeric_limits<double>::epsilon();

Eigen::MatrixXd sample(Index rows, Index columns, double phase) {
  return Eigen::MatrixXd::NullaryExpr(
      rows, columns, [&](Index i, Index j) { return std::sin(phase + static_cast<double>(3 * i + 7 * j + i * j)); });
}

class Recurrence : public testing::TestWithParam<std::string> {
 protected:
  Recurrence() { numerics::use_instruction_set(GetParam()); }
  ~Recurrence() override { numerics::use_instruction_set(""); }
};

TEST_P(Recurrence, StepsOfPairsAgreeWithOneMatrix) {
  constexpr Index pairs = 16, steps = 37, rows_of_w = 5;
  const Eigen::ArrayXXd matrix = 0.4 * sample(pairs, 4, 1).array();
  const Eigen::MatrixXd gamma = sample(2 * pairs, 2, 2), w = sample(rows_of_w, steps, 3);
  const numerics::StepInput inputs[] = {{gamma.col(0).data(), 3}, {gamma.col(1).data(), 1}};
  Eigen::MatrixXd states = Eigen::MatrixXd::Constant(2 * pairs + 3, steps + 1, 77);  // three rows belong to others
  states.col(0) = sample(2 * pairs + 3, 1, 4);
  numerics::take_pair_steps({pairs, matrix.data(), inputs, inputs + 2}, w, states);
  Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(2 * pairs, 2 * pairs);
  whole.topLeftCorner(pairs, pairs) = matrix.col(0).matrix().asDiagonal();
  whole.topRightCorner(pairs, pairs) = matrix.col(1).matrix().asDiagonal();
  whole.bottomLeftCorner(pairs, pairs) = matrix.col(2).matrix().asDiagonal();
  whole.bottomRightCorner(pairs, pairs) = matrix.col(3).matrix().asDiagonal();
  Eigen::VectorXd x = states.col(0).head(2 * pairs);
  for (Index i = 0; i < steps; ++i) {
    x = (whole * x + gamma.col(0) * w(3, i) + gamma.col(1) * w(1, i)).eval();
    EXPECT_LE((states.col(i + 1).head(2 * pairs) - x).cwiseAbs().maxCoeff(), round_off) << "step " << i;
    EXPECT_EQ(states(2 * pairs, i + 1), 77);
  }
}

TEST_P(Recurrence, RowsOverTimeAgreeWithProductsAndTheirExtremes) {
  constexpr Index rows = 11, states = 9, times = 45, block = 21;
  Eigen::MatrixXd C = sample(rows, states, 5);
  C.col(4).setZero();
  const Eigen::MatrixXd X = sample(states, times, 6), Y = C * X;
  numerics::RowsOverTime over_time(C, block);
  for (Index first = 0; first < times; first += block) {
    const Index count = std::min(block, times - first);
    over_time.evaluate(X.middleCols(first, count));
    for (Index k = 0; k < rows; ++k) {
      const Eigen::VectorXd expected = Y.row(k).segment(first, count).transpose();
      Eigen::VectorXd values(count);
      over_time.copy_row(k, values);
      EXPECT_LE((values - expected).cwiseAbs().maxCoeff(), round_off);
      const numerics::RowBlock found = over_time.block(k);
      EXPECT_EQ(found.largest, values.maxCoeff());
      EXPECT_EQ(found.smallest, values.minCoeff());
      EXPECT_NEAR(found.squares, expected.squaredNorm(), round_off * expected.squaredNorm());
      double bend = 0;
      for (Index i = first; i < first + count; ++i) {
        const double before = Y(k, std::max<Index>(i - 1, 0)), two_before = Y(k, std::max<Index>(i - 2, 0));
        bend = std::max(bend, std::abs(Y(k, i) - 2 * before + two_before));
      }
      EXPECT_NEAR(found.bend, bend, round_off * 4);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, Recurrence, testing::ValuesIn(numerics::instruction_sets()),
                         [](const auto& info) { return info.param; });

}  // namespace recurrence_test
