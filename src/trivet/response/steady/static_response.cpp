// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/steady/static_response.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "trivet/assembly/coordinates.h"
#include "trivet/assembly/loads.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/modal/free_motions.h"
#include "trivet/numerics/sweep/frequency_sweep.h"
#include "trivet/response/steady/at_rest.h"

namespace trivet::response {

namespace {

void refuse_without_load(const model::System& system) {
  const bool is_nonlinear =
      std::ranges::any_of(system.elements(), [](const model::Element& e) { return e.law.nonlinear.has_value(); });
  if (!system.description().gravity && system.description().constant_forces.empty() && !is_nonlinear)
    throw foundation::NotComputable(
        "static: the model has no static load; give gravity = [0, 0, -9.80665] or an excitation of type \"constant\"");
}

void refuse_without_static_stiffness(const model::System& system, const assembly::Assembled& assembled) {
  for (std::size_t e = 0; e < assembled.elements.size(); ++e)
    if (assembled.elements[e].defined_from > 0 && system.elements()[e].is_foundation)
      throw foundation::NotComputable("static: \"" + system.elements()[e].name +
                                      "\" is a mobility, which gives no static stiffness");
    else if (assembled.elements[e].defined_from > 0)
      throw foundation::NotComputable("static: the table of \"" + system.elements()[e].name +
                                      "\" starts above 0 Hz and gives no static stiffness; add a row at 0 Hz");
}

void refuse_free_motions(const model::System& system, const assembly::Assembled& assembled) {
  const modal::Modes modes = modal::modes(system, assembled);
  if (!modal::has_rigid_motion(modes)) {
    if (assembled.without_rest.empty()) return;
    throw foundation::NotComputable("static: body " + system.bodies()[assembled.without_rest.front()].name +
                                    " has no position of rest near that of the file; draw it where it hangs, or let "
                                    "elements hold it");
  }
  std::string words;
  for (const std::string& motion : modal::free_motions(system, assembled, modes))
    words += (words.empty() ? "" : "; ") + motion;
  throw foundation::NotComputable("static: the position of rest is not unique: " + words);
}

/// K q = Q. A coordinate without mass is like any other; a frequency-dependent element acts with D(0), which its
/// matrices contain.
std::pair<Eigen::VectorXd, double> solution_of(const assembly::Assembled& assembled, const Eigen::VectorXd& load) {
  if (load.isZero(0)) return {load, 0};
  assert(load.size() == assembled.matrices.size());
  numerics::DynamicMatrices stiffness_only = assembled.matrices;
  stiffness_only.K_loss.resize(0, 0);
  const numerics::SweepResult solved =
      numerics::sweep(stiffness_only, Eigen::VectorXcd(load.cast<std::complex<double>>()), {0.0});
  if (solved.singular > 0) throw foundation::NotComputable("static: the stiffness matrix is singular");
  return {solved.response.col(0).real(), solved.backward_error(0)};
}

}  // namespace

RestLoads rest_loads(const model::System& system, const assembly::Assembled& given) {
  const assembly::Assembled &assembled = of_statics(system, given), &first = assembled.first_order();
  const Eigen::VectorXd whole = assembly::static_load(system, first), none = Eigen::VectorXd::Zero(whole.size());
  if (!assembled.without_second_order) return {whole, none};
  if (assembled.hangs_aside || !assembly::holds_all(first.matrices)) return {none, whole};
  const Eigen::VectorXd loads = assembly::constant_load(system, first);
  return {whole - loads, loads};
}

StaticSolution static_solution(const model::System& system, const assembly::Assembled& given) {
  const assembly::Assembled& assembled = of_statics(system, given);
  refuse_without_load(system);
  refuse_without_static_stiffness(system, assembled);
  refuse_free_motions(system, assembled);
  const RestLoads loads = rest_loads(system, assembled);
  const auto [by_weight, error_of_weight] = solution_of(assembled.first_order(), loads.on_first);
  const auto [by_loads, error_of_loads] = solution_of(assembled, loads.on_whole);
  return {by_weight, by_loads, std::max(error_of_weight, error_of_loads)};
}

double value_at_rest(const assembly::Channel& channel, const assembly::Assembled& assembled,
                     const Eigen::VectorXd& motion) {
  double value = channel.on_displacement.real().dot(motion);
  for (const assembly::DynamicForce& force : channel.dynamic_forces) {
    const assembly::ElementMap& map = assembled.elements[force.element];
    value += force.row * (map.matrices.stiffness.topRows<12>() * map.coordinates(motion));
  }
  return value;
}

namespace {

/// row · q of a result.
Eigen::RowVectorXd row_of(const assembly::Channel& channel, const assembly::Assembled& assembled) {
  Eigen::RowVectorXd row = channel.on_displacement.real().head(assembled.matrices.size()).transpose();
  for (const assembly::DynamicForce& force : channel.dynamic_forces) {
    const assembly::ElementMap& map = assembled.elements[force.element];
    const Eigen::RowVectorXd of_element = force.row * map.matrices.stiffness.topRows<12>() * map.ends;
    for (std::size_t j = 0; j < map.rows.size(); ++j) row(map.rows[j]) += of_element(to_index(j));
  }
  return row;
}

std::vector<assembly::Channel> channels_at_rest(const model::System& system, const assembly::Assembled& assembled,
                                                const std::vector<std::string>& of) {
  return assembly::channels(system, assembled, of, assembly::MotionQuantity::displacement);
}

}  // namespace

RestRow rest_row(const model::System& system, const assembly::Assembled& given, const std::string& name) {
  const assembly::Assembled &assembled = of_statics(system, given), &first = assembled.first_order();
  const assembly::Channel by_weight = channels_at_rest(system, first, {name}).front();
  RestRow result{row_of(by_weight, first), {}, by_weight.at_rest};
  if (assembled.without_second_order)
    result.beside = row_of(channels_at_rest(system, assembled, {name}).front(), assembled);
  else result.beside = result.row;
  return result;
}

StaticResponse static_response(const model::System& system, const assembly::Assembled& given,
                               const std::vector<std::string>& of) {
  const assembly::Assembled &assembled = of_statics(system, given), &first = assembled.first_order();
  const StaticSolution rest = static_solution(system, assembled);
  const std::vector<assembly::Channel> by_weight = channels_at_rest(system, first, of);
  std::vector<assembly::Channel> by_loads;  // empty: without second order the weight is all of it
  if (assembled.without_second_order) by_loads = channels_at_rest(system, assembled, of);
  StaticResponse result;
  result.backward_error = rest.backward_error;
  assert((by_loads.empty() || by_weight.size() == by_loads.size()) && "the second order adds no result");
  for (std::size_t i = 0; i < by_weight.size(); ++i) {
    if (by_weight[i].derivative != 0) continue;
    const double beside = by_loads.empty() ? 0.0 : value_at_rest(by_loads[i], assembled, rest.by_loads);
    result.values.push_back({by_weight[i].name, by_weight[i].unit,
                             value_at_rest(by_weight[i], first, rest.by_weight) + beside + by_weight[i].at_rest});
  }
  return result;
}

}  // namespace trivet::response
