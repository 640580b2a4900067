// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/backbone.h"

#include <fmt/format.h>

#include "trivet/project/analyses/backbone_question.h"
#include "trivet/study/harmonics_search.h"
#include "trivet/study/question_answer.h"

namespace trivet::study {
namespace {

nonlinear::Backbone one_mode(const CaseContext& c, const project::BackboneQuestion& asked, int mode) {
  nonlinear::BackboneOptions options{.mode = mode - 1, .up_to = asked.up_to, .up_to_energy = asked.up_to_energy};
  options.damped = asked.damped;
  options.of = asked.selection.of;
  options.quantity = asked.selection.quantity;
  return with_enough_harmonics(asked.harmonics, asked.tolerance, [&](Eigen::Index harmonics) {
    options.harmonics = harmonics;
    return nonlinear::backbone(c.system, options, c.progress);
  });
}

std::vector<nonlinear::Backbone> answer_backbone(const CaseContext& c, const project::BackboneQuestion& asked,
                                                 foundation::Problems& warnings) {
  std::vector<nonlinear::Backbone> all;
  for (const int mode : asked.modes) {
    all.push_back(one_mode(c, asked, mode));
    const nonlinear::Backbone& found = all.back();
    const std::string subject = "analyses.backbone";
    if (found.left_out > asked.tolerance)
      warnings.warning(subject,
                       fmt::format("mode {}: {} harmonics leave out {:.2g} of the deflections", mode, found.harmonics,
                                   found.left_out),
                       fmt::format("the tolerance is {:.2g}", asked.tolerance),
                       "take more, or end at a smaller amplitude");
    if (!found.ended.empty())
      warnings.warning(subject, fmt::format("mode {} ends before the end asked for", mode), found.ended,
                       "no motion beyond is computed");
  }
  return all;
}

}  // namespace

const QuestionAnswer backbone_answer = answered_by<answer_backbone>(
    "nonlinear modes: frequency and damping over amplitude", "backbone = {up_to = \"10 mm\"}");

}  // namespace trivet::study
