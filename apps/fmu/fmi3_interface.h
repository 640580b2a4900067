// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "fmu/exported.h"

/// Types and functions of the Functional Mock-up Interface 3.0, as its specification defines them. [FMI3]
using fmi3Instance = void*;
using fmi3InstanceEnvironment = void*;
using fmi3FMUState = void*;
using fmi3ValueReference = std::uint32_t;
using fmi3Float32 = float;
using fmi3Float64 = double;
using fmi3Int8 = std::int8_t;
using fmi3UInt8 = std::uint8_t;
using fmi3Int16 = std::int16_t;
using fmi3UInt16 = std::uint16_t;
using fmi3Int32 = std::int32_t;
using fmi3UInt32 = std::uint32_t;
using fmi3Int64 = std::int64_t;
using fmi3UInt64 = std::uint64_t;
using fmi3Boolean = bool;
using fmi3Char = char;
using fmi3String = const fmi3Char*;
using fmi3Byte = std::uint8_t;
using fmi3Binary = const fmi3Byte*;
using fmi3Clock = bool;

enum fmi3Status { fmi3OK, fmi3Warning, fmi3Discard, fmi3Error, fmi3Fatal };
enum fmi3DependencyKind { fmi3Independent, fmi3Constant, fmi3Fixed, fmi3Tunable, fmi3Discrete, fmi3Dependent };
enum fmi3IntervalQualifier { fmi3IntervalNotYetKnown, fmi3IntervalUnchanged, fmi3IntervalChanged };

using fmi3LogMessageCallback = void (*)(fmi3InstanceEnvironment environment, fmi3Status status, fmi3String category,
                                        fmi3String message);
using fmi3ClockUpdateCallback = void (*)(fmi3InstanceEnvironment environment);
using fmi3IntermediateUpdateCallback = void (*)(fmi3InstanceEnvironment environment, fmi3Float64 time,
                                                fmi3Boolean set_requested, fmi3Boolean get_allowed,
                                                fmi3Boolean step_finished, fmi3Boolean can_return_early,
                                                fmi3Boolean* return_requested, fmi3Float64* return_time);
using fmi3LockPreemptionCallback = void (*)();
using fmi3UnlockPreemptionCallback = void (*)();

// All kinds: creation, phases, log.
TRIVET_FMU_EXPORT const char* fmi3GetVersion();
TRIVET_FMU_EXPORT fmi3Status fmi3SetDebugLogging(fmi3Instance instance, fmi3Boolean on, std::size_t count,
                                                 const fmi3String categories[]);
TRIVET_FMU_EXPORT fmi3Instance fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String resources,
                                                            fmi3Boolean visible, fmi3Boolean logging_on,
                                                            fmi3InstanceEnvironment environment,
                                                            fmi3LogMessageCallback log);
TRIVET_FMU_EXPORT fmi3Instance fmi3InstantiateCoSimulation(
    fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible, fmi3Boolean logging_on,
    fmi3Boolean event_mode_used, fmi3Boolean early_return_allowed, const fmi3ValueReference intermediate_variables[],
    std::size_t intermediate_count, fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
    fmi3IntermediateUpdateCallback intermediate_update);
TRIVET_FMU_EXPORT fmi3Instance fmi3InstantiateScheduledExecution(
    fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible, fmi3Boolean logging_on,
    fmi3InstanceEnvironment environment, fmi3LogMessageCallback log, fmi3ClockUpdateCallback clock_update,
    fmi3LockPreemptionCallback lock, fmi3UnlockPreemptionCallback unlock);
TRIVET_FMU_EXPORT void fmi3FreeInstance(fmi3Instance instance);
TRIVET_FMU_EXPORT fmi3Status fmi3EnterInitializationMode(fmi3Instance instance, fmi3Boolean tolerance_defined,
                                                         fmi3Float64 tolerance, fmi3Float64 start_time,
                                                         fmi3Boolean stop_time_defined, fmi3Float64 stop_time);
TRIVET_FMU_EXPORT fmi3Status fmi3ExitInitializationMode(fmi3Instance instance);
TRIVET_FMU_EXPORT fmi3Status fmi3EnterEventMode(fmi3Instance instance);
TRIVET_FMU_EXPORT fmi3Status fmi3Terminate(fmi3Instance instance);
TRIVET_FMU_EXPORT fmi3Status fmi3Reset(fmi3Instance instance);
TRIVET_FMU_EXPORT fmi3Status fmi3EnterConfigurationMode(fmi3Instance instance);
TRIVET_FMU_EXPORT fmi3Status fmi3ExitConfigurationMode(fmi3Instance instance);

