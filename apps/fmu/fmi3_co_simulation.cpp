// SPDX-License-Identifier: BSD-3-Clause
// Inputs keep their values during a step: version 3.0 has no function for derivatives of inputs, and the model has no
// intermediate update.
#include <stdexcept>

#include "fmu/fmi3_interface.h"
#include "fmu/fmi3_status.h"
#include "fmu/value_calls.h"

using namespace trivet::fmu;

fmi3Status fmi3EnterStepMode(fmi3Instance instance) {
  return fmi3_status(guarded_call(instance, "fmi3EnterStepMode", phase::any, [](Instance&) {
    throw std::runtime_error("the model has no event mode in co-simulation");
  }));
}

fmi3Status fmi3GetOutputDerivatives(fmi3Instance instance, const fmi3ValueReference references[], std::size_t count,
                                    const fmi3Int32 orders[], fmi3Float64 values[], std::size_t value_count) {
  return fmi3_status(get_output_derivatives(instance, "fmi3GetOutputDerivatives", {references, count}, {orders, count},
                                            {values, value_count}));
}

fmi3Status fmi3DoStep(fmi3Instance instance, fmi3Float64 from, fmi3Float64 step, fmi3Boolean, fmi3Boolean* event_needed,
                      fmi3Boolean* terminate_simulation, fmi3Boolean* early_return, fmi3Float64* last_time) {
  return fmi3_status(guarded_call(instance, "fmi3DoStep", phase::step, [&](Instance& self) {
    for (fmi3Boolean* result : {event_needed, terminate_simulation, early_return})
      place(result, "a pointer to an answer") = false;
    double& reached = place(last_time, "the pointer to the last time");
    reached = self.simulation().state().time;
    self.advance(from, step);
    reached = self.simulation().state().time;
  }));
}

fmi3Status fmi3ActivateModelPartition(fmi3Instance instance, fmi3ValueReference, fmi3Float64) {
  return fmi3_status(guarded_call(instance, "fmi3ActivateModelPartition", phase::any, [](Instance&) {
    throw std::runtime_error("the model has no clocks, so there is no scheduled execution");
  }));
}
