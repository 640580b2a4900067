// SPDX-License-Identifier: BSD-3-Clause
#include "fmu/fmi2_interface.h"
#include "fmu/fmi2_status.h"
#include "fmu/model_exchange_calls.h"
#include "fmu/phase_calls.h"

using namespace trivet::fmu;

fmi2Status fmi2EnterEventMode(fmi2Component c) { return fmi2_status(enter_event_mode(c, "fmi2EnterEventMode")); }

fmi2Status fmi2NewDiscreteStates(fmi2Component c, fmi2EventInfo* info) {
  return fmi2_status(guarded_call(c, "fmi2NewDiscreteStates", phase::event,
                                  [&](Instance&) { place(info, "the pointer to the event information") = {}; }));
}

fmi2Status fmi2EnterContinuousTimeMode(fmi2Component c) {
  return fmi2_status(enter_continuous_time_mode(c, "fmi2EnterContinuousTimeMode"));
}

fmi2Status fmi2CompletedIntegratorStep(fmi2Component c, fmi2Boolean, fmi2Boolean* enter_event_mode,
                                       fmi2Boolean* terminate_simulation) {
  return fmi2_status(
      complete_integrator_step(c, "fmi2CompletedIntegratorStep", enter_event_mode, terminate_simulation));
}

fmi2Status fmi2SetTime(fmi2Component c, fmi2Real time) { return fmi2_status(set_time(c, "fmi2SetTime", time)); }

fmi2Status fmi2SetContinuousStates(fmi2Component c, const fmi2Real states[], std::size_t count) {
  return fmi2_status(set_continuous_states(c, "fmi2SetContinuousStates", {states, count}));
}

fmi2Status fmi2GetDerivatives(fmi2Component c, fmi2Real derivatives[], std::size_t count) {
  return fmi2_status(get_derivatives(c, "fmi2GetDerivatives", {derivatives, count}));
}

fmi2Status fmi2GetEventIndicators(fmi2Component c, fmi2Real[], std::size_t count) {
  return fmi2_status(get_event_indicators(c, "fmi2GetEventIndicators", count));
}

fmi2Status fmi2GetContinuousStates(fmi2Component c, fmi2Real states[], std::size_t count) {
  return fmi2_status(get_continuous_states(c, "fmi2GetContinuousStates", {states, count}));
}

fmi2Status fmi2GetNominalsOfContinuousStates(fmi2Component c, fmi2Real nominals[], std::size_t count) {
  return fmi2_status(get_nominals(c, "fmi2GetNominalsOfContinuousStates", {nominals, count}));
}
