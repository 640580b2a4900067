// SPDX-License-Identifier: BSD-3-Clause
#include "fmu/simulation.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace fmu_simulation_test {

using trivet::fmu::LinearModel;
using trivet::fmu::Matrix;
using trivet::fmu::Simulation;
using trivet::fmu::ValueReference;

/// x' = a x + u.
LinearModel first_order(double a) {
  LinearModel model;
  model.a = Matrix(1, 1);
  model.a.values = {a};
  model.b = Matrix(1, 1);
  model.b.values = {1};
  model.c = Matrix(0, 1);
  model.d = Matrix(0, 1);
  model.initial = {1};
  model.nominals = {1};
  return model;
}

TEST(FmuSimulation, KeepsTheTimeOfTheImporterIfStepsDifferByRounding) {
  // With the input 1, the state of an integrator is the time that has passed.
  Simulation simulation(first_order(0));
  const ValueReference input = 1;
  const double one = 1;
  simulation.set({&input, 1}, {&one, 1}, false);
  simulation.set_experiment(1000, std::numeric_limits<double>::infinity());
  constexpr int steps = 5000;
  constexpr double step = 1e-3, more = 5e-13;  // less than the rounding of a time near 1000
  double time = 1000;
  simulation.advance(time, step + more);
  time += step + more;
  for (int i = 0; i < steps; ++i) {
    simulation.advance(time, step);
    time += step;
  }
  EXPECT_LE(simulation.exponentials(), 3u);
  // Every step with the size of the first one would be wrong by 2.5e-9.
  EXPECT_NEAR(simulation.state().states[0], 1 + steps * step + step + more, 3e-12);
}

TEST(FmuSimulation, BeginsAStepAtThePresentTimeToAThousandth) {
  Simulation simulation(first_order(0));
  simulation.set_experiment(0, 2.5);
  simulation.advance(0, 1);
  EXPECT_THROW(simulation.advance(1.0011, 1), std::runtime_error);
  EXPECT_THROW(simulation.advance(0.9989, 1), std::runtime_error);
  simulation.advance(1.0009, 1);
  EXPECT_DOUBLE_EQ(simulation.state().time, 2.0009);
  EXPECT_THROW(simulation.advance(2.0009, 0.5), std::runtime_error);  // beyond the stop time by 0.0009 of 0.5
  simulation.advance(2.0009, 0.4995);
}

TEST(FmuSimulation, RejectsAStepThatOverflowsAndStaysAsItWas) {
  Simulation simulation(first_order(500));
  simulation.advance(0, 1);
  const double before = simulation.state().states[0];
  EXPECT_TRUE(std::isfinite(before));
  EXPECT_THROW(simulation.advance(1, 1), std::runtime_error);  // e^1000
  EXPECT_THROW(simulation.advance(1, 100), std::runtime_error);
  EXPECT_EQ(simulation.state().states[0], before);
  EXPECT_EQ(simulation.state().time, 1);
}

}  // namespace fmu_simulation_test
