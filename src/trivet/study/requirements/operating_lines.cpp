// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "trivet/foundation/constants.h"
#include "trivet/response/machinery/operating_loads.h"
#include "trivet/study/analyses/band_lines.h"
#include "trivet/study/analyses/operating_levels.h"
#include "trivet/study/requirements/requirement_list.h"
#include "trivet/study/requirements/requirement_values.h"

namespace trivet::study {
namespace {

/// The levels of one line alone at one speed; the share of the line is largest where the margin is least.
void set_share_of_line(const std::vector<OperatingLevel>& levels, const project::LimitLineRequest& line,
                       RequirementResult& result) {
  const OperatingLevel* governing = nullptr;
  for (const OperatingLevel& level : levels)
    if (!level.line.empty() && (!governing || level.share() > governing->share())) governing = &level;
  result.value = governing ? governing->share() : 0;
  result.margin = *result.value > 0 ? 1 / *result.value : foundation::infinity;
  if (!governing) {
    const auto& points = line.line.angular_frequency;
    result.detail = fmt::format("no order in {:.4g} … {:.4g} Hz", points.front() / foundation::two_pi,
                                points.back() / foundation::two_pi);
    return;
  }
  result.angular_frequency = read_at(governing->band, line.line);
  result.on_line = {governing->limit, line.line.unit, true};
  if (governing->speed.from < governing->speed.to)
    result.detail = fmt::format("{:.5g} rpm", governing->value.at * foundation::rpm_per_rad_s);
}

}  // namespace

void add_operating_line_requirements(const CaseContext& c, const project::Analyses& analyses, RequirementList& list) {
  if (!analyses.operation || !analyses.operation->has_lines()) return;
  const project::OperationAnalysis& request = *analyses.operation;
  for (const project::LimitLineRequest& line : request.lines) {
    const auto& required = analyses.requirements;
    if (line.bands != request.bands ||
        (required && std::ranges::find(required->limit_lines, line.line.name) == required->limit_lines.end()))
      continue;
    const std::size_t first = list.size();
    for (const assembly::Band& speed : request.speeds) {
      RequirementResult& result = list.add(RequirementKind::band_line, line.of,
                                           fmt::format("{} within \"{}\" {} {}", line.of, line.line.name,
                                                       speed.from < speed.to ? "over" : "at", speed_words(speed)),
                                           "1", 1);
      result.line = line.line.name;
      result.quantity = quantity_of(line.line);
      result.excitations = request.selection.excitations;
    }
    list.attempt(first, [&] {
      const auto loads = response::operating_loads(c.system, c.assembled, request.selection.excitations);
      if (loads.empty()) throw without_excitation("operation");
      project::OperationAnalysis alone = request;
      alone.lines = {line};
      for (std::size_t s = 0; s < request.speeds.size(); ++s) {
        alone.speeds = {request.speeds[s]};
        set_share_of_line(operating_levels(c, alone, loads, {}), line, list[first + s]);
      }
    });
  }
}

}  // namespace trivet::study
