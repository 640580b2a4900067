// SPDX-License-Identifier: BSD-3-Clause
#include <vector>

#include "fmu/fmi3_interface.h"
#include "fmu/fmi3_status.h"
#include "fmu/guarded_call.h"

using namespace trivet::fmu;

namespace {

/// The states and inputs that an output or the derivative of a state depends on; none for other variables.
std::vector<ValueReference> dependencies(const Simulation& simulation, ValueReference dependent) {
  const LinearModel& model = simulation.model();
  const Variable::Kind kind = variable(model, dependent).kind;
  std::vector<ValueReference> found;
  if (kind != Variable::Kind::output && kind != Variable::Kind::derivative) return found;
  const auto add = [&](Variable::Kind known, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      const ValueReference candidate = reference(model, {known, i});
      if (simulation.partial_derivative(dependent, candidate) != 0) found.push_back(candidate);
    }
  };
  add(Variable::Kind::input, model.inputs());
  add(Variable::Kind::state, model.states());
  return found;
}

}  // namespace

fmi3Status fmi3GetNumberOfVariableDependencies(fmi3Instance instance, fmi3ValueReference reference,
                                               std::size_t* count) {
  return fmi3_status(guarded_call(instance, "fmi3GetNumberOfVariableDependencies", phase::any, [&](Instance& self) {
    place(count, "the pointer to the number") = dependencies(self.simulation(), reference).size();
  }));
}

fmi3Status fmi3GetVariableDependencies(fmi3Instance instance, fmi3ValueReference dependent,
                                       std::size_t dependent_elements[], fmi3ValueReference independents[],
                                       std::size_t independent_elements[], fmi3DependencyKind kinds[],
                                       std::size_t count) {
  return fmi3_status(guarded_call(instance, "fmi3GetVariableDependencies", phase::any, [&](Instance& self) {
    constexpr std::size_t whole_variable = 0;
    const std::vector<ValueReference> found = dependencies(self.simulation(), dependent);
    check_count(count, found.size(), "the number of dependencies");
    const auto dependent_element = array(dependent_elements, count, "the array of elements of the dependent");
    const auto independent = array(independents, count, "the array of independents");
    const auto independent_element = array(independent_elements, count, "the array of elements of independents");
    const auto kind = array(kinds, count, "the array of kinds");
    for (std::size_t i = 0; i < count; ++i) {
      dependent_element[i] = independent_element[i] = whole_variable;
      independent[i] = found[i];
      kind[i] = fmi3Constant;
    }
  }));
}
