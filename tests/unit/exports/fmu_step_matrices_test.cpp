// SPDX-License-Identifier: BSD-3-Clause
#include "fmu/step_matrices.h"

#include <gmock/gmock.h>

#include <cmath>

namespace fmu_step_matrices_test {

using trivet::fmu::LinearModel;
using trivet::fmu::Matrix;
using trivet::fmu::step_matrix;
using trivet::fmu::StepMatrices;
using trivet::fmu::StepMatrix;

/// x'' + ω² x = ω² u: an oscillator driven at its foot.
LinearModel oscillator(double omega) {
  LinearModel model;
  model.a = Matrix(2, 2);
  model.a.values = {0, 1, -omega * omega, 0};
  model.b = Matrix(2, 1);
  model.b.values = {0, omega * omega};
  return model;
}

TEST(FmuStepMatrix, OfAnOscillatorHasItsClosedForm) {
  for (const double omega : {1.0, 300.0, 1e6})
    for (const double angle : {1e-3, 0.7, 40.0}) {
      const double h = angle / omega;
      const StepMatrix step = step_matrix(oscillator(omega), h);
      constexpr double tolerance = 1e-13;  // round-off: 3 halvings of a matrix of norm 1, times its size
      const double wide = tolerance * std::max(1.0, angle);
      EXPECT_NEAR(step.from_states(0, 0), std::cos(angle), wide);
      EXPECT_NEAR(step.from_states(0, 1) * omega, std::sin(angle), wide);
      EXPECT_NEAR(step.from_states(1, 0) / omega, -std::sin(angle), wide);
      EXPECT_NEAR(step.from_inputs(0, 0), 1 - std::cos(angle), wide);
      EXPECT_NEAR(step.from_inputs(1, 0) / omega, std::sin(angle), wide);
      EXPECT_NEAR(step.from_slopes(0, 0) * omega, angle - std::sin(angle), wide);
      EXPECT_NEAR(step.from_slopes(1, 0), 1 - std::cos(angle), wide);
    }
}

TEST(FmuStepMatrix, OfAFreeMassIsAPolynomial) {
  LinearModel model = oscillator(1);
  const double h = 0.01, mass = 4e6;
  model.a.values = {0, 1, 0, 0};
  model.b.values = {0, 1 / mass};
  const StepMatrix step = step_matrix(model, h);
  EXPECT_THAT(step.from_states.values, testing::ElementsAre(1, h, 0, 1));
  EXPECT_DOUBLE_EQ(step.from_inputs(0, 0), h * h / 2 / mass);
  EXPECT_DOUBLE_EQ(step.from_slopes(0, 0), h * h * h / 6 / mass);
  EXPECT_DOUBLE_EQ(step.from_slopes(1, 0), h * h / 2 / mass);
}

TEST(FmuStepMatrices, AreComputedOncePerSize) {
  const LinearModel model = oscillator(10);
  StepMatrices matrices;
  for (int i = 0; i < 100; ++i)
    for (const double h : {1e-3, 2e-3, 5e-4}) EXPECT_EQ(matrices.nearest(model, h, 0).step, h);
  EXPECT_EQ(matrices.computed(), 3u);
  EXPECT_EQ(matrices.nearest(model, 1e-3 + 1e-17, 1e-16).step, 1e-3);
  EXPECT_EQ(matrices.computed(), 3u);
  for (int i = 1; i <= 50; ++i) static_cast<void>(matrices.nearest(model, i, 0));
  EXPECT_EQ(matrices.computed(), 53u);
  EXPECT_EQ(matrices.nearest(model, 1e-3, 0).step, 1e-3);  // computed again
  EXPECT_EQ(matrices.computed(), 54u);
}

}  // namespace fmu_step_matrices_test
