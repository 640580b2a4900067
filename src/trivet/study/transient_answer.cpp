// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/invalid_input.h"
#include "trivet/study/case_context.h"

namespace trivet::study {
namespace {

std::vector<response::TimeInput> time_inputs(const CaseContext& c, const std::vector<std::string>& names) {
  std::vector<response::TimeInput> inputs;
  for (const model::Excitation& excitation : c.system.description().excitations)
    if (const auto* history = std::get_if<model::History>(&excitation.course); history && selected(names, excitation.name))
      inputs.push_back({excitation.name, history->signal, assembly::loading(c.assembled, excitation.action)});
  return inputs;
}

/// Row of a coordinate by its full name.
Eigen::Index row_of(const CaseContext& c, const std::string& name) {
  for (std::size_t b = 0; b < c.system.bodies().size(); ++b)
    for (int j = 0; j < 6; ++j)
      if (name == c.system.bodies()[b].name + "." + model::coordinate_names[static_cast<std::size_t>(j)] && c.assembled.layout.row(b, j) >= 0) return c.assembled.layout.row(b, j);
  throw foundation::NotComputable("transient: initial value of \"" + name + "\": no free coordinate has this name");
}

std::optional<response::InitialState> initial_state(const CaseContext& c, const project::TransientRequest& request) {
  if (request.displacements.empty() && request.velocities.empty()) return std::nullopt;
  Eigen::VectorXd q = Eigen::VectorXd::Zero(c.assembled.layout.of_bodies()), v = q;
  for (const auto& [name, value] : request.displacements) q(row_of(c, name)) = value;
  for (const auto& [name, value] : request.velocities) v(row_of(c, name)) = value;
  return response::initial_state(c.assembled, q, v);
}

}  // namespace

TransientResult transient_answer(const CaseContext& c, const project::TransientRequest& request, foundation::Problems& warnings) {
  const std::vector<response::TimeInput> inputs = time_inputs(c, request.wanted.excitations);
  response::TransientOptions options;
  options.from = request.from;
  options.to = request.to;
  options.step = request.step;
  options.nearest_linear_system = request.nearest_linear_system;
  options.initial = initial_state(c, request);
  if (inputs.empty() && !options.initial)
    throw foundation::NotComputable("transient: nothing sets the model in motion; add [excitations.NAME] with type = \"time\", or initial values");
  TransientResult result{response::transient_response(c.system, c.assembled, channels_of(c, request.wanted), inputs, options, c.progress), request.wanted.quantity};
  warnings.add(result.response.warnings);
  if (request.nearest_linear_system && !c.assembled.frequency_dependent())
    warnings.warning("analyses.transient.nearest_linear_system", "true",
                     "no element depends on frequency in a way that needs it", "remove it");
  return result;
}

}  // namespace trivet::study
