// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/static_machine.h"

#include "trivet/nonlinear/reference_machine.h"

namespace trivet::nonlinear {

StaticMachine static_machine(const model::System& system, const assembly::Assembled& assembled) {
  if (!is_nonlinear(system) || hold_at_rest(system).holds) return {system, assembled};
  const model::System held = with_references(system, positive_references(system));
  return {held, assembly::assemble(held)};
}

}  // namespace trivet::nonlinear
