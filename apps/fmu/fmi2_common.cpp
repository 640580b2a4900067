// SPDX-License-Identifier: BSD-3-Clause
#include <limits>
#include <memory>
#include <string>

#include "fmu/fmi2_interface.h"
#include "fmu/fmi2_status.h"
#include "fmu/instantiation.h"
#include "fmu/phase_calls.h"
#include "fmu/resource_folder.h"
#include "fmu/state_calls.h"
#include "fmu/value_calls.h"

using namespace trivet::fmu;

namespace {

/// The text for a logger that formats its message: % begins a format and # a value reference.
std::string escaped(const std::string& message) {
  std::string text;
  for (const char character : message) {
    text += character;
    if (character == '%' || character == '#') text += character;
  }
  return text;
}

/// The logger of the importer; does nothing if there is none.
Log log_of(const fmi2CallbackFunctions* functions, const char* name) {
  if (functions == nullptr || functions->logger == nullptr) return [](Outcome, const char*, const std::string&) {};
  return [logger = functions->logger, environment = functions->componentEnvironment,
          instance = std::string(name == nullptr ? "" : name)](Outcome outcome, const char* category,
                                                               const std::string& message) {
    logger(environment, instance.c_str(), fmi2_status(outcome), category, escaped(message).c_str());
  };
}

}  // namespace

const char* fmi2GetTypesPlatform() { return "default"; }

const char* fmi2GetVersion() { return "2.0"; }

fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean on, std::size_t count, const fmi2String categories[]) {
  return fmi2_status(set_debug_logging(c, "fmi2SetDebugLogging", on != fmi2False, count, categories));
}

fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                              const fmi2CallbackFunctions* functions, fmi2Boolean, fmi2Boolean logging_on) {
  try {
    return new_instance(
        type == fmi2ModelExchange ? InterfaceKind::model_exchange : InterfaceKind::co_simulation, guid,
        [&] { return path_of_uri(&place(resources, "the location of the resources")); }, log_of(functions, name),
        logging_on != fmi2False);
  } catch (...) {  // not enough memory for the log itself
    return nullptr;
  }
}

void fmi2FreeInstance(fmi2Component c) { std::unique_ptr<Instance>(static_cast<Instance*>(c)).reset(); }

fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean, fmi2Real, fmi2Real start_time,
                               fmi2Boolean stop_time_defined, fmi2Real stop_time) {
  const double stop = stop_time_defined != fmi2False ? stop_time : std::numeric_limits<double>::infinity();
  return fmi2_status(set_experiment(c, "fmi2SetupExperiment", start_time, stop));
}

fmi2Status fmi2EnterInitializationMode(fmi2Component c) {
  return fmi2_status(enter_initialization_mode(c, "fmi2EnterInitializationMode"));
}

fmi2Status fmi2ExitInitializationMode(fmi2Component c) {
  return fmi2_status(exit_initialization_mode(c, "fmi2ExitInitializationMode"));
}

fmi2Status fmi2Terminate(fmi2Component c) { return fmi2_status(terminate(c, "fmi2Terminate")); }

fmi2Status fmi2Reset(fmi2Component c) { return fmi2_status(reset(c, "fmi2Reset")); }

fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference references[], std::size_t count, fmi2Real values[]) {
  return fmi2_status(get_numbers(c, "fmi2GetReal", {references, count}, {values, count}));
}

fmi2Status fmi2GetInteger(fmi2Component c, const fmi2ValueReference[], std::size_t count, fmi2Integer[]) {
  return fmi2_status(access_absent_type(c, "fmi2GetInteger", count));
}

fmi2Status fmi2GetBoolean(fmi2Component c, const fmi2ValueReference[], std::size_t count, fmi2Boolean[]) {
  return fmi2_status(access_absent_type(c, "fmi2GetBoolean", count));
}

fmi2Status fmi2GetString(fmi2Component c, const fmi2ValueReference[], std::size_t count, fmi2String[]) {
  return fmi2_status(access_absent_type(c, "fmi2GetString", count));
}

fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference references[], std::size_t count,
                       const fmi2Real values[]) {
  return fmi2_status(set_numbers(c, "fmi2SetReal", {references, count}, {values, count}));
}

fmi2Status fmi2SetInteger(fmi2Component c, const fmi2ValueReference[], std::size_t count, const fmi2Integer[]) {
  return fmi2_status(access_absent_type(c, "fmi2SetInteger", count));
}

fmi2Status fmi2SetBoolean(fmi2Component c, const fmi2ValueReference[], std::size_t count, const fmi2Boolean[]) {
  return fmi2_status(access_absent_type(c, "fmi2SetBoolean", count));
}

fmi2Status fmi2SetString(fmi2Component c, const fmi2ValueReference[], std::size_t count, const fmi2String[]) {
  return fmi2_status(access_absent_type(c, "fmi2SetString", count));
}

fmi2Status fmi2GetDirectionalDerivative(fmi2Component c, const fmi2ValueReference unknowns[], std::size_t unknown_count,
                                        const fmi2ValueReference knowns[], std::size_t known_count,
                                        const fmi2Real known_changes[], fmi2Real unknown_changes[]) {
  return fmi2_status(get_directional_derivative(c, "fmi2GetDirectionalDerivative", {unknowns, unknown_count},
                                                {knowns, known_count}, {known_changes, known_count},
                                                {unknown_changes, unknown_count}));
}

fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate* state) {
  return fmi2_status(get_state(c, "fmi2GetFMUstate", state));
}

fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate state) {
  return fmi2_status(set_state(c, "fmi2SetFMUstate", state));
}

fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate* state) {
  return fmi2_status(free_state(c, "fmi2FreeFMUstate", state));
}

fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate state, std::size_t* size) {
  return fmi2_status(serialized_state_size(c, "fmi2SerializedFMUstateSize", state, size));
}

fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate state, fmi2Byte bytes[], std::size_t size) {
  return fmi2_status(serialize_state(c, "fmi2SerializeFMUstate", state, bytes, size));
}

fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte bytes[], std::size_t size, fmi2FMUstate* state) {
  return fmi2_status(deserialize_state(c, "fmi2DeSerializeFMUstate", bytes, size, state));
}