// All kinds: values of variables.
TRIVET_FMU_EXPORT fmi3Status fmi3GetFloat32(fmi3Instance instance, const fmi3ValueReference references[],
                                            std::size_t count, fmi3Float32 values[], std::size_t value_count);
TRIVET_FMU_EXPORT fmi3Status fmi3GetFloat64(fmi3Instance instance, const fmi3ValueReference references[],
                                            std::size_t count, fmi3Float64 values[], std::size_t value_count);
TRIVET_FMU_EXPORT fmi3Status fmi3GetInt8(fmi3Instance instance, const fmi3ValueReference references[],
                                         std::size_t count, fmi3Int8 values[], std::size_t value_count);
TRIVET_FMU_EXPORT fmi3Status fmi3GetUInt8(fmi3Instance instance, const fmi3ValueReference references[],
                                          std::size_t count, fmi3UInt8 values[], std::size_t value_count);
TRIVET_FMU_EXPORT fmi3Status fmi3GetInt16(fmi3Instance instance, const fmi3ValueReference references[],
                                          std::size_t count, fmi3Int16 values[], std::size_t value_count);
TRIVET_FMU_EXPORT fmi3Status fmi3GetUInt16(fmi3Instance instance, const fmi3ValueReference references[],
                                           std::size_t count, fmi3UInt16 values[], std::size_t value_count);
TRIVET_FMU_EXPORT fmi3Status fmi3GetInt32(fmi3Instance instance, const fmi3ValueReference references[],
                                          std::size_t count, fmi3Int32 values[], std::size_t value_count);
TRIVET_FMU_EXPORT fmi3Status fmi3GetUInt32(fmi3Instance instance, const fmi3ValueReference references[],
                                           std::size_t count, fmi3UInt32 values[], std::size_t value_count);
TRIVET_FMU_EXPORT fmi3Status fmi3GetInt64(fmi3Instance instance, const fmi3ValueReference references[],
                                          std::size_t count, fmi3Int64 values[], std::size_t value_count);
TRIVET_FMU_EXPORT fmi3Status fmi3GetUInt64(fmi3Instance instance, const fmi3ValueReference references[],
                                           std::size_t count, fmi3UInt64 values[], std::size_t value_count);
TRIVET_FMU_EXPORT fmi3Status fmi3GetBoolean(fmi3Instance instance, const fmi3ValueReference references[],
                                            std::size_t count, fmi3Boolean values[], std::size_t value_count);
TRIVET_FMU_EXPORT fmi3Status fmi3GetString(fmi3Instance instance, const fmi3ValueReference references[],
                                           std::size_t count, fmi3String values[], std::size_t value_count);
TRIVET_FMU_EXPORT fmi3Status fmi3GetBinary(fmi3Instance instance, const fmi3ValueReference references[],
                                           std::size_t count, std::size_t sizes[], fmi3Binary values[],
                                           std::size_t value_count);
TRIVET_FMU_EXPORT fmi3Status fmi3GetClock(fmi3Instance instance, const fmi3ValueReference references[],
                                          std::size_t count, fmi3Clock values[]);
TRIVET_FMU_EXPORT fmi3Status fmi3SetFloat32(fmi3Instance instance, const fmi3ValueReference references[],
                                            std::size_t count, const fmi3Float32 values[], std::size_t value_count);
TRIVET_FMU_EXPORT fmi3Status fmi3SetFloat64(fmi3Instance instance, const fmi3ValueReference references[],
                                            std::size_t count, const fmi3Float64 values[], std::size_t value_count);
TRIVET_FMU_EXPORT fmi3Status fmi3SetInt8(fmi3Instance instance, const fmi3ValueReference references[],
                                         std::size_t count, const fmi3Int8 values[], std::size_t value_count);
TRIVET_FMU_EXPORT fmi3Status fmi3SetUInt8(fmi3Instance instance, const fmi3ValueReference references[],
                                          std::size_t count, const fmi3UInt8 values[], std::size_t value_count);
TRIVET_FMU_EXPORT fmi3Status fmi3SetInt16(fmi3Instance instance, const fmi3ValueReference references[],
                                          std::size_t count, const fmi3Int16 values[], std::size_t value_count);
TRIVET_FMU_EXPORT fmi3Status fmi3SetUInt16(fmi3Instance instance, const fmi3ValueReference references[],
                                           std::size_t count, const fmi3UInt16 values[], std::size_t value_count);
