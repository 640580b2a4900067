// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/requirements/amplification.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/modal/motion_words.h"
#include "trivet/project/analyses/analysis_types.h"
#include "trivet/response/machinery/transmissibility.h"
#include "trivet/study/analyses/analysis_results.h"
#include "trivet/study/requirements/requirement_values.h"

namespace trivet::study {
namespace {

/// What is transmitted where the machine runs, still without a value.
struct Operation {
  std::string words;  ///< "run", or a place that the ground moves
  RequirementResult requirement;
};

bool is_operating_band(const std::optional<assembly::Band>& band) {
  constexpr double widest = 2;
  return band && band->from > 0 && band->to <= widest * band->from;
}

/// A harmonic force, over each axis of its ellipse.
void add_force(const CaseContext& c, const std::string& force, const assembly::Band& band,
               std::vector<Operation>& result) {
  if (!model::reason_without_transmission(c.system, force).empty()) return;
  const std::size_t count = response::excitation_transmission(c.system, c.assembled, force).directions.size();
  for (std::size_t i = 0; i < count; ++i) {
    RequirementResult& requirement = result.emplace_back(Operation{foundation::quoted(force), {}}).requirement;
    requirement.band = band;
    requirement.transmitted = {force, "", {}, i};
    requirement.allowed = 1;
  }
}

void add_analysis(const CaseContext& c, const project::TransmissibilityAnalysis& request, const assembly::Band& band,
                  std::vector<Operation>& result) {
  if (!request.force.empty()) return add_force(c, request.force, band, result);
  for (const std::string& place : request.selection.of) {
    RequirementResult& requirement = result.emplace_back(Operation{"the motion of the ground", {}}).requirement;
    requirement.band = band;
    requirement.transmitted = {"", place, request.direction, 0};
    requirement.allowed = 1;
  }
}

std::vector<Operation> operations(const CaseContext& c, const project::Analyses& analyses) {
  std::vector<Operation> result;
  const auto& analysis = analyses.transmissibility;
  if (analysis && is_operating_band(analysis->band)) add_analysis(c, *analysis, *analysis->band, result);
  const project::Requirements required = analyses.requirements.value_or(project::Requirements());
  for (const model::Excitation& excitation : c.system.description().excitations) {
    if (!excitation.action.body || !std::holds_alternative<model::Harmonic>(excitation.course)) continue;
    if (const double speed = excitation.service_speed; speed > 0) add_force(c, excitation.name, {speed, speed}, result);
    else if (is_operating_band(required.band) && model::is_selected(excitation, required.excitations))
      add_force(c, excitation.name, *required.band, result);
  }
  return result;
}

/// Operations with their transmissibilities; those that the model does not have are left out.
std::vector<Operation> judged_operations(const CaseContext& c, const project::Analyses& analyses) {
  std::vector<Operation> result = operations(c, analyses);
  std::erase_if(result, [&](Operation& one) {
    try {
      judge_transmitted(c, one.requirement);
      return false;
    } catch (const foundation::NotComputable&) {
      return true;
    } catch (const foundation::InvalidInput&) {
      return true;
    }
  });
  return result;
}

/// A direction as a project file has it.
std::string direction_in_file(const Eigen::Vector3d& axis) {
  for (int i = 0; i < 3; ++i)
    if (axis.cwiseAbs() == Eigen::Vector3d::Unit(i)) return fmt::format("\"{}{}\"", axis(i) < 0 ? "-" : "", "xyz"[i]);
  return fmt::format("[{:.6g}, {:.6g}, {:.6g}]", axis(0), axis(1), axis(2));
}

/// The requirement that would judge this operation.
std::string missing_requirement(const RequirementResult::Transmitted& transmitted, double hertz) {
  std::string of_motion;  // without a base, forces are isolated
  if (transmitted.force.empty())
    of_motion = fmt::format("base = {}, {}of = [{}], ", direction_in_file(transmitted.base.axis),
                            transmitted.base.rotation ? "rotation = true, " : "", foundation::quoted(transmitted.of));
  return fmt::format("add isolation = {{{}at = \"{:.5g} Hz\", least = \"80 %\"}} to [requirements]", of_motion, hertz);
}

/// A requirement on the isolation, or on forces on the ground.
bool speaks_of_the_ground(const project::Analyses& analyses) {
  const auto is_of_ground = [](const auto& limit) { return limit.name.starts_with("ground."); };
  if (std::ranges::any_of(analyses.limits, is_of_ground)) return true;
  if (!analyses.requirements) return false;
  const auto& limits = analyses.requirements->limits;
  return !analyses.requirements->isolation.empty() || std::ranges::any_of(limits, is_of_ground);
}

}  // namespace

std::optional<double> operating_transmissibility(const CaseContext& c, const project::Analyses& analyses,
                                                 const std::vector<RequirementResult>& judged) {
  if (const auto& requirement = analyses.transmissibility) return largest_transmissibility(c, *requirement);
  std::optional<double> largest;
  const auto consider = [&](const RequirementResult& one) {
    if (one.value) largest = std::max(largest.value_or(0), *one.value);
  };
  for (const RequirementResult& one : judged)
    if (one.kind == RequirementKind::isolation) consider(one);
  if (!largest)
    for (const Operation& one : judged_operations(c, analyses)) consider(one.requirement);
  return largest;
}

std::string operating_transmissibility_words(const project::Analyses& analyses) {
  if (const auto& request = analyses.transmissibility) {
    const auto& [axis, rotation] = request->direction;
    const std::string quantity = request->force.empty()
        ? fmt::format("motion{} over a {} of the ground {} {}",
                      request->selection.of.empty() ? "" : " of " + request->selection.of.front(),
                      rotation ? "rotation" : "motion", rotation ? "about" : "along", modal::direction_words(axis))
        : "force on the ground over " + foundation::quoted(request->force);
    const std::string band = request->band
        ? fmt::format("{:.5g} … {:.5g} Hz", request->band->from / foundation::two_pi,
                      request->band->to / foundation::two_pi)
        : "over all natural frequencies of each design: [analyses] transmissibility has no band";
    return fmt::format("largest {}, {}", quantity, band);
  }
  if (analyses.requirements && !analyses.requirements->isolation.empty())
    return "largest transmissibility of the required isolations, where they are required";
  return "largest transmissibility of an excitation where the machine runs";
}

foundation::Problems amplification_warnings(const CaseContext& c, const project::Analyses& analyses) {
  foundation::Problems warnings;
  if (speaks_of_the_ground(analyses) || is_too_large_for_roots(c.assembled)) return warnings;
  std::vector<Operation> all = judged_operations(c, analyses);
  std::ranges::stable_sort(
      all, [](const Operation& a, const Operation& b) { return *a.requirement.value > *b.requirement.value; });
  std::vector<std::string> named;
  for (const Operation& one : all) {
    constexpr double round_off = 1e-9;  // a rigid machine transmits 1
    if (!(*one.requirement.value > 1 + round_off) || std::ranges::find(named, one.words) != named.end()) continue;
    named.push_back(one.words);
    const double hertz = one.requirement.angular_frequency.value_or(0) / foundation::two_pi;
    warnings.warning(
        "requirements",
        fmt::format(
            "{} is amplified at {:.5g} Hz, where the machine runs: transmissibility {:.4g}, isolation {:.3g} dB",
            one.words, hertz, *one.requirement.value, response::isolation_level(*one.requirement.value)),
        "these mounts do not isolate it, and no requirement speaks of that",
        missing_requirement(*one.requirement.transmitted, hertz));
  }
  return warnings;
}

}  // namespace trivet::study
