// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/analyses/analysis_results.h"

#include "trivet/foundation/invalid_input.h"
#include "trivet/project/analyses/analysis_types.h"
#include "trivet/response/transient/transient_refusals.h"
#include "trivet/study/analyses/analysis_run.h"

namespace trivet::study {
namespace {

/// Row of a coordinate by its full name.
Eigen::Index row_of(const CaseContext& c, const std::string& name) {
  for (std::size_t b = 0; b < c.system.bodies().size(); ++b)
    for (int j = 0; j < 6; ++j)
      if (name == c.system.bodies()[b].name + "." + model::coordinate_names[j] && c.assembled.layout.row(b, j) >= 0)
        return c.assembled.layout.row(b, j);
  throw foundation::NotComputable("transient: initial value of \"" + name + "\": no free coordinate has this name");
}

std::optional<response::InitialState> initial_state(const CaseContext& c, const project::TransientAnalysis& request) {
  if (request.displacements.empty() && request.velocities.empty()) return std::nullopt;
  Eigen::VectorXd q = Eigen::VectorXd::Zero(c.assembled.layout.of_bodies()), v = q;
  for (const auto& [name, value] : request.displacements) q(row_of(c, name)) = value;
  for (const auto& [name, value] : request.velocities) v(row_of(c, name)) = value;
  return response::initial_state(c.assembled, q, v);
}

}  // namespace

TransientResult transient_result(const CaseContext& c, const project::TransientAnalysis& request,
                                 foundation::Problems& warnings) {
  const std::vector<response::TimeInput> inputs =
      response::time_inputs(c.system, c.assembled, request.selection.excitations);
  response::TransientOptions options;
  options.from = request.from;
  options.to = request.to;
  options.step = request.step;
  options.nearest_linear_system = request.nearest_linear_system;
  options.initial = initial_state(c, request);
  if (inputs.empty() && !options.initial)
    throw foundation::NotComputable(
        "transient: the model has no time excitation and no initial values; add [excitations.NAME] with type = "
        "\"time\", or initial values");
  TransientResult result{response::transient_response(c.system, c.assembled, channels_of(c, request.selection), inputs,
                                                      options, c.progress),
                         request.selection.quantity};
  warnings.add(result.response.warnings);
  if (request.nearest_linear_system && !c.assembled.frequency_dependent())
    warnings.warning("analyses.transient.nearest_linear_system", "true", "no element needs it, so it has no effect",
                     "remove it");
  return result;
}

const AnalysisRun transient_run =
    computed_by<&project::Analyses::transient, &CaseResults::transient, transient_result>("time history of the motion");

}  // namespace trivet::study
