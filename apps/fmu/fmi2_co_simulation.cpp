// SPDX-License-Identifier: BSD-3-Clause
// Inputs keep their values during a step. If the importer sets their first derivatives, they follow straight lines
// during the next step, which are the exact solution's inputs too; derivatives apply to one step only, and those of
// higher order are ignored with a warning. After the step, the inputs have the values at its end.
#include <algorithm>
#include <stdexcept>

#include "fmu/fmi2_interface.h"
#include "fmu/fmi2_status.h"
#include "fmu/value_calls.h"

using namespace trivet::fmu;

namespace {

constexpr Phases after_initialization = phase::step | phase::terminated;

/// For a status that would exist only if steps ran in the background.
fmi2Status no_status(fmi2Component c, const char* function) {
  const Outcome outcome = guarded_call(c, function, after_initialization, [](Instance& self) {
    self.report_warning("no step runs in the background, so this status does not exist");
  });
  return outcome == Outcome::error ? fmi2Error : fmi2Discard;
}

}  // namespace

fmi2Status fmi2SetRealInputDerivatives(fmi2Component c, const fmi2ValueReference references[], std::size_t count,
                                       const fmi2Integer orders[], const fmi2Real values[]) {
  constexpr Phases permitted = phase::instantiated | phase::initialization | phase::step;
  return fmi2_status(guarded_call(c, "fmi2SetRealInputDerivatives", permitted, [&](Instance& self) {
    const auto known_orders = array(orders, count, "the array of orders");
    self.simulation().set_slopes(array(references, count, "the array of value references"), known_orders,
                                 array(values, count, "the array of values"));
    if (std::ranges::any_of(known_orders, [](int order) { return order > Simulation::largest_order; }))
      self.report_warning("derivatives of inputs of an order above 1 are ignored");
  }));
}

fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c, const fmi2ValueReference references[], std::size_t count,
                                        const fmi2Integer orders[], fmi2Real values[]) {
  return fmi2_status(
      get_output_derivatives(c, "fmi2GetRealOutputDerivatives", {references, count}, {orders, count}, {values, count}));
}

fmi2Status fmi2DoStep(fmi2Component c, fmi2Real from, fmi2Real step, fmi2Boolean) {
  return fmi2_status(guarded_call(c, "fmi2DoStep", phase::step, [&](Instance& self) { self.advance(from, step); }));
}

fmi2Status fmi2CancelStep(fmi2Component c) {
  return fmi2_status(guarded_call(c, "fmi2CancelStep", phase::any, [](Instance&) {
    throw std::runtime_error("no step runs in the background, so there is nothing to cancel");
  }));
}

fmi2Status fmi2GetStatus(fmi2Component c, fmi2StatusKind, fmi2Status*) { return no_status(c, "fmi2GetStatus"); }

fmi2Status fmi2GetRealStatus(fmi2Component c, fmi2StatusKind kind, fmi2Real* value) {
  if (kind != fmi2LastSuccessfulTime) return no_status(c, "fmi2GetRealStatus");
  return fmi2_status(guarded_call(c, "fmi2GetRealStatus", after_initialization, [&](Instance& self) {
    place(value, "the pointer to the value") = self.simulation().state().time;
  }));
}

fmi2Status fmi2GetIntegerStatus(fmi2Component c, fmi2StatusKind, fmi2Integer*) {
  return no_status(c, "fmi2GetIntegerStatus");
}

fmi2Status fmi2GetBooleanStatus(fmi2Component c, fmi2StatusKind kind, fmi2Boolean* value) {
  if (kind != fmi2Terminated) return no_status(c, "fmi2GetBooleanStatus");
  return fmi2_status(guarded_call(c, "fmi2GetBooleanStatus", after_initialization,
                                  [&](Instance&) { place(value, "the pointer to the value") = fmi2False; }));
}

fmi2Status fmi2GetStringStatus(fmi2Component c, fmi2StatusKind, fmi2String*) {
  return no_status(c, "fmi2GetStringStatus");
}
