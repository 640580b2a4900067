// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/rest_of_clearances.h"

#include "trivet/assembly/assembled.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/nonlinear/static_machine.h"
#include "trivet/response/steady/static_response.h"

namespace trivet::project {

foundation::Problems without_rest(const Case& variant) {
  foundation::Problems problems;
  if (variant.system.description().clearances.empty()) return problems;
  try {
    const nonlinear::StaticMachine held = nonlinear::static_machine(variant.system, assembly::assemble(variant.system));
    static_cast<void>(response::static_response(held.system, held.assembled, {}));
  } catch (const foundation::NotComputable& reason) {
    problems
        .error("clearances", reason.what(),
               "a clearance is judged at rest and in motion, so every case needs a position of rest",
               "give the load or the support that is missing, or remove [clearances]")
        .origin = deepest(variant.document, "clearances").origin;
  }
  return problems;
}

}  // namespace trivet::project
