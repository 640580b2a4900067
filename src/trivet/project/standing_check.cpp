// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/standing_check.h"

#include "trivet/assembly/assembled.h"
#include "trivet/assembly/second_order.h"
#include "trivet/model/static_stiffness.h"
#include "trivet/nonlinear/deflections.h"
#include "trivet/plausibility/overturning.h"

namespace trivet::project {

foundation::Problems standing_problems(const model::System& system) {
  foundation::Problems problems;
  if (!assembly::has_second_order(system)) return problems;
  // What stands is a question of statics: rubber resists a slow tilt with its static stiffness.
  const bool is_softer = model::has_static_stiffness(system);
  const auto falling = is_softer
      ? plausibility::falling_body(system, assembly::assemble(model::with_static_stiffness(system)))
      : plausibility::falling_body(system, assembly::assemble(system));
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
  return problems;
}

}  // namespace trivet::project