TRIVET_FMU_EXPORT fmi3Status fmi3SetInt32(fmi3Instance instance, const fmi3ValueReference references[],
                                          std::size_t count, const fmi3Int32 values[], std::size_t value_count);
TRIVET_FMU_EXPORT fmi3Status fmi3SetUInt32(fmi3Instance instance, const fmi3ValueReference references[],
                                           std::size_t count, const fmi3UInt32 values[], std::size_t value_count);
TRIVET_FMU_EXPORT fmi3Status fmi3SetInt64(fmi3Instance instance, const fmi3ValueReference references[],
                                          std::size_t count, const fmi3Int64 values[], std::size_t value_count);
TRIVET_FMU_EXPORT fmi3Status fmi3SetUInt64(fmi3Instance instance, const fmi3ValueReference references[],
                                           std::size_t count, const fmi3UInt64 values[], std::size_t value_count);
TRIVET_FMU_EXPORT fmi3Status fmi3SetBoolean(fmi3Instance instance, const fmi3ValueReference references[],
                                            std::size_t count, const fmi3Boolean values[], std::size_t value_count);
TRIVET_FMU_EXPORT fmi3Status fmi3SetString(fmi3Instance instance, const fmi3ValueReference references[],
                                           std::size_t count, const fmi3String values[], std::size_t value_count);
TRIVET_FMU_EXPORT fmi3Status fmi3SetBinary(fmi3Instance instance, const fmi3ValueReference references[],
                                           std::size_t count, const std::size_t sizes[], const fmi3Binary values[],
                                           std::size_t value_count);
TRIVET_FMU_EXPORT fmi3Status fmi3SetClock(fmi3Instance instance, const fmi3ValueReference references[],
                                          std::size_t count, const fmi3Clock values[]);

// All kinds: dependencies and partial derivatives.
TRIVET_FMU_EXPORT fmi3Status fmi3GetNumberOfVariableDependencies(fmi3Instance instance, fmi3ValueReference reference,
                                                                 std::size_t* count);
TRIVET_FMU_EXPORT fmi3Status fmi3GetVariableDependencies(fmi3Instance instance, fmi3ValueReference dependent,
                                                         std::size_t dependent_elements[],
                                                         fmi3ValueReference independents[],
                                                         std::size_t independent_elements[], fmi3DependencyKind kinds[],
                                                         std::size_t count);
TRIVET_FMU_EXPORT fmi3Status fmi3GetDirectionalDerivative(fmi3Instance instance, const fmi3ValueReference unknowns[],
                                                          std::size_t unknown_count, const fmi3ValueReference knowns[],
                                                          std::size_t known_count, const fmi3Float64 seed[],
                                                          std::size_t seed_count, fmi3Float64 sensitivity[],
                                                          std::size_t sensitivity_count);
TRIVET_FMU_EXPORT fmi3Status fmi3GetAdjointDerivative(fmi3Instance instance, const fmi3ValueReference unknowns[],
                                                      std::size_t unknown_count, const fmi3ValueReference knowns[],
                                                      std::size_t known_count, const fmi3Float64 seed[],
                                                      std::size_t seed_count, fmi3Float64 sensitivity[],
                                                      std::size_t sensitivity_count);

// All kinds: saved states.
TRIVET_FMU_EXPORT fmi3Status fmi3GetFMUState(fmi3Instance instance, fmi3FMUState* state);
TRIVET_FMU_EXPORT fmi3Status fmi3SetFMUState(fmi3Instance instance, fmi3FMUState state);
TRIVET_FMU_EXPORT fmi3Status fmi3FreeFMUState(fmi3Instance instance, fmi3FMUState* state);
TRIVET_FMU_EXPORT fmi3Status fmi3SerializedFMUStateSize(fmi3Instance instance, fmi3FMUState state, std::size_t* size);
TRIVET_FMU_EXPORT fmi3Status fmi3SerializeFMUState(fmi3Instance instance, fmi3FMUState state, fmi3Byte bytes[],
                                                   std::size_t size);
TRIVET_FMU_EXPORT fmi3Status fmi3DeserializeFMUState(fmi3Instance instance, const fmi3Byte bytes[], std::size_t size,
                                                     fmi3FMUState* state);

// All kinds: clocks and discrete states.
TRIVET_FMU_EXPORT fmi3Status fmi3GetIntervalDecimal(fmi3Instance instance, const fmi3ValueReference references[],
                                                    std::size_t count, fmi3Float64 intervals[],
                                                    fmi3IntervalQualifier qualifiers[]);
