// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/judging/rest_state.h"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>

#include "trivet/foundation/invalid_input.h"
#include "trivet/nonlinear/rest/rest_position.h"

namespace trivet::judging {
namespace {

/// Bushes stiffen along e1 only: does the weight act across it?
void check_bush_directions(const model::System& system, foundation::Problems& problems) {
  const auto& gravity = system.description().gravity;
  if (!gravity) return;
  for (const model::Element& element : system.elements()) {
    if (!element.over_deflection || element.over_deflection->axis() != 0) continue;
    const Eigen::Vector3d weight = model::end_in_ground(system.bodies(), element.n).rotation.transpose() * *gravity;
    constexpr double small_share = 0.2, round_off = 1e-9;
    const double across = weight.tail<2>().norm();
    if (across <= small_share * std::abs(weight.x()) + round_off * weight.norm()) continue;
    problems.warning("elements." + element.name + ".nonlinear", "the weight acts across e1 of the bush",
                     "large deformations are computed along e1; across it the bush does not stiffen",
                     "give orientation so that e1 is along the load; trivet element shows the axes");
  }
}

}  // namespace

void settle(model::System& system, foundation::Problems& problems) {
  if (!model::is_nonlinear(system)) return;
  try {
    nonlinear::RestPosition rest = nonlinear::rest_position(system);
    for (const double share : rest.limit_loads)
      problems.warning("elements", fmt::format("limit load at {:.4g} of the static load", share),
                       "the machine snaps through there on its way to the position of rest",
                       "check gaps, coefficients and loads");
    if (!rest.stable)
      problems.warning("elements", "an unstable position of rest",
                       "the machine would leave it for another one; all analyses are about the unstable one",
                       "see all of them: static = {states = \"all\"}, and motions about them: steady = {branches = "
                       "\"all\"}; check the signs of the laws");
    system = std::move(rest.system);
    check_bush_directions(system, problems);
  } catch (const foundation::NotComputable& reason) {
    problems.error("elements", reason.what(), "the analyses of a nonlinear machine are about its position of rest",
                   "check loads, gaps and coefficients");
  }
}

void warn_of_small_motions(const model::System& system, const project::Analyses& request,
                           foundation::Problems& problems) {
  if (!model::is_nonlinear(system)) return;
  const auto warn = [&](const std::string& subject) {
    problems.warning(subject, "a nonlinear machine",
                     "the analysis is linear about rest: it ignores gaps, and mounts do not harden",
                     "compare with steady");
  };
  if (!request.limits.empty() || !request.limit_lines.empty()) warn(request.limits.empty() ? "limit_lines" : "limits");
  if (request.requirements) {
    project::Requirements of_small_motions = *request.requirements;
    of_small_motions.no_jump = of_small_motions.no_contact = of_small_motions.mount_load = false;
    of_small_motions.steady.clear();
    of_small_motions.statics.clear();
    of_small_motions.price.reset();
    of_small_motions.mass = 0;
    if (!of_small_motions.is_empty()) warn("requirements");
  }
  if (!system.description().clearances.empty())
    problems.warning(
        "clearances", "a nonlinear machine",
        "they are judged for small motions about rest: these pass through the gaps of stops, and mounts do "
        "not harden",
        "compare with their \".approach\" in steady, which is counted from rest");
  if (request.transient) warn("analyses.transient");
  if (request.random) warn("analyses.random");
  if (request.orders) warn("analyses.orders");
  if (request.operation) warn("operation");
  if (request.earthquake) warn("analyses.earthquake");
}

}  // namespace trivet::judging
