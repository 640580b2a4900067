// SPDX-License-Identifier: BSD-3-Clause
#include "fmu/fmi3_interface.h"
#include "fmu/fmi3_status.h"
#include "fmu/model_exchange_calls.h"
#include "fmu/phase_calls.h"

using namespace trivet::fmu;

fmi3Status fmi3EvaluateDiscreteStates(fmi3Instance instance) {
  return fmi3_status(
      guarded_call(instance, "fmi3EvaluateDiscreteStates", phase::initialization | phase::event, [](Instance&) {}));
}

fmi3Status fmi3UpdateDiscreteStates(fmi3Instance instance, fmi3Boolean* needs_update, fmi3Boolean* terminate_simulation,
                                    fmi3Boolean* nominals_changed, fmi3Boolean* states_changed,
                                    fmi3Boolean* next_event_defined, fmi3Float64* next_event) {
  return fmi3_status(guarded_call(instance, "fmi3UpdateDiscreteStates", phase::event, [&](Instance&) {
    for (fmi3Boolean* result :
         {needs_update, terminate_simulation, nominals_changed, states_changed, next_event_defined})
      place(result, "a pointer to an answer") = false;
    place(next_event, "the pointer to the next event") = 0;
  }));
}

fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance instance) {
  return fmi3_status(enter_continuous_time_mode(instance, "fmi3EnterContinuousTimeMode"));
}

fmi3Status fmi3CompletedIntegratorStep(fmi3Instance instance, fmi3Boolean, fmi3Boolean* enter_event_mode,
                                       fmi3Boolean* terminate_simulation) {
  return fmi3_status(
      complete_integrator_step(instance, "fmi3CompletedIntegratorStep", enter_event_mode, terminate_simulation));
}

fmi3Status fmi3SetTime(fmi3Instance instance, fmi3Float64 time) {
  return fmi3_status(set_time(instance, "fmi3SetTime", time));
}

fmi3Status fmi3SetContinuousStates(fmi3Instance instance, const fmi3Float64 states[], std::size_t count) {
  return fmi3_status(set_continuous_states(instance, "fmi3SetContinuousStates", {states, count}));
}

fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance instance, fmi3Float64 derivatives[], std::size_t count) {
  return fmi3_status(get_derivatives(instance, "fmi3GetContinuousStateDerivatives", {derivatives, count}));
}

fmi3Status fmi3GetEventIndicators(fmi3Instance instance, fmi3Float64[], std::size_t count) {
  return fmi3_status(get_event_indicators(instance, "fmi3GetEventIndicators", count));
}

fmi3Status fmi3GetContinuousStates(fmi3Instance instance, fmi3Float64 states[], std::size_t count) {
  return fmi3_status(get_continuous_states(instance, "fmi3GetContinuousStates", {states, count}));
}

fmi3Status fmi3GetNominalsOfContinuousStates(fmi3Instance instance, fmi3Float64 nominals[], std::size_t count) {
  return fmi3_status(get_nominals(instance, "fmi3GetNominalsOfContinuousStates", {nominals, count}));
}

fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance instance, std::size_t* count) {
  return fmi3_status(guarded_call(instance, "fmi3GetNumberOfEventIndicators", phase::any,
                                  [&](Instance&) { place(count, "the pointer to the number") = 0; }));
}

fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance instance, std::size_t* count) {
  return fmi3_status(guarded_call(instance, "fmi3GetNumberOfContinuousStates", phase::any, [&](Instance& self) {
    place(count, "the pointer to the number") = self.model().states();
  }));
}
