// SPDX-License-Identifier: BSD-3-Clause
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

#include "fmu/fmi3_interface.h"
#include "fmu/fmi3_status.h"
#include "fmu/instantiation.h"
#include "fmu/phase_calls.h"
#include "fmu/state_calls.h"
#include "fmu/value_calls.h"

using namespace trivet::fmu;

namespace {

/// The logger of the importer; does nothing if there is none.
Log log_of(fmi3InstanceEnvironment environment, fmi3LogMessageCallback callback) {
  return [=](Outcome outcome, const char* category, const std::string& message) {
    if (callback != nullptr) callback(environment, fmi3_status(outcome), category, message.c_str());
  };
}

/// @param refusal  reason why the instance must not be made, or null
fmi3Instance checked_instance(InterfaceKind kind, fmi3String token, fmi3String resources, bool logging_on,
                              const Log& log, const char* refusal) {
  return new_instance(
      kind, token,
      [&] {
        if (refusal != nullptr) throw std::runtime_error(refusal);
        return std::string(&place(resources, "the path of the resources"));
      },
      log, logging_on);
}

}  // namespace

const char* fmi3GetVersion() { return "3.0"; }

fmi3Status fmi3SetDebugLogging(fmi3Instance instance, fmi3Boolean on, std::size_t count,
                               const fmi3String categories[]) {
  return fmi3_status(set_debug_logging(instance, "fmi3SetDebugLogging", on, count, categories));
}

fmi3Instance fmi3InstantiateModelExchange(fmi3String, fmi3String token, fmi3String resources, fmi3Boolean,
                                          fmi3Boolean logging_on, fmi3InstanceEnvironment environment,
                                          fmi3LogMessageCallback log) {
  return checked_instance(InterfaceKind::model_exchange, token, resources, logging_on, log_of(environment, log),
                          nullptr);
}

fmi3Instance fmi3InstantiateCoSimulation(fmi3String, fmi3String token, fmi3String resources, fmi3Boolean,
                                         fmi3Boolean logging_on, fmi3Boolean event_mode_used, fmi3Boolean,
                                         const fmi3ValueReference[], std::size_t, fmi3InstanceEnvironment environment,
                                         fmi3LogMessageCallback log, fmi3IntermediateUpdateCallback) {
  return checked_instance(InterfaceKind::co_simulation, token, resources, logging_on, log_of(environment, log),
                          event_mode_used ? "the model has no event mode in co-simulation" : nullptr);
}

fmi3Instance fmi3InstantiateScheduledExecution(fmi3String, fmi3String token, fmi3String resources, fmi3Boolean,
                                               fmi3Boolean logging_on, fmi3InstanceEnvironment environment,
                                               fmi3LogMessageCallback log, fmi3ClockUpdateCallback,
                                               fmi3LockPreemptionCallback, fmi3UnlockPreemptionCallback) {
  return checked_instance(InterfaceKind::co_simulation, token, resources, logging_on, log_of(environment, log),
                          "the model has no clocks, so there is no scheduled execution");
}

void fmi3FreeInstance(fmi3Instance instance) { std::unique_ptr<Instance>(static_cast<Instance*>(instance)).reset(); }

fmi3Status fmi3EnterInitializationMode(fmi3Instance instance, fmi3Boolean, fmi3Float64, fmi3Float64 start_time,
                                       fmi3Boolean stop_time_defined, fmi3Float64 stop_time) {
  constexpr const char* function = "fmi3EnterInitializationMode";
  const double stop = stop_time_defined ? stop_time : std::numeric_limits<double>::infinity();
  const Outcome outcome = set_experiment(instance, function, start_time, stop);
  return fmi3_status(outcome == Outcome::ok ? enter_initialization_mode(instance, function) : outcome);
}

fmi3Status fmi3ExitInitializationMode(fmi3Instance instance) {
  return fmi3_status(exit_initialization_mode(instance, "fmi3ExitInitializationMode"));
}

fmi3Status fmi3EnterEventMode(fmi3Instance instance) {
  return fmi3_status(enter_event_mode(instance, "fmi3EnterEventMode"));
}

