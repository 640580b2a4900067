// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/steady_answer.h"

#include <fmt/format.h>

#include "trivet/foundation/invalid_input.h"
#include "trivet/nonlinear/deflections.h"
#include "trivet/study/question_answer.h"

namespace trivet::study {
namespace {

/// From a tenth of the lowest to 1.5 times the highest natural frequency about rest.
response::Band usual_band(const CaseContext& c) {
  double low = 0, high = 0;
  for (const modal::Mode& mode : c.modes.list)
    if (mode.angular_frequency && *mode.angular_frequency > 0) {
      low = low > 0 ? std::min(low, *mode.angular_frequency) : *mode.angular_frequency;
      high = std::max(high, *mode.angular_frequency);
    }
  if (!(high > 0))
    throw foundation::NotComputable("steady: no natural frequency about rest to choose a band from; give band = […]");
  return {0.1 * low, 1.5 * high};
}

}  // namespace

nonlinear::SteadyBranch steady_motions(const CaseContext& c, const project::SteadyQuestion& asked) {
  if (!nonlinear::is_nonlinear(c.system))
    throw foundation::InvalidInput(
        "steady: the machine is linear; take response, or give an element laws or a stop (docs/nonlinear.md)");
  nonlinear::SteadyOptions options;
  if (asked.over_load_factor) {
    options.over = nonlinear::Parameter::load_factor;
    options.angular_frequency = asked.at;
    options.from = asked.load_from;
    options.to = asked.load_to;
  } else {
    const response::Band band = asked.band ? *asked.band : usual_band(c);
    options.from = band.from;
    options.to = band.to;
  }
  options.excitations = asked.selection.excitations;
  options.of = asked.selection.of;
  options.quantity = asked.selection.quantity;
  options.harmonics = asked.harmonics;
  options.tolerance = asked.tolerance;
  options.detached = asked.all_branches;
  options.deep = asked.deep;
  return nonlinear::steady_branch(c.system, options, c.progress);
}

namespace {

nonlinear::SteadyBranch answer_steady(const CaseContext& c, const project::SteadyQuestion& asked,
                                      foundation::Problems& warnings) {
  const nonlinear::SteadyBranch branch = steady_motions(c, asked);
  if (branch.left_out > asked.tolerance)
    warnings.warning("analyses.steady",
                     fmt::format("{} harmonics leave out {:.2g} of the deflections", branch.harmonics, branch.left_out),
                     fmt::format("the tolerance is {:.2g}", asked.tolerance),
                     asked.harmonics > 0 ? "take more, or leave their number to the tolerance"
                                         : "near grazing contact no number of harmonics is enough");
  if (branch.held_share > 0)
    warnings.warning("analyses.steady",
                     "harmonics leave the table of an element, which is held constant beyond its end",
                     fmt::format("they have {:.2g} of the deflections", branch.held_share),
                     "extend the table if this share matters");
  if (!branch.winding.differs_at.empty() && !branch.winding.decides)
    warnings.warning("analyses.steady",
                     fmt::format("two verdicts on stability differ at {} of {} points",
                                 branch.winding.differs_at.size(), branch.winding.points),
                     fmt::format("the first at {:.10g} (rad/s, or a factor)", branch.winding.differs_at.front()),
                     "take more harmonics; close to a change of stability both are uncertain");
  for (const std::string& name : branch.lost_means)
    warnings.warning("analyses.steady", name + ": smooth friction bears a part of the load at rest, and none in motion",
                     "the mean of the motion contains this shift, however small the excitation",
                     "compare the half of the range, or leave the load to other elements");
  for (const std::string& name : branch.sticking)
    warnings.warning("analyses.steady", name + ": a slider sticks all the time at some frequencies",
                     "the mean of its force then depends on what happened before; here it has stuck since rest",
                     "take such means as one of many");
  if (!branch.ended.empty())
    warnings.warning("analyses.steady", "the branch of motions ends before the end of the band", branch.ended,
                     "no motion beyond is computed; give another band");
  return branch;
}

}  // namespace

const QuestionAnswer steady_answer =
    answered_by<answer_steady>("periodic motions of nonlinear machines, with folds, jumps and stability");

}  // namespace trivet::study
