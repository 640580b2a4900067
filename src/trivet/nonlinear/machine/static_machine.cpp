// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/machine/static_machine.h"

#include "trivet/nonlinear/machine/reference_machine.h"
#include "trivet/response/steady/at_rest.h"

namespace trivet::nonlinear {
namespace {

/// Does a force stay exactly the same on either side, as within an open gap? Anywhere there is then as much at rest.
bool is_flat(const elements::ScalarLaws& laws, double at) {
  constexpr double beside = 1e-6;  // [m, rad]
  const double here = elements::force_at_rest(laws, at).force;
  return elements::force_at_rest(laws, at + beside).force == here ||
      elements::force_at_rest(laws, at - beside).force == here;
}

/// Positive references of parts that have a force beside rest.
References references_of_restoring_parts(const model::System& system) {
  References found = positive_references(system);
  std::size_t part = 0, distance = 0;
  for (const model::Element& element : system.elements()) {
    for (const model::NonlinearPart& one : element.nonlinear_parts)
      if (const std::size_t i = part++; is_flat(one.laws, one.at_rest)) found.parts[i].stiffness = 0;
    for (const model::DistancePart& one : element.distance_parts)
      if (const std::size_t i = distance++; is_flat(one.law.laws, one.law.distance(one.at_rest) - one.law.length))
        found.distances[i].setZero();
  }
  return found;
}

}  // namespace

StaticMachine static_machine(const model::System& system, const assembly::Assembled& assembled) {
  const auto at_rest = [](const model::System& given, const assembly::Assembled& of_it) {
    const response::AtRest linear(given, of_it);
    return StaticMachine{linear.system(), linear.assembled()};
  };
  if (!model::is_nonlinear(system) || holds_static_load(system)) return at_rest(system, assembled);
  const model::System held = with_references(system, references_of_restoring_parts(system));
  return at_rest(held, assembly::assemble(held));
}

}  // namespace trivet::nonlinear
