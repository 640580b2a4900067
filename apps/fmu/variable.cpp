// SPDX-License-Identifier: BSD-3-Clause
#include "fmu/variable.h"

#include <array>
#include <stdexcept>
#include <string>
#include <utility>

namespace trivet::fmu {
namespace {

using Kind = Variable::Kind;

std::array<std::pair<Kind, std::size_t>, 5> ranges(const LinearModel& model) {
  return {{{Kind::time, 1},
           {Kind::input, model.inputs()},
           {Kind::output, model.outputs()},
           {Kind::state, model.states()},
           {Kind::derivative, model.states()}}};
}

}  // namespace

Variable variable(const LinearModel& model, ValueReference reference) {
  std::size_t index = reference;
  for (const auto& [kind, size] : ranges(model)) {
    if (index < size) return {kind, index};
    index -= size;
  }
  throw std::runtime_error("there is no variable with value reference " + std::to_string(reference));
}

ValueReference reference(const LinearModel& model, Variable variable) {
  std::size_t first = 0;
  for (const auto& [kind, size] : ranges(model)) {
    if (kind == variable.kind) break;
    first += size;
  }
  return static_cast<ValueReference>(first + variable.index);
}

std::string name(Variable variable) {
  constexpr std::array<const char*, 5> words = {"time", "input", "output", "state", "derivative of state"};
  const std::string word = words[static_cast<std::size_t>(variable.kind)];
  return variable.kind == Kind::time ? word : word + " " + std::to_string(variable.index + 1);
}

}  // namespace trivet::fmu
