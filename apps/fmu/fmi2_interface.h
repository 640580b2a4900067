// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "fmu/exported.h"

/// Types and functions of the Functional Mock-up Interface 2.0, as its specification defines them. [FMI2]
using fmi2Component = void*;
using fmi2ComponentEnvironment = void*;
using fmi2FMUstate = void*;
using fmi2ValueReference = unsigned int;
using fmi2Real = double;
using fmi2Integer = int;
using fmi2Boolean = int;
using fmi2Char = char;
using fmi2String = const fmi2Char*;
using fmi2Byte = char;

inline constexpr fmi2Boolean fmi2True = 1, fmi2False = 0;

enum fmi2Status { fmi2OK, fmi2Warning, fmi2Discard, fmi2Error, fmi2Fatal, fmi2Pending };
enum fmi2Type { fmi2ModelExchange, fmi2CoSimulation };
enum fmi2StatusKind { fmi2DoStepStatus, fmi2PendingStatus, fmi2LastSuccessfulTime, fmi2Terminated };

using fmi2CallbackLogger = void (*)(fmi2ComponentEnvironment environment, fmi2String instance_name, fmi2Status status,
                                    fmi2String category, fmi2String message, ...);
using fmi2CallbackAllocateMemory = void* (*)(std::size_t count, std::size_t size);
using fmi2CallbackFreeMemory = void (*)(void* memory);
using fmi2StepFinished = void (*)(fmi2ComponentEnvironment environment, fmi2Status status);

struct fmi2CallbackFunctions {
  fmi2CallbackLogger logger;
  fmi2CallbackAllocateMemory allocateMemory;
  fmi2CallbackFreeMemory freeMemory;
  fmi2StepFinished stepFinished;
  fmi2ComponentEnvironment componentEnvironment;
};

struct fmi2EventInfo {
  fmi2Boolean newDiscreteStatesNeeded;
  fmi2Boolean terminateSimulation;
  fmi2Boolean nominalsOfContinuousStatesChanged;
  fmi2Boolean valuesOfContinuousStatesChanged;
  fmi2Boolean nextEventTimeDefined;
  fmi2Real nextEventTime;
};

// Both kinds: creation, phases, log.
TRIVET_FMU_EXPORT const char* fmi2GetTypesPlatform();
TRIVET_FMU_EXPORT const char* fmi2GetVersion();
TRIVET_FMU_EXPORT fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean on, std::size_t count,
                                                 const fmi2String categories[]);
TRIVET_FMU_EXPORT fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                                                const fmi2CallbackFunctions* functions, fmi2Boolean visible,
                                                fmi2Boolean logging_on);
TRIVET_FMU_EXPORT void fmi2FreeInstance(fmi2Component c);
TRIVET_FMU_EXPORT fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean tolerance_defined, fmi2Real tolerance,
                                                 fmi2Real start_time, fmi2Boolean stop_time_defined,
                                                 fmi2Real stop_time);
TRIVET_FMU_EXPORT fmi2Status fmi2EnterInitializationMode(fmi2Component c);
TRIVET_FMU_EXPORT fmi2Status fmi2ExitInitializationMode(fmi2Component c);
TRIVET_FMU_EXPORT fmi2Status fmi2Terminate(fmi2Component c);
TRIVET_FMU_EXPORT fmi2Status fmi2Reset(fmi2Component c);

// Both kinds: values of variables.
TRIVET_FMU_EXPORT fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference references[], std::size_t count,
                                         fmi2Real values[]);
TRIVET_FMU_EXPORT fmi2Status fmi2GetInteger(fmi2Component c, const fmi2ValueReference references[], std::size_t count,
                                            fmi2Integer values[]);
TRIVET_FMU_EXPORT fmi2Status fmi2GetBoolean(fmi2Component c, const fmi2ValueReference references[], std::size_t count,
                                            fmi2Boolean values[]);
TRIVET_FMU_EXPORT fmi2Status fmi2GetString(fmi2Component c, const fmi2ValueReference references[], std::size_t count,
                                           fmi2String values[]);
TRIVET_FMU_EXPORT fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference references[], std::size_t count,
                                         const fmi2Real values[]);
TRIVET_FMU_EXPORT fmi2Status fmi2SetInteger(fmi2Component c, const fmi2ValueReference references[], std::size_t count,
                                            const fmi2Integer values[]);
