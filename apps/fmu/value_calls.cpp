// SPDX-License-Identifier: BSD-3-Clause
#include "fmu/value_calls.h"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <vector>

namespace trivet::fmu {
namespace {

template <typename T>
void check(std::span<T> values, std::size_t needed, const char* name) {
  check_count(values.size(), needed, "the number of values");
  array(values.data(), values.size(), name);
}

void check_references(std::span<const ValueReference> references) {
  array(references.data(), references.size(), "the array of value references");
}

}  // namespace

Outcome get_numbers(void* instance, const char* function, std::span<const ValueReference> references,
                    std::span<double> values) {
  return guarded_call(instance, function, phase::any, [&](Instance& self) {
    check_references(references);
    check(values, references.size(), "the array of values");
    self.simulation().get(references, values);
  });
}

Outcome set_numbers(void* instance, const char* function, std::span<const ValueReference> references,
                    std::span<const double> values) {
  constexpr Phases start = phase::instantiated | phase::initialization;
  return guarded_call(instance, function, start | phase::running, [&](Instance& self) {
    check_references(references);
    check(values, references.size(), "the array of values");
    self.simulation().set(references, values, (self.phase() & start) != 0);
  });
}

Outcome access_absent_type(void* instance, const char* function, std::size_t count) {
  return guarded_call(instance, function, phase::any, [&](Instance&) {
    if (count > 0) throw std::runtime_error("all variables are real numbers of double precision");
  });
}

Outcome get_directional_derivative(void* instance, const char* function, std::span<const ValueReference> unknowns,
                                   std::span<const ValueReference> knowns, std::span<const double> known_changes,
                                   std::span<double> unknown_changes) {
  return guarded_call(instance, function, phase::computed, [&](Instance& self) {
    check_references(unknowns);
    check_references(knowns);
    check(known_changes, knowns.size(), "the array of changes of knowns");
    check(unknown_changes, unknowns.size(), "the array of changes of unknowns");
    std::vector<double> changes(unknowns.size(), 0.0);
    for (std::size_t i = 0; i < unknowns.size(); ++i)
      for (std::size_t j = 0; j < knowns.size(); ++j)
        changes[i] += self.simulation().partial_derivative(unknowns[i], knowns[j]) * known_changes[j];
    std::ranges::copy(changes, unknown_changes.begin());
  });
}

Outcome get_adjoint_derivative(void* instance, const char* function, std::span<const ValueReference> unknowns,
                               std::span<const ValueReference> knowns, std::span<const double> unknown_weights,
                               std::span<double> known_weights) {
  return guarded_call(instance, function, phase::computed, [&](Instance& self) {
    check_references(unknowns);
    check_references(knowns);
    check(unknown_weights, unknowns.size(), "the array of weights of unknowns");
    check(known_weights, knowns.size(), "the array of weights of knowns");
    std::vector<double> weights(knowns.size(), 0.0);
    for (std::size_t i = 0; i < unknowns.size(); ++i)
      for (std::size_t j = 0; j < knowns.size(); ++j)
        weights[j] += self.simulation().partial_derivative(unknowns[i], knowns[j]) * unknown_weights[i];
    std::ranges::copy(weights, known_weights.begin());
  });
}

Outcome get_output_derivatives(void* instance, const char* function, std::span<const ValueReference> references,
                               std::span<const int> orders, std::span<double> values) {
  return guarded_call(instance, function, phase::step | phase::terminated, [&](Instance& self) {
    check_references(references);
    check(orders, references.size(), "the array of orders");
    check(values, references.size(), "the array of values");
    self.simulation().get_output_slopes(references, orders, values);
  });
}

}  // namespace trivet::fmu
