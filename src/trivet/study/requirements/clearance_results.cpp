// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/requirements/requirement_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <variant>

#include "trivet/assembly/loads.h"
#include "trivet/design/design_rules.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/nonlinear/machine/static_machine.h"
#include "trivet/project/analyses/analysis_types.h"
#include "trivet/response/steady/static_response.h"
#include "trivet/study/analyses/analysis_results.h"
#include "trivet/study/explain/explanation.h"
#include "trivet/study/requirements/margin.h"

namespace trivet::study {
namespace {

using assembly::MotionQuantity;

/// How far the places of one clearance approach each other [m]; the parts that were counted.
struct Approach {
  double at_rest = 0;
  std::optional<design::LargestAmplitude> harmonic;
  std::optional<response::Extreme> transient;

  [[nodiscard]] double total() const {
    return at_rest + (harmonic ? harmonic->amplitude : 0) + (transient ? std::max(0.0, transient->value) : 0);
  }
};

std::vector<std::string> approach_names(const model::System& system) {
  std::vector<std::string> names;
  for (const model::Clearance& clearance : system.description().clearances)
    names.push_back(clearance.name + "." + model::approach_component);
  return names;
}

/// The band and the excitations of the requirements, else those of the response, else all.
struct HarmonicScope {
  assembly::Band band{0, foundation::infinity};
  std::vector<std::string> excitations;
};
HarmonicScope harmonic_scope(const project::Analyses& analyses) {
  HarmonicScope scope;
  if (analyses.response) {
    scope.band = analyses.response->band.value_or(scope.band);
    scope.excitations = analyses.response->selection.excitations;
  }
  if (const auto& required = analyses.requirements) {
    scope.band = required->band.value_or(scope.band);
    if (!required->excitations.empty()) scope.excitations = required->excitations;
  }
  return scope;
}

void add_harmonic(const CaseContext& c, const project::Analyses& analyses,
                  const std::vector<assembly::Channel>& channels, std::vector<Approach>& approaches) {
  const HarmonicScope scope = harmonic_scope(analyses);
  const assembly::Loading loading = assembly::harmonic_loading(c.system, c.assembled, scope.excitations);
  if (loading.vanishes()) return;
  const response::Peaks found =
      response::peaks(c.assembled, channels, loading, c.modes, c.roots(),
                      {.search_to = std::isfinite(scope.band.to) ? scope.band.to : 0}, c.progress);
  for (std::size_t i = 0; i < channels.size(); ++i)
    approaches[i].harmonic = design::largest_in_band(c.assembled, channels, loading, found, i, scope.band);
}

void add_transient(const CaseContext& c, const project::Analyses& analyses, std::vector<Approach>& approaches,
                   foundation::Problems& warnings) {
  if (!analyses.transient) return;
  project::TransientAnalysis request = *analyses.transient;
  request.selection.quantity = MotionQuantity::displacement;
  request.selection.of = approach_names(c.system);
  const TransientResult found = transient_result(c, request, warnings);
  for (std::size_t i = 0; i < approaches.size(); ++i) approaches[i].transient = found.response.curves[i].largest;
}

std::vector<Approach> approaches_of(const CaseContext& c, const project::Analyses& analyses,
                                    foundation::Problems& warnings) {
  const std::vector<assembly::Channel> channels =
      assembly::channels(c.system, c.assembled, approach_names(c.system), MotionQuantity::displacement);
  std::vector<Approach> approaches;
  const nonlinear::StaticMachine held = nonlinear::static_machine(c.system, c.assembled);
  for (const response::StaticValue& rest :
       response::static_response(held.system, held.assembled, approach_names(c.system)).values)
    approaches.push_back({rest.value, std::nullopt, std::nullopt});
  add_harmonic(c, analyses, channels, approaches);
  add_transient(c, analyses, approaches, warnings);
  return approaches;
}

bool is_restricted(const assembly::Band& band) { return band.from > 0 || std::isfinite(band.to); }

/// What does not count, in words: "random motion, engine orders".
std::string not_counted(const model::System& system, const project::Analyses& analyses) {
  const HarmonicScope scope = harmonic_scope(analyses);
  bool outside = false, unselected = false, random = false, orders = false, history = false;
  for (const model::Excitation& excitation : system.description().excitations) {
    const bool harmonic = std::holds_alternative<model::Harmonic>(excitation.course),
               selected = model::is_selected(excitation, scope.excitations);
    outside = outside || (harmonic && selected && is_restricted(scope.band));
    unselected = unselected || (harmonic && !selected);
    random = random || std::holds_alternative<model::Random>(excitation.course);
    orders = orders || std::holds_alternative<model::Orders>(excitation.course);
    history = history || std::holds_alternative<model::History>(excitation.course);
  }
  std::string words;
  const auto add = [&](bool there, const char* what) {
    if (there) words += (words.empty() ? "" : ", ") + std::string(what);
  };
  add(outside, "harmonic motion outside of the band");
  add(unselected, "harmonic excitations that are not selected");
  add(random, "random motion");
  add(orders, "engine orders");
  add(history && !analyses.transient, "time histories (no analyses.transient)");
  add(std::ranges::any_of(system.elements(), [](const model::Element& one) { return one.creep > 1; }), "creep");
  return words;
}

/// @param band  of the harmonic motion
std::string parts_words(const Approach& approach, const assembly::Band& band) {
  std::string words = value_words(approach.at_rest, "m") + " at rest";
  if (approach.harmonic)
    words += " + " +
        (std::isinf(approach.harmonic->amplitude) ? "unbounded" : value_words(approach.harmonic->amplitude, "m")) +
        " harmonic" +
        (is_restricted(band)
             ? fmt::format(" over {:.5g} … {:.5g} Hz", band.from / foundation::two_pi, band.to / foundation::two_pi)
             : "");
  if (approach.transient) words += " + " + value_words(std::max(0.0, approach.transient->value), "m") + " transient";
  return words;
}

void judge_approach(const model::Clearance& clearance, const Approach& approach, const assembly::Band& band,
                    const std::string& ignored, RequirementResult& result) {
  const double total = approach.total(), left = clearance.gap - total;
  result.value = total;
  result.margin = total > 0 ? margin_of(clearance.gap, total) : foundation::infinity;
  if (approach.harmonic && std::isfinite(approach.harmonic->angular_frequency) && approach.harmonic->amplitude > 0)
    result.angular_frequency = approach.harmonic->angular_frequency;
  if (approach.transient && approach.transient->value > 0) result.time = approach.transient->time;
  const bool at_rest = approach.at_rest > clearance.gap;
  result.detail = parts_words(approach, band);
  if (at_rest) result.detail += "; closed at rest, overlap " + value_words(approach.at_rest - clearance.gap, "m");
  else if (!result.met() && std::isfinite(left)) result.detail += "; overlap " + value_words(-left, "m");
  else if (!result.met()) result.detail += "; the gap is closed";
  else result.detail += "; " + value_words(left, "m") + " left";
  if (!ignored.empty()) result.detail += "; not counted: " + ignored;
}

}  // namespace

std::vector<RequirementResult> clearance_results(const CaseContext& context, const project::Analyses& analyses,
                                                 foundation::Problems& warnings) {
  const std::vector<model::Clearance>& clearances = context.system.description().clearances;
  if (clearances.empty()) return {};
  std::vector<Approach> approaches;
  std::string reason;
  try {
    approaches = approaches_of(context, analyses, warnings);
  } catch (const foundation::NotComputable& refused) {
    reason = refused.what();
  } catch (const foundation::InvalidInput& refused) {
    reason = refused.what();
  }
  const assembly::Band band = harmonic_scope(analyses).band;
  const std::string ignored = not_counted(context.system, analyses);
  std::vector<RequirementResult> results;
  for (std::size_t i = 0; i < clearances.size(); ++i) {
    RequirementResult& result = results.emplace_back();
    result.kind = RequirementKind::clearance;
    result.subject = clearances[i].name;
    result.words = fmt::format("{} stays open, gap {}", clearances[i].name, value_words(clearances[i].gap, "m"));
    result.unit = "m";
    result.allowed = clearances[i].gap;
    result.reason = reason;
    if (reason.empty()) judge_approach(clearances[i], approaches[i], band, ignored, result);
  }
  return results;
}

}  // namespace trivet::study
