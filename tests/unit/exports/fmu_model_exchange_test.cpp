// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <vector>

#include "fmu_instances.h"

namespace fmu_model_exchange_test {

using namespace trivet::test;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::Pointwise;

/// A x + B u, and C x + D u.
struct Evaluated {
  Evaluated(const std::vector<double>& states, const std::vector<double>& inputs) {
    const auto system = two_masses();
    const Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(states.data(), 4);
    const Eigen::VectorXd u = Eigen::Map<const Eigen::VectorXd>(inputs.data(), 3);
    const Eigen::VectorXd rates = system.A * x + system.B * u, results = system.C * x + system.D * u;
    derivatives.assign(rates.begin(), rates.end());
    outputs.assign(results.begin(), results.end());
  }
  std::vector<double> derivatives, outputs;
};

const std::vector<double> states = {1e-3, -2e-3, 0.3, 0.4}, inputs = {10, 1e-4, 0.01};
constexpr double round_off = 1e-11;  // of forces and accelerations near 1000

TEST(FmuModelExchange, EvaluatesTheSystem) {
  FmuResources resources;
  const fmi2Component c = resources.started_2(fmi2ModelExchange);
  fmi2EventInfo info = {1, 1, 1, 1, 1, 1};
  EXPECT_EQ(fmi2NewDiscreteStates(c, &info), fmi2OK);
  EXPECT_FALSE(info.newDiscreteStatesNeeded || info.terminateSimulation || info.nextEventTimeDefined ||
               info.nominalsOfContinuousStatesChanged || info.valuesOfContinuousStatesChanged);
  EXPECT_EQ(fmi2EnterContinuousTimeMode(c), fmi2OK);
  EXPECT_EQ(fmi2SetTime(c, 0.25), fmi2OK);
  EXPECT_EQ(fmi2SetContinuousStates(c, states.data(), 4), fmi2OK);
  EXPECT_EQ(fmi2SetReal(c, fmu_inputs.data(), 3, inputs.data()), fmi2OK);
  const Evaluated expected(states, inputs);
  std::vector<double> found(4);
  EXPECT_EQ(fmi2GetDerivatives(c, found.data(), 4), fmi2OK);
  EXPECT_THAT(found, Pointwise(DoubleNear(round_off), expected.derivatives));
  EXPECT_EQ(values_2(c, fmu_derivatives), found);
  EXPECT_THAT(values_2(c, fmu_outputs), Pointwise(DoubleNear(round_off), expected.outputs));
  EXPECT_EQ(fmi2GetContinuousStates(c, found.data(), 4), fmi2OK);
  EXPECT_EQ(found, states);
  EXPECT_EQ(fmi2GetNominalsOfContinuousStates(c, found.data(), 4), fmi2OK);
  EXPECT_THAT(found, ElementsAre(1e-3, 1e-3, 0.1, 0.1));
  EXPECT_EQ(fmi2GetEventIndicators(c, nullptr, 0), fmi2OK);
  EXPECT_EQ(values_2(c, {0}), std::vector<double>{0.25});
  fmi2Boolean event = fmi2True, end = fmi2True;
  EXPECT_EQ(fmi2CompletedIntegratorStep(c, fmi2True, &event, &end), fmi2OK);
  EXPECT_FALSE(event || end);
  EXPECT_EQ(fmi2EnterEventMode(c), fmi2OK);
  EXPECT_EQ(fmi2Terminate(c), fmi2OK);
  fmi2FreeInstance(c);
}

TEST(FmuModelExchange, OfVersion3IsTheSame) {
  FmuResources resources;
  const fmi3Instance instance = resources.new_3_model_exchange();
  EXPECT_EQ(fmi3EnterInitializationMode(instance, false, 0, 0, false, 0), fmi3OK);
  EXPECT_EQ(fmi3ExitInitializationMode(instance), fmi3OK);
  std::array<bool, 5> results = {true, true, true, true, true};
  double next_event = 0;
  EXPECT_EQ(
      fmi3UpdateDiscreteStates(instance, &results[0], &results[1], &results[2], &results[3], &results[4], &next_event),
      fmi3OK);
  EXPECT_THAT(results, ElementsAre(false, false, false, false, false));
  EXPECT_EQ(fmi3EvaluateDiscreteStates(instance), fmi3OK);
  EXPECT_EQ(fmi3EnterContinuousTimeMode(instance), fmi3OK);
  EXPECT_EQ(fmi3SetTime(instance, 0.25), fmi3OK);
  EXPECT_EQ(fmi3SetContinuousStates(instance, states.data(), 4), fmi3OK);
  EXPECT_EQ(fmi3SetFloat64(instance, fmu_inputs.data(), 3, inputs.data(), 3), fmi3OK);
  std::vector<double> found(4);
  EXPECT_EQ(fmi3GetContinuousStateDerivatives(instance, found.data(), 4), fmi3OK);
  const Evaluated expected(states, inputs);
  EXPECT_THAT(found, Pointwise(DoubleNear(round_off), expected.derivatives));
  EXPECT_THAT(values_3(instance, fmu_outputs), Pointwise(DoubleNear(round_off), expected.outputs));
  std::size_t count = 7;
  EXPECT_EQ(fmi3GetNumberOfEventIndicators(instance, &count), fmi3OK);
  EXPECT_EQ(count, 0u);
  EXPECT_EQ(fmi3GetNumberOfContinuousStates(instance, &count), fmi3OK);
  EXPECT_EQ(count, 4u);
  fmi3FreeInstance(instance);
}

TEST(FmuModelExchange, LetsStatesBeSetBeforeTheStart) {
  FmuResources resources;
  const fmi2Component c = resources.new_2(fmi2ModelExchange);
  const double value = 0.7;
  EXPECT_EQ(fmi2SetReal(c, &fmu_states[2], 1, &value), fmi2OK);
  EXPECT_EQ(fmi2EnterInitializationMode(c), fmi2OK);
  EXPECT_EQ(fmi2SetReal(c, &fmu_states[3], 1, &value), fmi2OK);
  EXPECT_EQ(fmi2ExitInitializationMode(c), fmi2OK);
  EXPECT_EQ(fmi2SetReal(c, &fmu_states[3], 1, &value), fmi2Error);
  EXPECT_THAT(values_2(c, fmu_states), ElementsAre(1e-3, 0, 0.7, 0.7));
  EXPECT_EQ(fmi2Reset(c), fmi2OK);
  EXPECT_THAT(values_2(c, fmu_states), ElementsAre(1e-3, 0, 0.05, 1.0 / 3));
  fmi2FreeInstance(c);
}

TEST(FmuModelExchange, HasPartialDerivatives) {
  FmuResources resources;
  const fmi3Instance instance = resources.new_3_model_exchange();
  fmi3EnterInitializationMode(instance, false, 0, 0, false, 0);
  const auto system = two_masses();
  const std::array<fmi3ValueReference, 2> unknowns = {4, 13}, knowns = {1, 9};
  const std::array<double, 2> seed = {2, -3};
  std::array<double, 2> found;
  EXPECT_EQ(
      fmi3GetDirectionalDerivative(instance, unknowns.data(), 2, knowns.data(), 2, seed.data(), 2, found.data(), 2),
      fmi3OK);
  EXPECT_DOUBLE_EQ(found[0], 2 * system.D(0, 0) - 3 * system.C(0, 3));
  EXPECT_DOUBLE_EQ(found[1], 2 * system.B(3, 0) - 3 * system.A(3, 3));
  EXPECT_EQ(fmi3GetAdjointDerivative(instance, unknowns.data(), 2, knowns.data(), 2, seed.data(), 2, found.data(), 2),
            fmi3OK);
  EXPECT_DOUBLE_EQ(found[0], 2 * system.D(0, 0) - 3 * system.B(3, 0));
  EXPECT_DOUBLE_EQ(found[1], 2 * system.C(0, 3) - 3 * system.A(3, 3));
  const std::array<fmi3ValueReference, 2> wrong = {1, 6};
  EXPECT_EQ(fmi3GetDirectionalDerivative(instance, wrong.data(), 2, knowns.data(), 2, seed.data(), 2, found.data(), 2),
            fmi3Error);
  EXPECT_EQ(
      fmi3GetDirectionalDerivative(instance, unknowns.data(), 2, unknowns.data(), 2, seed.data(), 2, found.data(), 2),
      fmi3Error);
  EXPECT_EQ(fmi3GetAdjointDerivative(instance, unknowns.data(), 2, knowns.data(), 2, seed.data(), 1, found.data(), 2),
            fmi3Error);
  fmi3FreeInstance(instance);
}

TEST(FmuModelExchange, NamesItsDependencies) {
  FmuResources resources;
  const fmi3Instance instance = resources.new_3_model_exchange();
  std::size_t count = 0;
  EXPECT_EQ(fmi3GetNumberOfVariableDependencies(instance, 12, &count), fmi3OK);
  ASSERT_EQ(count, 6u);
  std::vector<std::size_t> one(count, 9), other(count, 9);
  std::vector<fmi3ValueReference> causes(count);
  std::vector<fmi3DependencyKind> kinds(count);
  EXPECT_EQ(fmi3GetVariableDependencies(instance, 12, one.data(), causes.data(), other.data(), kinds.data(), count),
            fmi3OK);
  EXPECT_THAT(causes, ElementsAre(2, 3, 6, 7, 8, 9));
  EXPECT_THAT(kinds, testing::Each(fmi3Constant));
  EXPECT_THAT(one, testing::Each(0u));
  EXPECT_EQ(fmi3GetVariableDependencies(instance, 12, one.data(), causes.data(), other.data(), kinds.data(), 5),
            fmi3Error);
  EXPECT_EQ(fmi3GetNumberOfVariableDependencies(instance, 6, &count), fmi3OK);
  EXPECT_EQ(count, 0u);
  fmi3FreeInstance(instance);
}

}  // namespace fmu_model_exchange_test
