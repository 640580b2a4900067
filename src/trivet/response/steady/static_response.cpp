// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/steady/static_response.h"

#include <algorithm>

#include "trivet/assembly/loads.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/modal/free_motions.h"
#include "trivet/numerics/sweep/frequency_sweep.h"
#include "trivet/response/steady/static_solution.h"

namespace trivet::response {

RestRow rest_row(const assembly::Assembled& given, const assembly::Channel& channel) {
  const assembly::Assembled& assembled = given.first_order();
  RestRow result{channel.on_displacement.real().head(assembled.matrices.size()).transpose(), channel.at_rest};
  for (const assembly::DynamicForce& force : channel.dynamic_forces) {
    const assembly::ElementMap& map = assembled.elements[force.element];
    const Eigen::RowVectorXd of_element = force.row * map.matrices.stiffness.topRows<12>() * map.ends;
    for (std::size_t j = 0; j < map.rows.size(); ++j) result.row(map.rows[j]) += of_element(to_index(j));
  }
  return result;
}

StaticSolution static_solution(const model::System& system, const assembly::Assembled& given) {
  const assembly::Assembled& assembled = given.first_order();
  const bool is_nonlinear = std::any_of(system.elements().begin(), system.elements().end(),
                                        [](const model::Element& e) { return e.law.nonlinear.has_value(); });
  if (!system.description().gravity && system.description().constant_forces.empty() && !is_nonlinear)
    throw foundation::NotComputable(
        "static: the model has no static load; give gravity = [0, 0, -9.80665] or an excitation of type \"constant\"");
  for (std::size_t e = 0; e < assembled.elements.size(); ++e)
    if (assembled.elements[e].defined_from > 0 && system.elements()[e].is_foundation)
      throw foundation::NotComputable("static: \"" + system.elements()[e].name +
                                      "\" is a mobility, which gives no static stiffness");
    else if (assembled.elements[e].defined_from > 0)
      throw foundation::NotComputable("static: the table of \"" + system.elements()[e].name +
                                      "\" starts above 0 Hz and gives no static stiffness; add a row at 0 Hz");
  const modal::Modes modes = modal::modes(system, assembled);
  if (modal::has_rigid_motion(modes)) {
    std::string words;
    for (const std::string& motion : modal::free_motions(system, assembled, modes))
      words += (words.empty() ? "" : "; ") + motion;
    throw foundation::NotComputable("static: the position of rest is not unique: " + words);
  }
  numerics::DynamicMatrices stiffness_only = assembled.matrices;
  stiffness_only.K_loss.resize(0, 0);
  const Eigen::VectorXcd load = assembly::static_load(system, assembled).cast<std::complex<double>>();
  // In a static problem a coordinate without mass is like any other; a frequency-dependent element acts with D(0),
  // which its matrices contain.
  const numerics::SweepResult solved = numerics::sweep(stiffness_only, load, {0.0});
  if (solved.singular > 0) throw foundation::NotComputable("static: the stiffness matrix is singular");
  return {solved.response.col(0).real(), solved.backward_error(0)};
}

double value_at_rest(const assembly::Channel& channel, const assembly::Assembled& assembled,
                     const StaticSolution& rest) {
  double value = channel.on_displacement.real().dot(rest.coordinates) + channel.at_rest;
  for (const assembly::DynamicForce& force : channel.dynamic_forces) {
    const assembly::ElementMap& map = assembled.first_order().elements[force.element];
    value += force.row * (map.matrices.stiffness.topRows<12>() * map.coordinates(rest.coordinates));
  }
  return value;
}

StaticResponse static_response(const model::System& system, const assembly::Assembled& assembled,
                               const std::vector<assembly::Channel>& channels) {
  const StaticSolution rest = static_solution(system, assembled);
  StaticResponse result;
  result.backward_error = rest.backward_error;
  for (const assembly::Channel& channel : channels)
    if (channel.derivative == 0)
      result.values.push_back({channel.name, channel.unit, value_at_rest(channel, assembled, rest)});
  return result;
}

}  // namespace trivet::response
