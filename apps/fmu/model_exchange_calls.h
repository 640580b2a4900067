// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>

#include "fmu/guarded_call.h"

/// Functions of both versions of the interface with which an integrator of the importer evaluates the model.
namespace trivet::fmu {

Outcome set_time(void* instance, const char* function, double time);
Outcome set_continuous_states(void* instance, const char* function, std::span<const double> states);
Outcome get_continuous_states(void* instance, const char* function, std::span<double> states);
Outcome get_derivatives(void* instance, const char* function, std::span<double> derivatives);
Outcome get_nominals(void* instance, const char* function, std::span<double> nominals);
/// There are none.
Outcome get_event_indicators(void* instance, const char* function, std::size_t count);

/// The model needs neither events nor an end of the simulation after a step of an integrator.
template <typename Boolean>
Outcome complete_integrator_step(void* instance, const char* function, Boolean* event, Boolean* end) {
  return guarded_call(instance, function, phase::continuous_time, [&](Instance&) {
    place(event, "the pointer to the wish for event mode") = Boolean(0);
    place(end, "the pointer to the wish for an end") = Boolean(0);
  });
}

}  // namespace trivet::fmu
