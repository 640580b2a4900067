// SPDX-License-Identifier: BSD-3-Clause
#include "fmu/phase_calls.h"

#include <stdexcept>
#include <string>
#include <string_view>

namespace trivet::fmu {
namespace {

bool is_category(std::string_view name) {
  return name == log_category::events || name == log_category::warnings || name == log_category::errors;
}

}  // namespace

Outcome set_debug_logging(void* instance, const char* function, bool on, std::size_t count,
                          const char* const categories[]) {
  return guarded_call(instance, function, phase::any, [&](Instance& self) {
    bool has_events = count == 0;
    for (const char* category : array(categories, count, "categories")) {
      const std::string_view name = &place(category, "a category");
      if (!is_category(name)) throw std::runtime_error("there is no category \"" + std::string(name) + "\"");
      has_events = has_events || name == log_category::events;
    }
    self.report_events(on && has_events);
  });
}

Outcome set_experiment(void* instance, const char* function, double start_time, double stop_time) {
  return guarded_call(instance, function, phase::instantiated,
                      [&](Instance& self) { self.simulation().set_experiment(start_time, stop_time); });
}

Outcome enter_initialization_mode(void* instance, const char* function) {
  return guarded_call(instance, function, phase::instantiated,
                      [](Instance& self) { self.enter(phase::initialization); });
}

Outcome exit_initialization_mode(void* instance, const char* function) {
  return guarded_call(instance, function, phase::initialization, [](Instance& self) {
    self.enter(self.kind() == InterfaceKind::co_simulation ? phase::step : phase::event);
  });
}

Outcome enter_event_mode(void* instance, const char* function) {
  return guarded_call(instance, function, phase::event | phase::continuous_time,
                      [](Instance& self) { self.enter(phase::event); });
}

Outcome enter_continuous_time_mode(void* instance, const char* function) {
  return guarded_call(instance, function, phase::event, [](Instance& self) { self.enter(phase::continuous_time); });
}

Outcome terminate(void* instance, const char* function) {
  return guarded_call(instance, function, phase::running, [](Instance& self) { self.enter(phase::terminated); });
}

Outcome reset(void* instance, const char* function) {
  return guarded_call(instance, function, phase::any, [](Instance& self) { self.reset(); });
}

}  // namespace trivet::fmu
