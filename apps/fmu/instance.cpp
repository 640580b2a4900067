// SPDX-License-Identifier: BSD-3-Clause
#include "fmu/instance.h"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "fmu/shown_number.h"

namespace trivet::fmu {

Instance::Instance(InterfaceKind kind, LinearModel model, Log log)
    : kind_(kind), simulation_(std::move(model)), log_(std::move(log)) {}

void Instance::report_event(const std::string& message) {
  if (reports_events_) log_(Outcome::ok, log_category::events, message);
}

void Instance::report_warning(const std::string& message) {
  ++warnings_;
  log_(Outcome::warning, log_category::warnings, message);
}

void Instance::report_error(const std::string& message) { log_(Outcome::error, log_category::errors, message); }

void Instance::advance(double from, double step) {
  const std::size_t earlier = simulation_.exponentials();
  simulation_.advance(from, step);
  if (simulation_.exponentials() != earlier)
    report_event("a matrix exponential was computed for steps of " + shown(step) + " s");
}

void Instance::reset() {
  simulation_.reset();
  phase_ = phase::instantiated;
}

SavedState& Instance::known(void* saved) const {
  const auto found =
      std::ranges::find(saved_, saved, [](const auto& owned) { return static_cast<void*>(owned.get()); });
  if (found == saved_.end()) throw std::runtime_error("this is not a saved state of this instance");
  return **found;
}

void* Instance::store(SavedState state, void* earlier) {
  if (earlier != nullptr) {
    known(earlier) = std::move(state);
    return earlier;
  }
  return saved_.emplace_back(std::make_unique<SavedState>(std::move(state))).get();
}

void* Instance::save(void* earlier) { return store({kind_, phase_, simulation_.state()}, earlier); }

void* Instance::save_bytes(const std::string& bytes, void* earlier) {
  return store(deserialized(bytes, model(), kind_), earlier);
}

std::string Instance::bytes(void* saved) const { return serialized(known(saved), simulation_.model()); }

void Instance::restore(void* saved) {
  const SavedState& state = known(saved);
  simulation_.set_state(state.simulation);
  phase_ = state.phase;
}

void Instance::forget(void* saved) {
  const SavedState* state = &known(saved);
  std::erase_if(saved_, [&](const auto& owned) { return owned.get() == state; });
}

}  // namespace trivet::fmu
