// SPDX-License-Identifier: BSD-3-Clause
#include "fmu/model_exchange_calls.h"

#include <algorithm>
#include <span>

namespace trivet::fmu {
namespace {

template <typename T>
void check(const Instance& self, std::span<T> values) {
  check_count(values.size(), self.model().states(), "the number of values");
  array(values.data(), values.size(), "the array of values");
}

}  // namespace

Outcome set_time(void* instance, const char* function, double time) {
  return guarded_call(instance, function, phase::event | phase::continuous_time,
                      [&](Instance& self) { self.simulation().set_time(time); });
}

Outcome set_continuous_states(void* instance, const char* function, std::span<const double> states) {
  return guarded_call(instance, function, phase::continuous_time, [&](Instance& self) {
    check(self, states);
    self.simulation().set_states(states);
  });
}

Outcome get_continuous_states(void* instance, const char* function, std::span<double> states) {
  return guarded_call(instance, function, phase::computed, [&](Instance& self) {
    check(self, states);
    std::ranges::copy(self.simulation().state().states, states.begin());
  });
}

Outcome get_derivatives(void* instance, const char* function, std::span<double> derivatives) {
  return guarded_call(instance, function, phase::computed, [&](Instance& self) {
    check(self, derivatives);
    self.simulation().get_derivatives(derivatives);
  });
}

Outcome get_nominals(void* instance, const char* function, std::span<double> nominals) {
  return guarded_call(instance, function, phase::any, [&](Instance& self) {
    check(self, nominals);
    std::ranges::copy(self.model().nominals, nominals.begin());
  });
}

Outcome get_event_indicators(void* instance, const char* function, std::size_t count) {
  return guarded_call(instance, function, phase::computed,
                      [&](Instance&) { check_count(count, 0, "the number of event indicators"); });
}

}  // namespace trivet::fmu
