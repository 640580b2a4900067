// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/model/element_results.h"

#include "trivet/foundation/index.h"
#include "trivet/results/format/json_parts.h"

namespace trivet::results {
namespace json {

Json end(const project::Case& variant, const model::End& end) {
  const spatial::Pose in_ground = model::end_in_ground(variant.system.bodies(), end);
  return {{"on", end.body ? Json(variant.system.bodies()[*end.body].name) : Json("ground")},
          {"at", json::list(end.at)},
          {"in_ground", json::list(in_ground.position)},
          {"axes_in_ground", json::rows(in_ground.rotation)}};
}

}  // namespace json
namespace {

using json::Json;

Json stiffness_properties_json(const elements::StiffnessProperties& c) {
  return {{"principal_stiffnesses", json::list(c.principal_stiffnesses)},
          {"principal_axes", json::rows(c.principal_axes.transpose())},
          {"elastic_center_from_k", json::list(c.elastic_centre)},
          {"elastic_center_is_unique", c.centre_is_unique},
          {"principal_rotational_stiffnesses", json::list(c.principal_rotational_stiffnesses)},
          {"principal_rotational_axes", json::rows(c.principal_rotational_axes.transpose())},
          {"coupling_at_k", json::number(c.coupling_at_k)},
          {"coupling_at_elastic_center", json::number(c.coupling_at_centre)},
          {"softest_combination", json::number(c.softest_combination)},
          {"stiffest_combination", json::number(c.stiffest_combination)}};
}

Json modes_json(const study::ElementSummary& summary) {
  Json result = Json::array();
  for (const study::ElementInMode& mode : summary.modes)
    result.push_back({{"mode", mode.number},
                      {"strain_energy_share", json::number(mode.share)},
                      {"translation", json::number(mode.inside.translation)},
                      {"rotation", json::number(mode.inside.rotation)},
                      {"coupling", json::number(mode.inside.coupling)}});
  return result;
}

Json laws_json(const study::ElementSummary& summary) {
  Json result = Json::array();
  for (const study::ElementLaws& laws : summary.laws) {
    Json loops = Json::array();
    for (const nonlinear::LawLoop& loop : laws.loops)
      loops.push_back({{"amplitude", loop.amplitude},
                       {"storage", loop.storage},
                       {"loss", loop.loss},
                       {"energy", loop.energy},
                       {"deflections", loop.deflections},
                       {"forces", loop.forces}});
    result.push_back(
        {{"axis", laws.axis}, {"at_rest", laws.at_rest}, {"has_dampers", laws.damped}, {"loops", std::move(loops)}});
  }
  return result;
}

Json over_amplitude_json(const study::ElementSummary& summary) {
  Json result = Json::array();
  for (const nonlinear::AmplitudeStiffness& one : summary.over_amplitude)
    result.push_back({{"amplitude", one.amplitude},
                      {"angular_frequency", one.angular_frequency},
                      {"stiffness", json::list(one.stiffness)},
                      {"ended", one.ended}});
  return result;
}

Json uncertainty_json(const model::Element& element) {
  if (!element.evidence) return nullptr;
  return {{"meaning", element.evidence->meaning},
          {"stiffness", json::rows((element.law.scale * element.evidence->uncertainty).eval())}};
}

Json residuals_json(const model::Element& element) {
  Json result = Json::array();
  if (element.evidence)
    for (const model::Residual& r : element.evidence->residuals)
      result.push_back({{"what", r.what},
                        {"measured", json::number(r.measured)},
                        {"fitted", json::number(r.fitted)},
                        {"standardised", json::number(r.standardised)},
                        {"outlier", r.outlier}});
  return result;
}

Json peak_json(const std::optional<study::HighestPeak>& peak) {
  if (!peak) return nullptr;
  return {{"angular_frequency", json::number(peak->angular_frequency)}, {"amplitude", json::number(peak->amplitude)}};
}

Json simplification_json(const study::Simplification& simple) {
  Json modes = Json::array(), peaks = Json::array();
  for (const study::ModeComparison& mode : simple.modes)
    modes.push_back({{"mode", mode.number},
                     {"name", mode.name},
                     {"angular_frequency", json::optional(mode.full)},
                     {"simplified_angular_frequency", json::optional(mode.simplified)},
                     {"relative_difference", json::optional(study::relative_difference(mode.full, mode.simplified))},
                     {"likeness", json::number(mode.similarity)}});
  for (const study::PeakComparison& peak : simple.peaks)
    peaks.push_back({{"name", peak.name},
                     {"unit", peak.unit},
                     {"peak", peak_json(peak.full)},
                     {"simplified_peak", peak_json(peak.simplified)},
                     {"simplified_vanishes", peak.vanishes}});
  return {{"replaced", simple.replaced},         {"left_out", simple.left_out}, {"modes", std::move(modes)},
          {"free_motions", simple.free_motions}, {"peaks", std::move(peaks)},   {"no_peaks", simple.no_peaks}};
}

}  // namespace

std::string element_json(const project::Case& variant, std::size_t index, const study::ElementSummary& summary,
                         const std::optional<study::Simplification>& simple) {
  const model::Element& element = variant.system.elements()[index];
  const elements::Law& law = element.law;
  Json facts = Json::array();
  for (const model::Fact& fact : element.facts) facts.push_back({{"what", fact.what}, {"value", fact.value}});
  const Json result{
      {"name", element.name},
      {"type", element.type},
      {"n", json::end(variant, element.n)},
      {"k", json::end(variant, element.k)},
      {"facts", std::move(facts)},
      {"stiffness", json::rows(summary.stiffness)},
      {"damping", json::rows(elements::viscous_damping(law))},
      {"loss_factor", elements::loss_factor(law)},
      {"mass", law.inertia ? json::rows(law.inertia->mass) : Json(nullptr)},
      {"internal_angular_frequencies", law.inertia ? json::list(law.inertia->angular_frequencies) : Json::array()},
      {"frequency_dependent", elements::is_frequency_dependent(law)},
      {"massless_up_to", json::number(element.massless_up_to)},
      {"preload", law.preload ? json::list(*law.preload) : Json(nullptr)},
      {"rigid_motion_residual", json::rows(summary.verdict.residual)},
      {"character", stiffness_properties_json(summary.stiffness_properties)},
      {"modes", modes_json(summary)},
      {"laws", laws_json(summary)},
      {"over_amplitude", over_amplitude_json(summary)},
      {"uncertainty", uncertainty_json(element)},
      {"residuals", residuals_json(element)},
      {"simplification", simple ? simplification_json(*simple) : Json(nullptr)},
      {"warnings", json::warnings(summary.warnings)}};
  return json::text(result, 1) + "\n";
}

}  // namespace trivet::results
