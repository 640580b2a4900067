// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/judging/rest_checks.h"

#include <string>

#include "trivet/assembly/assembled.h"
#include "trivet/assembly/second_order.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/model/static_stiffness.h"
#include "trivet/nonlinear/machine/static_machine.h"
#include "trivet/plausibility/overturning.h"
#include "trivet/response/steady/static_response.h"

namespace trivet::judging {

foundation::Problems without_rest(const project::Case& variant, const assembly::AssembledOnce& assembled) {
  foundation::Problems problems;
  if (variant.system.description().clearances.empty()) return problems;
  try {
    const nonlinear::StaticMachine held = nonlinear::static_machine(variant.system, *assembled);
    static_cast<void>(response::static_response(held.system, held.assembled, {}));
  } catch (const foundation::NotComputable& reason) {
    problems
        .error("clearances", reason.what(),
               "a clearance is judged at rest and in motion, so every case needs a position of rest",
               "give the load or the support that is missing, or remove [clearances]")
        .origin = project::deepest(variant.document, "clearances").origin;
  }
  return problems;
}

foundation::Problems standing_problems(const project::Case& variant, const assembly::AssembledOnce& assembled) {
  const model::System& system = variant.system;
  foundation::Problems problems;
  if (!assembly::has_second_order(system)) return problems;
  // What stands is a matter of statics: rubber resists a slow tilt with its static stiffness.
  const bool is_softer = model::has_static_stiffness(system);
  const auto falling = is_softer
      ? plausibility::falling_body(system, assembly::assemble(model::with_static_stiffness(system)))
      : plausibility::falling_body(system, *assembled);
  if (!falling) return problems;
  const std::string subject = model::path_of(system.bodies()[falling->body]),
                    finding = plausibility::falling_words(system, *falling),
                    rule = "a machine stands if its elements hold it against the tilting by its weight";
  if (model::is_nonlinear(system))
    problems.warning(subject, finding, rule, "all analyses are about this unstable position; compare with steady");
  else
    problems.error(subject, finding, rule,
                   "lower the centre of mass, or take stiffer mounts or mounts farther apart; second_order = false "
                   "leaves the effect of the weight out");
  project::locate(problems, variant.document);
  return problems;
}

}  // namespace trivet::judging
