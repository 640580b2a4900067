// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/requirements/requirement_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "trivet/assembly/band_ends.h"
#include "trivet/design/design_rules.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/model/operating_excitation.h"
#include "trivet/response/machinery/operating_loads.h"
#include "trivet/study/analyses/operating_limits.h"
#include "trivet/study/requirements/requirement_list.h"

namespace trivet::study {
namespace {

void set_operating_value(const OperatingLimit& limit, const assembly::Band& speed, RequirementResult& result) {
  if (!limit.refusal.empty()) throw foundation::NotComputable(limit.refusal);
  const OperatingValue& found = limit.value;
  result.value = limit.judged();
  result.margin = design::margin({design::DesignRule::Kind::amplitude, 0, limit.allowed}, limit.judged());
  result.angular_frequency = found.order * found.at;
  if (speed.from < speed.to) result.detail = fmt::format("{:.5g} rpm", found.at * foundation::rpm_per_rad_s);
  if (const std::string remark = limit.remark(); !remark.empty())
    result.detail += (result.detail.empty() ? "" : ", ") + remark;
}

/// The limits with their numbers at the level of the file instead of zero-to-peak.
std::vector<project::AmplitudeLimit> at_their_levels(std::vector<project::AmplitudeLimit> limits) {
  for (project::AmplitudeLimit& limit : limits) limit.amplitude *= project::level_factor(project::level_of(limit));
  return limits;
}

/// Does one of these excitations act at the speeds of the machine? @param names  empty: all
bool runs(const model::System& system, const project::OperationAnalysis& request,
          const std::vector<std::string>& names) {
  const std::vector<std::string>& running = request.selection.excitations;
  return std::ranges::any_of(system.description().excitations, [&](const model::Excitation& one) {
    return model::is_selected(one, names) &&
        (running.empty() ? model::runs_with_machine(one) : model::is_selected(one, running));
  });
}

/// Speeds at which a result is judged; none if it says nothing of speeds.
std::optional<assembly::Band> judged_speeds(const RequirementResult& one) {
  if (one.kind == RequirementKind::operation || one.kind == RequirementKind::band_line) return one.speed;
  if (one.kind != RequirementKind::amplitude && one.kind != RequirementKind::limit_line) return std::nullopt;
  const double order = one.order > 0 ? one.order : 1;  // the curve of an order is judged at its frequencies
  return assembly::Band{one.band.from / order, one.band.to / order};
}

/// The lowest of some speeds at which nothing is judged; none if something is at all of them.
std::optional<double> first_missed(const assembly::Band& speed, std::vector<assembly::Band> judged) {
  using assembly::same_end;
  std::ranges::sort(judged, {}, &assembly::Band::from);
  double missed = speed.from;
  for (const assembly::Band& band : judged) {
    if (band.from > missed * (1 + same_end)) break;
    if (band.to * (1 + same_end) >= speed.to) return std::nullopt;
    missed = std::max(missed, band.to);
  }
  return missed;
}

}  // namespace

bool judges_operation(const project::Analyses& analyses) {
  return analyses.operation && (!analyses.operation->limits.empty() || analyses.operation->has_lines());
}

void add_operation_requirements(const CaseContext& c, const project::Analyses& analyses, RequirementList& list) {
  if (!judges_operation(analyses)) return;
  const project::OperationAnalysis& request = *analyses.operation;
  for (const assembly::Band& speed : request.speeds) {
    const std::size_t of_speed = list.size(), limits = request.limits.size();
    list.add_bounds(c, RequirementKind::operation, at_their_levels(request.limits), "");
    for (std::size_t i = 0; i < limits; ++i) {
      RequirementResult& result = list[of_speed + i];
      result.level_of_limit = project::level_of(request.limits[i]);
      result.words.scope += (speed.from < speed.to ? " over " : " at ") + speed_words(speed);
      result.quantity = request.limits[i].quantity;
      result.excitations = request.selection.excitations;
      result.speed = speed;
    }
    list.attempt(of_speed, [&] {  // a speed that cannot be computed leaves the others judged
      const auto loads = response::operating_loads(c.system, c.assembled, request.selection.excitations);
      if (loads.empty()) throw without_excitation("operation");
      const std::vector<OperatingLimit> judged = operating_limits(c, at_speed(request, speed), loads).front();
      for (std::size_t i = 0; i < limits; ++i)
        list.attempt(std::vector{of_speed + i}, [&] { set_operating_value(judged[i], speed, list[of_speed + i]); });
    });
  }
}

std::vector<RequirementResult> limits_that_miss_speeds(const model::System& system, const project::Analyses& analyses,
                                                       const std::vector<RequirementResult>& judged) {
  std::vector<RequirementResult> missed;
  if (!analyses.operation) return missed;
  for (const assembly::Band& speed : analyses.operation->speeds)
    for (const RequirementResult& limit : judged) {
      const auto is_of_place = [&](const RequirementResult& one) { return one.subject == limit.subject; };
      const bool is_limit = limit.kind == RequirementKind::amplitude || limit.kind == RequirementKind::limit_line;
      if (!is_limit || !runs(system, *analyses.operation, limit.excitations) ||
          std::ranges::any_of(missed, [&](const auto& one) { return is_of_place(one) && one.speed == speed; }))
        continue;
      std::vector<assembly::Band> bands;
      for (const RequirementResult& one : judged)
        if (const auto band = judged_speeds(one);
            band && is_of_place(one) && runs(system, *analyses.operation, one.excitations))
          bands.push_back(*band);
      const std::optional<double> first = first_missed(speed, std::move(bands));
      if (!first) continue;
      const std::string scope = (speed.from < speed.to ? " over " : " at ") + speed_words(speed);
      RequirementResult& one = missed.emplace_back();
      one.kind = RequirementKind::operation;
      one.subject = limit.subject;
      one.words = limit.subject + scope;
      one.quantity = limit.quantity;
      one.speed = speed;
      one.misses_speed = true;
      one.reason =
          fmt::format("no limit holds {} {:.5g} Hz{}: write one in [operation.limits], or let a band contain it",
                      speed.from < speed.to ? "from" : "at this speed,", *first / foundation::two_pi,
                      speed.from < speed.to ? " on" : "");
    }
  return missed;
}

foundation::Problems missed_speed_warnings(const std::vector<RequirementResult>& missed) {
  foundation::Problems warnings;
  for (const RequirementResult& one : missed)
    if (one.misses_speed) warnings.warning(one.words.text(), "not judged", one.reason, "");
  return warnings;
}

foundation::Problems missed_speed_warnings(const CaseContext& context, const project::Analyses& analyses) {
  if (!analyses.operation) return {};
  foundation::Problems ignored;
  return missed_speed_warnings(
      limits_that_miss_speeds(context.system, analyses, requirement_values(context, analyses, ignored)));
}

}  // namespace trivet::study
