// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "fmu/guarded_call.h"

/// Functions of both versions of the interface that change the phase of an instance or its log.
namespace trivet::fmu {

/// Switches the report of events on or off; without categories, for all of them.
Outcome set_debug_logging(void* instance, const char* function, bool on, std::size_t count,
                          const char* const categories[]);

/// @param stop_time  [s], infinite if there is none
Outcome set_experiment(void* instance, const char* function, double start_time, double stop_time);
Outcome enter_initialization_mode(void* instance, const char* function);
Outcome exit_initialization_mode(void* instance, const char* function);
Outcome enter_event_mode(void* instance, const char* function);
Outcome enter_continuous_time_mode(void* instance, const char* function);
Outcome terminate(void* instance, const char* function);
Outcome reset(void* instance, const char* function);

}  // namespace trivet::fmu
