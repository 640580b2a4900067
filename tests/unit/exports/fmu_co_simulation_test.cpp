// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <array>
#include <cmath>

#include "fmu/linear_model.h"
#include "fmu/step_matrices.h"
#include "fmu_instances.h"

namespace fmu_co_simulation_test {

using namespace trivet::test;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pointwise;
using trivet::fmu::dot;
using trivet::fmu::StepMatrix;

constexpr double round_off = 1e-14;

const StepMatrix& exact_step() {
  static const StepMatrix step =
      trivet::fmu::step_matrix(trivet::fmu::linear_model(trivet::exports::system_text(two_masses(), "-")), 1e-3);
  return step;
}

/// F x + G u + H u'.
std::vector<double> after_step(const std::vector<double>& x, const std::vector<double>& u,
                               const std::vector<double>& slopes) {
  const StepMatrix& step = exact_step();
  std::vector<double> next;
  for (std::size_t i = 0; i < x.size(); ++i)
    next.push_back(dot(step.from_states.row(i), x) + dot(step.from_inputs.row(i), u) +
                   dot(step.from_slopes.row(i), slopes));
  return next;
}

const std::vector<double> start = {1e-3, 0, 0.05, 1.0 / 3}, held = {0, 0, 0}, forces = {100, 1e-3, 0.2},
                          slopes = {3e4, 0.2, -40};
const std::array<int, 3> first_order = {1, 1, 1};

TEST(FmuCoSimulation, HoldsInputsDuringAStep) {
  FmuResources resources;
  const fmi2Component c = resources.started_2(fmi2CoSimulation);
  EXPECT_EQ(fmi2SetReal(c, fmu_inputs.data(), 3, forces.data()), fmi2OK);
  EXPECT_EQ(fmi2DoStep(c, 0, 1e-3, fmi2True), fmi2OK);
  EXPECT_THAT(values_2(c, fmu_states), Pointwise(DoubleNear(round_off), after_step(start, forces, held)));
  EXPECT_EQ(values_2(c, fmu_inputs), forces);
  EXPECT_EQ(values_2(c, {0}), std::vector<double>{1e-3});
  fmi2FreeInstance(c);
}

TEST(FmuCoSimulation, FollowsSlopesOfInputsDuringOneStepOnly) {
  FmuResources resources;
  const fmi2Component c = resources.started_2(fmi2CoSimulation);
  fmi2SetReal(c, fmu_inputs.data(), 3, forces.data());
  EXPECT_EQ(fmi2SetRealInputDerivatives(c, fmu_inputs.data(), 3, first_order.data(), slopes.data()), fmi2OK);
  fmi2DoStep(c, 0, 1e-3, fmi2True);
  const std::vector<double> middle = after_step(start, forces, slopes);
  EXPECT_THAT(values_2(c, fmu_states), Pointwise(DoubleNear(round_off), middle));
  const std::vector<double> ends = {130, 1.2e-3, 0.16};
  EXPECT_THAT(values_2(c, fmu_inputs), Pointwise(DoubleNear(round_off), ends));
  fmi2DoStep(c, 1e-3, 1e-3, fmi2True);
  EXPECT_THAT(values_2(c, fmu_states), Pointwise(DoubleNear(round_off), after_step(middle, ends, held)));
  fmi2FreeInstance(c);
}

TEST(FmuCoSimulation, GivesDerivativesOfOutputs) {
  FmuResources resources;
  const fmi2Component c = resources.started_2(fmi2CoSimulation);
  fmi2SetReal(c, fmu_inputs.data(), 3, forces.data());
  fmi2SetRealInputDerivatives(c, fmu_inputs.data(), 3, first_order.data(), slopes.data());
  fmi2DoStep(c, 0, 1e-3, fmi2True);
  const std::vector<double> rates = values_2(c, fmu_derivatives);
  const auto system = two_masses();
  const Eigen::VectorXd expected = system.C * Eigen::Map<const Eigen::VectorXd>(rates.data(), 4) +
      system.D * Eigen::Map<const Eigen::VectorXd>(slopes.data(), 3);
  std::array<double, 3> found;
  const std::array<fmi2ValueReference, 3> references = {4, 5, 4};
  const std::array<int, 3> orders = {1, 1, 2};
  EXPECT_EQ(fmi2GetRealOutputDerivatives(c, references.data(), 3, orders.data(), found.data()), fmi2OK);
  constexpr double tolerance = 1e-12;  // of the largest
  EXPECT_NEAR(found[0], expected(0), tolerance * std::abs(expected(0)));
  EXPECT_NEAR(found[1], expected(1), tolerance * std::abs(expected(1)));
  EXPECT_EQ(found[2], 0);
  fmi2FreeInstance(c);
}

TEST(FmuCoSimulation, IgnoresHigherDerivativesOfInputsWithAWarning) {
  FmuResources resources;
  const fmi2Component c = resources.started_2(fmi2CoSimulation);
  const std::array<int, 3> second_order = {2, 2, 2}, no_order = {0, 1, 1};
  EXPECT_EQ(fmi2SetRealInputDerivatives(c, fmu_inputs.data(), 3, second_order.data(), slopes.data()), fmi2Warning);
  EXPECT_THAT(resources.messages, ElementsAre(HasSubstr("an order above 1 are ignored")));
  EXPECT_EQ(fmi2SetRealInputDerivatives(c, fmu_inputs.data(), 3, no_order.data(), slopes.data()), fmi2Error);
  EXPECT_EQ(fmi2SetRealInputDerivatives(c, fmu_states.data(), 3, first_order.data(), slopes.data()), fmi2Error);
  fmi2DoStep(c, 0, 1e-3, fmi2True);
  EXPECT_THAT(values_2(c, fmu_states), Pointwise(DoubleNear(round_off), after_step(start, held, held)));
  fmi2FreeInstance(c);
}

TEST(FmuCoSimulation, ComputesFewExponentialsIfStepsDifferByRounding) {
  FmuResources resources;
  const fmi2Component c = resources.started_2(fmi2CoSimulation, true);
  const std::size_t before = resources.messages.size();
  const auto time = [](int i) { return 100 * (i * 1e-5); };
  for (int i = 0; i < 5000; ++i) ASSERT_EQ(fmi2DoStep(c, time(i), time(i + 1) - time(i), fmi2True), fmi2OK);
  EXPECT_LE(resources.messages.size() - before, 4u);
  EXPECT_THAT(resources.messages[before],
              HasSubstr("logEvents: a matrix exponential was computed for steps of 0.001 s"));
  fmi2FreeInstance(c);
}

TEST(FmuCoSimulation, RejectsStepsThatAreNotInOrder) {
  FmuResources resources;
  const fmi2Component c = resources.new_2(fmi2CoSimulation);
  EXPECT_EQ(fmi2SetupExperiment(c, fmi2False, 0, 5, fmi2True, 4), fmi2Error);
  EXPECT_EQ(fmi2SetupExperiment(c, fmi2False, 0, NAN, fmi2False, 0), fmi2Error);
  EXPECT_EQ(fmi2SetupExperiment(c, fmi2False, 0, 5, fmi2True, 6), fmi2OK);
  fmi2EnterInitializationMode(c);
  fmi2ExitInitializationMode(c);
  EXPECT_EQ(fmi2DoStep(c, 0, 0.5, fmi2True), fmi2Error);
  EXPECT_EQ(fmi2DoStep(c, 5, 0, fmi2True), fmi2Error);
  EXPECT_EQ(fmi2DoStep(c, 5, -1, fmi2True), fmi2Error);
  EXPECT_EQ(fmi2DoStep(c, 5, NAN, fmi2True), fmi2Error);
  EXPECT_EQ(fmi2DoStep(c, 5, INFINITY, fmi2True), fmi2Error);
  EXPECT_EQ(fmi2DoStep(c, 5, 1.1, fmi2True), fmi2Error);
  EXPECT_THAT(resources.messages.back(), HasSubstr("beyond the stop time of 6 s"));
  EXPECT_EQ(values_2(c, fmu_states), start);
  EXPECT_EQ(fmi2DoStep(c, 5, 1, fmi2True), fmi2OK);
  double time = 0;
  fmi2Boolean ended = fmi2True;
  EXPECT_EQ(fmi2GetRealStatus(c, fmi2LastSuccessfulTime, &time), fmi2OK);
  EXPECT_EQ(time, 6);
  EXPECT_EQ(fmi2GetBooleanStatus(c, fmi2Terminated, &ended), fmi2OK);
  EXPECT_EQ(ended, fmi2False);
  EXPECT_EQ(fmi2GetStatus(c, fmi2DoStepStatus, nullptr), fmi2Discard);
  EXPECT_EQ(fmi2CancelStep(c), fmi2Error);
  fmi2FreeInstance(c);
}

TEST(FmuCoSimulation, OfVersion3IsTheSame) {
  FmuResources resources;
  const fmi3Instance instance = resources.new_3_co_simulation();
  EXPECT_EQ(fmi3EnterInitializationMode(instance, false, 0, 0, false, 0), fmi3OK);
  EXPECT_EQ(fmi3ExitInitializationMode(instance), fmi3OK);
  EXPECT_EQ(fmi3SetFloat64(instance, fmu_inputs.data(), 3, forces.data(), 3), fmi3OK);
  bool event = true, end = true, early = true;
  double reached = 0;
  EXPECT_EQ(fmi3DoStep(instance, 0, 1e-3, true, &event, &end, &early, &reached), fmi3OK);
  EXPECT_FALSE(event || end || early);
  EXPECT_EQ(reached, 1e-3);
  EXPECT_THAT(values_3(instance, fmu_states), Pointwise(DoubleNear(round_off), after_step(start, forces, held)));
  EXPECT_EQ(fmi3DoStep(instance, 1e-3, 1e-3, true, nullptr, &end, &early, &reached), fmi3Error);
  EXPECT_EQ(fmi3EnterEventMode(instance), fmi3Error);
  EXPECT_EQ(fmi3EnterStepMode(instance), fmi3Error);
  EXPECT_EQ(fmi3Terminate(instance), fmi3OK);
  fmi3FreeInstance(instance);
}

TEST(FmuCoSimulation, HasInstancesThatShareNothing) {
  FmuResources resources;
  const fmi2Component one = resources.started_2(fmi2CoSimulation), two = resources.started_2(fmi2CoSimulation);
  fmi2SetReal(one, fmu_inputs.data(), 3, forces.data());
  fmi2DoStep(one, 0, 1e-3, fmi2True);
  EXPECT_EQ(values_2(two, fmu_states), start);
  fmi2FreeInstance(one);
  fmi2DoStep(two, 0, 1e-3, fmi2True);
  EXPECT_THAT(values_2(two, fmu_states), Pointwise(DoubleNear(round_off), after_step(start, held, held)));
  fmi2FreeInstance(two);
}

}  // namespace fmu_co_simulation_test
