// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/modes/backbone.h"

#include <fmt/format.h>

#include <algorithm>

#include "trivet/nonlinear/balance/steady_equations.h"
#include "trivet/project/analyses/analysis_types.h"
#include "trivet/study/analyses/analysis_run.h"

namespace trivet::study {
namespace {

nonlinear::Backbone one_mode(const CaseContext& c, const project::BackboneAnalysis& request, int mode) {
  nonlinear::BackboneOptions options{.mode = mode - 1, .up_to = request.up_to};
  options.up_to_angle = request.up_to_angle;
  options.up_to_energy = request.up_to_energy;
  options.damped = request.damped;
  options.of = request.selection.of;
  options.quantity = request.selection.quantity;
  constexpr Eigen::Index first = 5;
  for (options.harmonics = request.harmonics > 0 ? request.harmonics : first;;
       options.harmonics = std::min(nonlinear::most_steady_harmonics, 2 * options.harmonics)) {
    nonlinear::Backbone found = nonlinear::backbone(c.system, options, c.progress);
    if (request.harmonics > 0 || found.left_out <= request.tolerance ||
        options.harmonics == nonlinear::most_steady_harmonics)
      return found;
  }
}

std::vector<nonlinear::Backbone> backbone_result(const CaseContext& c, const project::BackboneAnalysis& request,
                                                 foundation::Problems& warnings) {
  std::vector<nonlinear::Backbone> all;
  for (const int mode : request.modes) {
    all.push_back(one_mode(c, request, mode));
    const nonlinear::Backbone& found = all.back();
    const std::string subject = "analyses.backbone";
    if (found.left_out > request.tolerance)
      warnings.warning(subject,
                       fmt::format("mode {}: {} harmonics leave out {:.2g} of the deflections", mode, found.harmonics,
                                   found.left_out),
                       fmt::format("the tolerance is {:.2g}", request.tolerance),
                       "take more, or end at a smaller amplitude");
    if (!found.ended.empty())
      warnings.warning(subject, fmt::format("mode {} ends before the end asked for", mode), found.ended,
                       "no motion beyond is computed");
  }
  return all;
}

}  // namespace

const AnalysisRun backbone_run = computed_by<&project::Analyses::backbone, &CaseResults::backbone, backbone_result>(
    "nonlinear modes: frequency and damping over amplitude",
    "backbone: no end of the amplitude given; add backbone = {up_to = \"10 mm\"} to [analyses]");

}  // namespace trivet::study