fmi3Status fmi3Terminate(fmi3Instance instance) { return fmi3_status(terminate(instance, "fmi3Terminate")); }

fmi3Status fmi3Reset(fmi3Instance instance) { return fmi3_status(reset(instance, "fmi3Reset")); }

fmi3Status fmi3EnterConfigurationMode(fmi3Instance instance) {
  return fmi3_status(guarded_call(instance, "fmi3EnterConfigurationMode", phase::any, [](Instance&) {
    throw std::runtime_error("the model has no structural parameters");
  }));
}

fmi3Status fmi3ExitConfigurationMode(fmi3Instance instance) {
  return fmi3_status(guarded_call(instance, "fmi3ExitConfigurationMode", phase::any, [](Instance&) {
    throw std::runtime_error("the model has no structural parameters");
  }));
}

fmi3Status fmi3GetFloat64(fmi3Instance instance, const fmi3ValueReference references[], std::size_t count,
                          fmi3Float64 values[], std::size_t value_count) {
  return fmi3_status(get_numbers(instance, "fmi3GetFloat64", {references, count}, {values, value_count}));
}

fmi3Status fmi3SetFloat64(fmi3Instance instance, const fmi3ValueReference references[], std::size_t count,
                          const fmi3Float64 values[], std::size_t value_count) {
  return fmi3_status(set_numbers(instance, "fmi3SetFloat64", {references, count}, {values, value_count}));
}

fmi3Status fmi3GetDirectionalDerivative(fmi3Instance instance, const fmi3ValueReference unknowns[],
                                        std::size_t unknown_count, const fmi3ValueReference knowns[],
                                        std::size_t known_count, const fmi3Float64 seed[], std::size_t seed_count,
                                        fmi3Float64 sensitivity[], std::size_t sensitivity_count) {
  return fmi3_status(get_directional_derivative(instance, "fmi3GetDirectionalDerivative", {unknowns, unknown_count},
                                                {knowns, known_count}, {seed, seed_count},
                                                {sensitivity, sensitivity_count}));
}

fmi3Status fmi3GetAdjointDerivative(fmi3Instance instance, const fmi3ValueReference unknowns[],
                                    std::size_t unknown_count, const fmi3ValueReference knowns[],
                                    std::size_t known_count, const fmi3Float64 seed[], std::size_t seed_count,
                                    fmi3Float64 sensitivity[], std::size_t sensitivity_count) {
  return fmi3_status(get_adjoint_derivative(instance, "fmi3GetAdjointDerivative", {unknowns, unknown_count},
                                            {knowns, known_count}, {seed, seed_count},
                                            {sensitivity, sensitivity_count}));
}

fmi3Status fmi3GetFMUState(fmi3Instance instance, fmi3FMUState* state) {
  return fmi3_status(get_state(instance, "fmi3GetFMUState", state));
}

fmi3Status fmi3SetFMUState(fmi3Instance instance, fmi3FMUState state) {
  return fmi3_status(set_state(instance, "fmi3SetFMUState", state));
}

fmi3Status fmi3FreeFMUState(fmi3Instance instance, fmi3FMUState* state) {
  return fmi3_status(free_state(instance, "fmi3FreeFMUState", state));
}

fmi3Status fmi3SerializedFMUStateSize(fmi3Instance instance, fmi3FMUState state, std::size_t* size) {
  return fmi3_status(serialized_state_size(instance, "fmi3SerializedFMUStateSize", state, size));
}

fmi3Status fmi3SerializeFMUState(fmi3Instance instance, fmi3FMUState state, fmi3Byte bytes[], std::size_t size) {
  return fmi3_status(serialize_state(instance, "fmi3SerializeFMUState", state, bytes, size));
}

fmi3Status fmi3DeserializeFMUState(fmi3Instance instance, const fmi3Byte bytes[], std::size_t size,
                                   fmi3FMUState* state) {
  return fmi3_status(deserialize_state(instance, "fmi3DeserializeFMUState", bytes, size, state));
}
