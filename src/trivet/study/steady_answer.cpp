// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "trivet/foundation/invalid_input.h"
#include "trivet/nonlinear/deflections.h"
#include "trivet/nonlinear/steady_branch.h"
#include "trivet/project/analyses/steady_question.h"
#include "trivet/study/question_answer.h"

namespace trivet::study {
namespace {

constexpr Eigen::Index first_harmonics = 5, most_harmonics = 60;

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

nonlinear::SteadyBranch answer_steady(const CaseContext& c, const project::SteadyQuestion& asked,
                                      foundation::Problems& warnings) {
  if (!nonlinear::is_nonlinear(c.system))
    throw foundation::InvalidInput(
        "steady: the machine is linear; take response, or give an element laws or a stop (docs/nonlinear.md)");
  const response::Band band = asked.band ? *asked.band : usual_band(c);
  nonlinear::SteadyOptions options{.from = band.from, .to = band.to};
  options.harmonics = asked.harmonics > 0 ? asked.harmonics : first_harmonics;
  options.excitations = asked.selection.excitations;
  options.of = asked.selection.of;
  options.quantity = asked.selection.quantity;
  const bool seek = asked.harmonics == 0;
  for (options.with_results = false; seek && options.harmonics < most_harmonics;
       options.harmonics = std::min(most_harmonics, 2 * options.harmonics))
    if (nonlinear::steady_branch(c.system, options, c.progress).left_out <= asked.tolerance) break;
  options.with_results = true;
  const nonlinear::SteadyBranch branch = nonlinear::steady_branch(c.system, options, c.progress);
  if (branch.left_out > asked.tolerance)
    warnings.warning("analyses.steady",
                     fmt::format("{} harmonics leave out {:.2g} of the deflections", branch.harmonics, branch.left_out),
                     fmt::format("the tolerance is {:.2g}", asked.tolerance),
                     asked.harmonics > 0 ? "take more, or leave their number to the tolerance"
                                         : "near grazing contact no number of harmonics is enough");
  if (!branch.ended.empty())
    warnings.warning("analyses.steady", "the branch of motions ends before the end of the band", branch.ended,
                     "no motion beyond is computed; give another band");
  return branch;
}

}  // namespace

const QuestionAnswer steady_answer =
    answered_by<answer_steady>("periodic motions of nonlinear machines, with folds, jumps and stability");

}  // namespace trivet::study