TRIVET_FMU_EXPORT fmi3Status fmi3GetIntervalFraction(fmi3Instance instance, const fmi3ValueReference references[],
                                                     std::size_t count, fmi3UInt64 counters[], fmi3UInt64 resolutions[],
                                                     fmi3IntervalQualifier qualifiers[]);
TRIVET_FMU_EXPORT fmi3Status fmi3GetShiftDecimal(fmi3Instance instance, const fmi3ValueReference references[],
                                                 std::size_t count, fmi3Float64 shifts[]);
TRIVET_FMU_EXPORT fmi3Status fmi3GetShiftFraction(fmi3Instance instance, const fmi3ValueReference references[],
                                                  std::size_t count, fmi3UInt64 counters[], fmi3UInt64 resolutions[]);
TRIVET_FMU_EXPORT fmi3Status fmi3SetIntervalDecimal(fmi3Instance instance, const fmi3ValueReference references[],
                                                    std::size_t count, const fmi3Float64 intervals[]);
TRIVET_FMU_EXPORT fmi3Status fmi3SetIntervalFraction(fmi3Instance instance, const fmi3ValueReference references[],
                                                     std::size_t count, const fmi3UInt64 counters[],
                                                     const fmi3UInt64 resolutions[]);
TRIVET_FMU_EXPORT fmi3Status fmi3SetShiftDecimal(fmi3Instance instance, const fmi3ValueReference references[],
                                                 std::size_t count, const fmi3Float64 shifts[]);
TRIVET_FMU_EXPORT fmi3Status fmi3SetShiftFraction(fmi3Instance instance, const fmi3ValueReference references[],
                                                  std::size_t count, const fmi3UInt64 counters[],
                                                  const fmi3UInt64 resolutions[]);
TRIVET_FMU_EXPORT fmi3Status fmi3EvaluateDiscreteStates(fmi3Instance instance);
TRIVET_FMU_EXPORT fmi3Status fmi3UpdateDiscreteStates(fmi3Instance instance, fmi3Boolean* needs_update,
                                                      fmi3Boolean* terminate_simulation, fmi3Boolean* nominals_changed,
                                                      fmi3Boolean* states_changed, fmi3Boolean* next_event_defined,
                                                      fmi3Float64* next_event);

// Model exchange.
TRIVET_FMU_EXPORT fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance instance);
TRIVET_FMU_EXPORT fmi3Status fmi3CompletedIntegratorStep(fmi3Instance instance, fmi3Boolean no_return_before,
                                                         fmi3Boolean* enter_event_mode,
                                                         fmi3Boolean* terminate_simulation);
TRIVET_FMU_EXPORT fmi3Status fmi3SetTime(fmi3Instance instance, fmi3Float64 time);
TRIVET_FMU_EXPORT fmi3Status fmi3SetContinuousStates(fmi3Instance instance, const fmi3Float64 states[],
                                                     std::size_t count);
TRIVET_FMU_EXPORT fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance instance, fmi3Float64 derivatives[],
                                                               std::size_t count);
TRIVET_FMU_EXPORT fmi3Status fmi3GetEventIndicators(fmi3Instance instance, fmi3Float64 indicators[], std::size_t count);
TRIVET_FMU_EXPORT fmi3Status fmi3GetContinuousStates(fmi3Instance instance, fmi3Float64 states[], std::size_t count);
TRIVET_FMU_EXPORT fmi3Status fmi3GetNominalsOfContinuousStates(fmi3Instance instance, fmi3Float64 nominals[],
                                                               std::size_t count);
TRIVET_FMU_EXPORT fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance instance, std::size_t* count);
TRIVET_FMU_EXPORT fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance instance, std::size_t* count);

// Co-simulation and scheduled execution.
TRIVET_FMU_EXPORT fmi3Status fmi3EnterStepMode(fmi3Instance instance);
TRIVET_FMU_EXPORT fmi3Status fmi3GetOutputDerivatives(fmi3Instance instance, const fmi3ValueReference references[],
                                                      std::size_t count, const fmi3Int32 orders[], fmi3Float64 values[],
                                                      std::size_t value_count);
TRIVET_FMU_EXPORT fmi3Status fmi3DoStep(fmi3Instance instance, fmi3Float64 from, fmi3Float64 step,
                                        fmi3Boolean no_return_before, fmi3Boolean* event_needed,
                                        fmi3Boolean* terminate_simulation, fmi3Boolean* early_return,
                                        fmi3Float64* last_time);
TRIVET_FMU_EXPORT fmi3Status fmi3ActivateModelPartition(fmi3Instance instance, fmi3ValueReference clock,
                                                        fmi3Float64 time);
