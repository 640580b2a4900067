// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "fmu_instances.h"

namespace fmu_wrong_calls_test {

using namespace trivet::test;
using testing::Contains;
using testing::HasSubstr;

using Call2 = std::function<fmi2Status(fmi2Component)>;
using Call3 = std::function<fmi3Status(fmi3Instance)>;

/// Calls with null pointers where results or arrays are expected.
const std::vector<Call2> null_calls_2 = {
    [](fmi2Component c) { return fmi2GetReal(c, nullptr, 1, nullptr); },
    [](fmi2Component c) { return fmi2GetReal(c, fmu_inputs.data(), 1, nullptr); },
    [](fmi2Component c) { return fmi2SetReal(c, fmu_inputs.data(), 1, nullptr); },
    [](fmi2Component c) { return fmi2GetInteger(c, nullptr, 1, nullptr); },
    [](fmi2Component c) { return fmi2SetString(c, nullptr, 1, nullptr); },
    [](fmi2Component c) { return fmi2SetDebugLogging(c, fmi2True, 1, nullptr); },
    [](fmi2Component c) { return fmi2GetDirectionalDerivative(c, nullptr, 1, nullptr, 1, nullptr, nullptr); },
    [](fmi2Component c) { return fmi2GetFMUstate(c, nullptr); },
    [](fmi2Component c) { return fmi2SetFMUstate(c, nullptr); },
    [](fmi2Component c) { return fmi2FreeFMUstate(c, nullptr); },
    [](fmi2Component c) { return fmi2SerializedFMUstateSize(c, nullptr, nullptr); },
    [](fmi2Component c) { return fmi2SerializeFMUstate(c, nullptr, nullptr, 1); },
    [](fmi2Component c) { return fmi2DeSerializeFMUstate(c, nullptr, 1, nullptr); },
    [](fmi2Component c) { return fmi2NewDiscreteStates(c, nullptr); },
    [](fmi2Component c) { return fmi2CompletedIntegratorStep(c, fmi2True, nullptr, nullptr); },
    [](fmi2Component c) { return fmi2SetContinuousStates(c, nullptr, 4); },
    [](fmi2Component c) { return fmi2GetDerivatives(c, nullptr, 4); },
    [](fmi2Component c) { return fmi2GetContinuousStates(c, nullptr, 4); },
    [](fmi2Component c) { return fmi2GetNominalsOfContinuousStates(c, nullptr, 4); },
    [](fmi2Component c) { return fmi2GetEventIndicators(c, nullptr, 1); },
    [](fmi2Component c) { return fmi2SetRealInputDerivatives(c, nullptr, 1, nullptr, nullptr); },
    [](fmi2Component c) { return fmi2GetRealOutputDerivatives(c, nullptr, 1, nullptr, nullptr); },
    [](fmi2Component c) { return fmi2GetRealStatus(c, fmi2LastSuccessfulTime, nullptr); },
    [](fmi2Component c) { return fmi2GetBooleanStatus(c, fmi2Terminated, nullptr); }};

const std::vector<Call3> null_calls_3 = {
    [](fmi3Instance i) { return fmi3GetFloat64(i, nullptr, 1, nullptr, 1); },
    [](fmi3Instance i) { return fmi3GetFloat64(i, fmu_inputs.data(), 1, nullptr, 1); },
    [](fmi3Instance i) { return fmi3SetFloat64(i, fmu_inputs.data(), 1, nullptr, 1); },
    [](fmi3Instance i) { return fmi3GetInt32(i, nullptr, 1, nullptr, 1); },
    [](fmi3Instance i) { return fmi3SetBinary(i, nullptr, 1, nullptr, nullptr, 1); },
    [](fmi3Instance i) { return fmi3GetClock(i, nullptr, 1, nullptr); },
    [](fmi3Instance i) { return fmi3GetIntervalDecimal(i, nullptr, 1, nullptr, nullptr); },
    [](fmi3Instance i) { return fmi3SetShiftFraction(i, nullptr, 1, nullptr, nullptr); },
    [](fmi3Instance i) { return fmi3GetNumberOfVariableDependencies(i, 4, nullptr); },
    [](fmi3Instance i) { return fmi3GetVariableDependencies(i, 5, nullptr, nullptr, nullptr, nullptr, 4); },
    [](fmi3Instance i) { return fmi3GetDirectionalDerivative(i, nullptr, 1, nullptr, 1, nullptr, 1, nullptr, 1); },
    [](fmi3Instance i) { return fmi3GetAdjointDerivative(i, nullptr, 1, nullptr, 1, nullptr, 1, nullptr, 1); },
    [](fmi3Instance i) { return fmi3GetFMUState(i, nullptr); },
    [](fmi3Instance i) { return fmi3UpdateDiscreteStates(i, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr); },
    [](fmi3Instance i) { return fmi3CompletedIntegratorStep(i, true, nullptr, nullptr); },
    [](fmi3Instance i) { return fmi3GetContinuousStateDerivatives(i, nullptr, 4); },
    [](fmi3Instance i) { return fmi3GetNumberOfContinuousStates(i, nullptr); },
    [](fmi3Instance i) { return fmi3GetNumberOfEventIndicators(i, nullptr); },
    [](fmi3Instance i) { return fmi3GetOutputDerivatives(i, nullptr, 1, nullptr, nullptr, 1); },
    [](fmi3Instance i) { return fmi3DoStep(i, 0, 1e-3, true, nullptr, nullptr, nullptr, nullptr); },
    [](fmi3Instance i) { return fmi3EnterConfigurationMode(i); },
    [](fmi3Instance i) { return fmi3ActivateModelPartition(i, 0, 0); }};

TEST(FmuWrongCalls, WithNullPointersFailWithAMessage) {
  FmuResources resources;
  const std::vector<fmi2Component> units = {resources.new_2(fmi2CoSimulation), resources.started_2(fmi2CoSimulation),
                                            resources.started_2(fmi2ModelExchange)};
  for (std::size_t i = 0; i < null_calls_2.size(); ++i) {
    EXPECT_EQ(null_calls_2[i](nullptr), fmi2Error) << i;
    for (const fmi2Component c : units) {
      resources.messages.clear();
      EXPECT_EQ(null_calls_2[i](c), fmi2Error) << i;
      EXPECT_THAT(resources.messages, Contains(HasSubstr("logStatusError: fmi2"))) << i;
    }
  }
  for (const fmi2Component c : units) fmi2FreeInstance(c);
  fmi2FreeInstance(nullptr);
}

TEST(FmuWrongCalls, OfVersion3WithNullPointersFailWithAMessage) {
  FmuResources resources;
  const std::vector<fmi3Instance> units = {resources.new_3_co_simulation(), resources.new_3_model_exchange()};
  for (const fmi3Instance instance : units) {
    fmi3EnterInitializationMode(instance, false, 0, 0, false, 0);
    fmi3ExitInitializationMode(instance);
  }
  for (std::size_t i = 0; i < null_calls_3.size(); ++i) {
    EXPECT_EQ(null_calls_3[i](nullptr), fmi3Error) << i;
    for (const fmi3Instance instance : units) {
      resources.messages.clear();
      EXPECT_EQ(null_calls_3[i](instance), fmi3Error) << i;
      EXPECT_THAT(resources.messages, Contains(HasSubstr("logStatusError: fmi3"))) << i;
    }
  }
  for (const fmi3Instance instance : units) fmi3FreeInstance(instance);
}

TEST(FmuWrongCalls, InAWrongPhaseFailAndChangeNothing) {
  FmuResources resources;
  const fmi2Component c = resources.new_2(fmi2CoSimulation);
  EXPECT_EQ(fmi2DoStep(c, 0, 1e-3, fmi2True), fmi2Error);
  EXPECT_EQ(fmi2ExitInitializationMode(c), fmi2Error);
  EXPECT_EQ(fmi2Terminate(c), fmi2Error);
  EXPECT_EQ(fmi2EnterInitializationMode(c), fmi2OK);
  EXPECT_EQ(fmi2EnterInitializationMode(c), fmi2Error);
  EXPECT_EQ(fmi2SetupExperiment(c, fmi2False, 0, 0, fmi2False, 0), fmi2Error);
  EXPECT_EQ(fmi2DoStep(c, 0, 1e-3, fmi2True), fmi2Error);
  EXPECT_EQ(fmi2ExitInitializationMode(c), fmi2OK);
  EXPECT_EQ(fmi2EnterContinuousTimeMode(c), fmi2Error);
  EXPECT_EQ(fmi2EnterEventMode(c), fmi2Error);
  EXPECT_EQ(fmi2SetTime(c, 1), fmi2Error);
  EXPECT_EQ(fmi2Terminate(c), fmi2OK);
  EXPECT_EQ(fmi2DoStep(c, 0, 1e-3, fmi2True), fmi2Error);
  EXPECT_EQ(fmi2SetReal(c, nullptr, 0, nullptr), fmi2Error);
  EXPECT_THAT(resources.messages, Contains(HasSubstr("fmi2DoStep: must not be called in the state after termination")));
  fmi2FreeInstance(c);
}

TEST(FmuWrongCalls, ToSetVariablesChangeNoneOfThem) {
  FmuResources resources;
  const fmi2Component c = resources.started_2(fmi2CoSimulation);
  for (const fmi2ValueReference wrong : {0u, 4u, 6u, 10u, 14u, 4000000000u}) {
    const std::array<fmi2ValueReference, 2> references = {1, wrong};
    const std::array<double, 2> values = {5, 6};
    EXPECT_EQ(fmi2SetReal(c, references.data(), 2, values.data()), fmi2Error) << wrong;
  }
  for (const double wrong : {double(NAN), double(INFINITY)})
    EXPECT_EQ(fmi2SetReal(c, fmu_inputs.data(), 1, &wrong), fmi2Error);
  EXPECT_EQ(values_2(c, {1}), std::vector<double>{0});
  EXPECT_EQ(fmi2SetInteger(c, nullptr, 0, nullptr), fmi2OK);
  fmi2FreeInstance(c);
}

TEST(FmuInstantiation, FailsWithTheReason) {
  FmuResources resources;
  const fmi2CallbackFunctions functions = {log_2, nullptr, nullptr, nullptr, &resources.messages};
  const std::string folder = "file://" + resources.path();
  const auto instantiate = [&](const char* guid, const char* location) {
    return fmi2Instantiate("unit", fmi2CoSimulation, guid, location, &functions, fmi2False, fmi2False);
  };
  EXPECT_EQ(instantiate("{other}", folder.c_str()), nullptr);
  EXPECT_THAT(resources.messages.back(), HasSubstr("the token \"{other}\" is not that of the resources"));
  EXPECT_EQ(instantiate(nullptr, folder.c_str()), nullptr);
  EXPECT_EQ(instantiate("{token}", nullptr), nullptr);
  EXPECT_EQ(instantiate("{token}", "file:///nowhere/100%25/#1"), nullptr);
  EXPECT_THAT(resources.messages.back(), HasSubstr("cannot read /nowhere/100%%/##1/system.txt: No such file"));
  const fmi2Component silent =
      fmi2Instantiate(nullptr, fmi2CoSimulation, "{token}", folder.c_str(), nullptr, fmi2False, fmi2True);
  ASSERT_NE(silent, nullptr);
  EXPECT_EQ(fmi2DoStep(silent, 0, 1, fmi2True), fmi2Error);
  fmi2FreeInstance(silent);
}

TEST(FmuInstantiation, OfVersion3HasNoEventsAndNoClocks) {
  FmuResources resources;
  const std::string folder = resources.path() + "/";
  EXPECT_EQ(fmi3InstantiateScheduledExecution("unit", "{token}", folder.c_str(), false, false, &resources.messages,
                                              log_3, nullptr, nullptr, nullptr),
            nullptr);
  EXPECT_THAT(resources.messages.back(), HasSubstr("no scheduled execution"));
  EXPECT_EQ(fmi3InstantiateCoSimulation("unit", "{token}", folder.c_str(), false, false, true, false, nullptr, 0,
                                        &resources.messages, log_3, nullptr),
            nullptr);
  EXPECT_THAT(resources.messages.back(), HasSubstr("no event mode"));
  const fmi3Instance silent =
      fmi3InstantiateModelExchange(nullptr, "{token}", folder.c_str(), false, true, nullptr, nullptr);
  ASSERT_NE(silent, nullptr);
  EXPECT_EQ(fmi3SetTime(silent, 0), fmi3Error);
  fmi3FreeInstance(silent);
}

TEST(FmuLog, ReportsEventsOnlyIfTheyAreSwitchedOn) {
  FmuResources resources;
  const fmi2Component c = resources.started_2(fmi2CoSimulation);
  const auto messages_of_step = [&](double from, double step) {
    resources.messages.clear();
    fmi2DoStep(c, from, step, fmi2True);
    return resources.messages.size();
  };
  const char* const events = "logEvents";
  const char* const errors = "logStatusError";
  const char* const unknown = "logAnything";
  EXPECT_EQ(messages_of_step(0, 1), 0u);
  EXPECT_EQ(fmi2SetDebugLogging(c, fmi2True, 1, &events), fmi2OK);
  EXPECT_EQ(messages_of_step(1, 2), 1u);
  EXPECT_EQ(fmi2SetDebugLogging(c, fmi2True, 1, &errors), fmi2OK);
  EXPECT_EQ(messages_of_step(3, 3), 0u);
  EXPECT_EQ(fmi2SetDebugLogging(c, fmi2True, 0, nullptr), fmi2OK);
  EXPECT_EQ(messages_of_step(6, 4), 1u);
  EXPECT_EQ(fmi2SetDebugLogging(c, fmi2True, 1, &unknown), fmi2Error);
  fmi2FreeInstance(c);
}

TEST(FmuInterface, NamesItsVersions) {
  EXPECT_STREQ(fmi2GetTypesPlatform(), "default");
  EXPECT_STREQ(fmi2GetVersion(), "2.0");
  EXPECT_STREQ(fmi3GetVersion(), "3.0");
}

}  // namespace fmu_wrong_calls_test
