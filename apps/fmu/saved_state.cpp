// SPDX-License-Identifier: BSD-3-Clause
#include "fmu/saved_state.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace trivet::fmu {
namespace {

constexpr std::string_view format = "trivet-fmu-state-1 ";

[[noreturn]] void refuse() { throw std::runtime_error("these bytes are not a saved state of this model"); }

std::string heading(const LinearModel& model) { return std::string(format) + model.token + "\n"; }

/// All numbers of a state in a fixed order.
std::vector<double> numbers(const SavedState& state) {
  const SimulationState& s = state.simulation;
  std::vector<double> numbers = {
      static_cast<double>(state.kind), static_cast<double>(state.phase), s.time, s.stop_time, s.behind,
      s.slopes_are_used ? 1.0 : 0.0};
  for (const auto* values : {&s.states, &s.inputs, &s.slopes})
    numbers.insert(numbers.end(), values->begin(), values->end());
  return numbers;
}

bool is_phase_of(Phases phase, InterfaceKind kind) {
  const Phases running = kind == InterfaceKind::co_simulation ? phase::step : phase::event | phase::continuous_time;
  const Phases possible = phase::instantiated | phase::initialization | phase::terminated | running;
  return (phase & possible) != 0 && (phase & (phase - 1)) == 0;
}

/// Reads numbers one after the other.
class Numbers {
 public:
  explicit Numbers(std::vector<double> values) : values_(std::move(values)) {}
  /// @throws std::runtime_error if the number is not finite
  double next() {
    if (!std::isfinite(values_[position_])) refuse();
    return values_[position_++];
  }
  double next_or_infinite() {
    if (std::isnan(values_[position_])) refuse();
    return values_[position_++];
  }
  std::vector<double> next(std::size_t count) {
    std::vector<double> part(count);
    for (double& value : part) value = next();
    return part;
  }

 private:
  std::vector<double> values_;
  std::size_t position_ = 0;
};

}  // namespace

std::string serialized(const SavedState& state, const LinearModel& model) {
  const std::vector<double> values = numbers(state);
  const std::string head = heading(model);
  std::string bytes(head.size() + values.size() * sizeof(double), '\0');
  std::ranges::copy(head, bytes.begin());
  std::memcpy(bytes.data() + head.size(), values.data(), values.size() * sizeof(double));
  return bytes;
}

SavedState deserialized(std::string_view bytes, const LinearModel& model, InterfaceKind kind) {
  constexpr std::size_t single_numbers = 6;
  const std::string head = heading(model);
  const std::size_t count = single_numbers + model.states() + 2 * model.inputs();
  if (!bytes.starts_with(head) || bytes.size() != head.size() + count * sizeof(double)) refuse();
  std::vector<double> values(count);
  std::memcpy(values.data(), bytes.data() + head.size(), count * sizeof(double));

  Numbers rest(std::move(values));
  const double written_kind = rest.next(), written_phase = rest.next();
  if (written_kind != static_cast<double>(kind) || !(written_phase >= 0 && written_phase <= phase::any)) refuse();
  SavedState state{.kind = kind, .phase = static_cast<Phases>(written_phase), .simulation = {}};
  if (!is_phase_of(state.phase, kind)) refuse();
  SimulationState& s = state.simulation;
  s.time = rest.next();
  s.stop_time = rest.next_or_infinite();
  s.behind = rest.next();
  s.slopes_are_used = rest.next() != 0;
  s.states = rest.next(model.states());
  s.inputs = rest.next(model.inputs());
  s.slopes = rest.next(model.inputs());
  return state;
}

}  // namespace trivet::fmu
