// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "fmu_instances.h"

namespace fmu_saved_state_test {

using namespace trivet::test;

const std::vector<double> forces = {100, 1e-3, 0.2};

std::vector<double> after_steps(fmi2Component c, int first, int count) {
  for (int i = first; i < first + count; ++i) EXPECT_EQ(fmi2DoStep(c, i * 1e-3, 1e-3, fmi2False), fmi2OK);
  return values_2(c, {0, 1, 4, 5, 6, 7, 8, 9});
}

TEST(FmuSavedState, BringsBackEverything) {
  FmuResources resources;
  const fmi2Component c = resources.started_2(fmi2CoSimulation);
  fmi2SetReal(c, fmu_inputs.data(), 3, forces.data());
  after_steps(c, 0, 5);
  fmi2FMUstate state = nullptr;
  EXPECT_EQ(fmi2GetFMUstate(c, &state), fmi2OK);
  const std::vector<double> first = after_steps(c, 5, 10);
  fmi2Terminate(c);
  EXPECT_EQ(fmi2SetFMUstate(c, state), fmi2OK);
  EXPECT_EQ(after_steps(c, 5, 10), first);
  const fmi2FMUstate earlier = state;
  EXPECT_EQ(fmi2GetFMUstate(c, &state), fmi2OK);  // overwrites it
  EXPECT_EQ(state, earlier);
  EXPECT_EQ(fmi2FreeFMUstate(c, &state), fmi2OK);
  EXPECT_EQ(state, nullptr);
  EXPECT_EQ(fmi2FreeFMUstate(c, &state), fmi2OK);
  fmi2FreeInstance(c);
}

TEST(FmuSavedState, MovesToAnotherInstanceAsBytes) {
  FmuResources resources;
  const fmi2Component c = resources.started_2(fmi2CoSimulation), other = resources.new_2(fmi2CoSimulation);
  fmi2SetReal(c, fmu_inputs.data(), 3, forces.data());
  after_steps(c, 0, 5);
  fmi2FMUstate state = nullptr, copy = nullptr;
  fmi2GetFMUstate(c, &state);
  std::size_t size = 0;
  EXPECT_EQ(fmi2SerializedFMUstateSize(c, state, &size), fmi2OK);
  std::vector<char> bytes(size);
  EXPECT_EQ(fmi2SerializeFMUstate(c, state, bytes.data(), size - 1), fmi2Error);
  EXPECT_EQ(fmi2SerializeFMUstate(c, state, bytes.data(), size), fmi2OK);
  EXPECT_EQ(fmi2DeSerializeFMUstate(other, bytes.data(), size, &copy), fmi2OK);
  EXPECT_EQ(fmi2SetFMUstate(other, copy), fmi2OK);
  EXPECT_EQ(after_steps(other, 5, 10), after_steps(c, 5, 10));
  fmi2FreeInstance(c);
  fmi2FreeInstance(other);  // with states that were not freed
}

TEST(FmuSavedState, IsRejectedIfItIsNotOneOfThisInstance) {
  FmuResources resources;
  const fmi2Component c = resources.started_2(fmi2CoSimulation), other = resources.started_2(fmi2CoSimulation);
  fmi2FMUstate state = nullptr;
  fmi2GetFMUstate(c, &state);
  EXPECT_EQ(fmi2SetFMUstate(other, state), fmi2Error);
  EXPECT_EQ(fmi2SetFMUstate(c, nullptr), fmi2Error);
  fmi2FMUstate again = state;
  EXPECT_EQ(fmi2FreeFMUstate(c, &state), fmi2OK);
  EXPECT_EQ(fmi2FreeFMUstate(c, &again), fmi2Error);
  EXPECT_EQ(fmi2SetFMUstate(c, again), fmi2Error);
  fmi2FreeInstance(c);
  fmi2FreeInstance(other);
}

TEST(FmuSavedState, IsRejectedIfItsBytesAreWrong) {
  FmuResources resources;
  const fmi2Component c = resources.started_2(fmi2CoSimulation), model = resources.started_2(fmi2ModelExchange);
  fmi2FMUstate state = nullptr, copy = nullptr;
  fmi2GetFMUstate(c, &state);
  std::size_t size = 0;
  fmi2SerializedFMUstateSize(c, state, &size);
  std::vector<char> bytes(size);
  fmi2SerializeFMUstate(c, state, bytes.data(), size);
  EXPECT_EQ(fmi2DeSerializeFMUstate(model, bytes.data(), size, &copy), fmi2Error);  // another kind
  EXPECT_EQ(fmi2DeSerializeFMUstate(c, bytes.data(), size - 8, &copy), fmi2Error);
  EXPECT_EQ(fmi2DeSerializeFMUstate(c, nullptr, size, &copy), fmi2Error);
  EXPECT_EQ(fmi2DeSerializeFMUstate(c, bytes.data(), 0, &copy), fmi2Error);
  const std::size_t numbers = size - (6 + 4 + 2 * 3) * sizeof(double);
  for (const std::size_t wrong : {0u, 1u, 2u, 4u, 6u, 15u}) {  // kind, phase, time, …
    std::vector<char> changed = bytes;
    const double nonsense = std::numeric_limits<double>::quiet_NaN();
    std::memcpy(changed.data() + numbers + wrong * sizeof(double), &nonsense, sizeof(double));
    EXPECT_EQ(fmi2DeSerializeFMUstate(c, changed.data(), size, &copy), fmi2Error) << wrong;
  }
  for (const double phase : {0.0, 3.0, 8.0, 64.0, -1.0}) {
    std::vector<char> changed = bytes;
    std::memcpy(changed.data() + numbers + sizeof(double), &phase, sizeof(double));
    EXPECT_EQ(fmi2DeSerializeFMUstate(c, changed.data(), size, &copy), fmi2Error) << phase;
  }
  EXPECT_EQ(copy, nullptr);
  fmi2FreeInstance(c);
  fmi2FreeInstance(model);
}

}  // namespace fmu_saved_state_test