TRIVET_FMU_EXPORT fmi2Status fmi2SetBoolean(fmi2Component c, const fmi2ValueReference references[], std::size_t count,
                                            const fmi2Boolean values[]);
TRIVET_FMU_EXPORT fmi2Status fmi2SetString(fmi2Component c, const fmi2ValueReference references[], std::size_t count,
                                           const fmi2String values[]);
TRIVET_FMU_EXPORT fmi2Status fmi2GetDirectionalDerivative(fmi2Component c, const fmi2ValueReference unknowns[],
                                                          std::size_t unknown_count, const fmi2ValueReference knowns[],
                                                          std::size_t known_count, const fmi2Real known_changes[],
                                                          fmi2Real unknown_changes[]);

// Both kinds: saved states.
TRIVET_FMU_EXPORT fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate* state);
TRIVET_FMU_EXPORT fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate state);
TRIVET_FMU_EXPORT fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate* state);
TRIVET_FMU_EXPORT fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate state, std::size_t* size);
TRIVET_FMU_EXPORT fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate state, fmi2Byte bytes[],
                                                   std::size_t size);
TRIVET_FMU_EXPORT fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte bytes[], std::size_t size,
                                                     fmi2FMUstate* state);

// Model exchange.
TRIVET_FMU_EXPORT fmi2Status fmi2EnterEventMode(fmi2Component c);
TRIVET_FMU_EXPORT fmi2Status fmi2NewDiscreteStates(fmi2Component c, fmi2EventInfo* info);
TRIVET_FMU_EXPORT fmi2Status fmi2EnterContinuousTimeMode(fmi2Component c);
TRIVET_FMU_EXPORT fmi2Status fmi2CompletedIntegratorStep(fmi2Component c, fmi2Boolean no_return_before,
                                                         fmi2Boolean* enter_event_mode,
                                                         fmi2Boolean* terminate_simulation);
TRIVET_FMU_EXPORT fmi2Status fmi2SetTime(fmi2Component c, fmi2Real time);
TRIVET_FMU_EXPORT fmi2Status fmi2SetContinuousStates(fmi2Component c, const fmi2Real states[], std::size_t count);
TRIVET_FMU_EXPORT fmi2Status fmi2GetDerivatives(fmi2Component c, fmi2Real derivatives[], std::size_t count);
TRIVET_FMU_EXPORT fmi2Status fmi2GetEventIndicators(fmi2Component c, fmi2Real indicators[], std::size_t count);
TRIVET_FMU_EXPORT fmi2Status fmi2GetContinuousStates(fmi2Component c, fmi2Real states[], std::size_t count);
TRIVET_FMU_EXPORT fmi2Status fmi2GetNominalsOfContinuousStates(fmi2Component c, fmi2Real nominals[], std::size_t count);

// Co-simulation.
TRIVET_FMU_EXPORT fmi2Status fmi2SetRealInputDerivatives(fmi2Component c, const fmi2ValueReference references[],
                                                         std::size_t count, const fmi2Integer orders[],
                                                         const fmi2Real values[]);
TRIVET_FMU_EXPORT fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c, const fmi2ValueReference references[],
                                                          std::size_t count, const fmi2Integer orders[],
                                                          fmi2Real values[]);
TRIVET_FMU_EXPORT fmi2Status fmi2DoStep(fmi2Component c, fmi2Real from, fmi2Real step, fmi2Boolean no_return_before);
TRIVET_FMU_EXPORT fmi2Status fmi2CancelStep(fmi2Component c);
TRIVET_FMU_EXPORT fmi2Status fmi2GetStatus(fmi2Component c, fmi2StatusKind kind, fmi2Status* value);
TRIVET_FMU_EXPORT fmi2Status fmi2GetRealStatus(fmi2Component c, fmi2StatusKind kind, fmi2Real* value);
TRIVET_FMU_EXPORT fmi2Status fmi2GetIntegerStatus(fmi2Component c, fmi2StatusKind kind, fmi2Integer* value);
TRIVET_FMU_EXPORT fmi2Status fmi2GetBooleanStatus(fmi2Component c, fmi2StatusKind kind, fmi2Boolean* value);
TRIVET_FMU_EXPORT fmi2Status fmi2GetStringStatus(fmi2Component c, fmi2StatusKind kind, fmi2String* value);
