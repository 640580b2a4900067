// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/response/machinery/operating_loads.h"
#include "trivet/study/analyses/band_lines.h"
#include "trivet/study/analyses/operating_levels.h"
#include "trivet/study/analyses/operating_limits.h"
#include "trivet/study/requirements/requirement_list.h"
#include "trivet/study/requirements/requirement_values.h"

namespace trivet::study {
namespace {

void set_share_of_line(const OperatingLine& judged, RequirementResult& result) {
  result.value = judged.share();
  result.margin = judged.margin();
  if (!judged.nearest) {
    const auto& points = judged.line.angular_frequency;
    result.detail = fmt::format("no order in {:.4g} … {:.4g} Hz", points.front() / foundation::two_pi,
                                points.back() / foundation::two_pi);
    return;
  }
  const OperatingLevel& nearest = *judged.nearest;
  result.angular_frequency = read_at(nearest.band, judged.line);
  result.on_line = {nearest.limit, judged.line.unit, true};
  if (judged.speed.from < judged.speed.to)
    result.detail = fmt::format("{:.5g} rpm", nearest.value.at * foundation::rpm_per_rad_s);
  if (const std::string remark = judged.remark(); !remark.empty())
    result.detail += (result.detail.empty() ? "" : ", ") + remark;
}

}  // namespace

void add_operating_line_requirements(const CaseContext& c, const project::Analyses& analyses, RequirementList& list) {
  if (!analyses.operation) return;
  const project::OperationAnalysis& request = *analyses.operation;
  for (const project::LimitLineRequest& line : request.lines) {
    const auto& required = analyses.requirements;
    if (required && std::ranges::find(required->limit_lines, line.line.name) == required->limit_lines.end()) continue;
    for (const assembly::Band& speed : request.speeds) {
      const std::string scope = (speed.from < speed.to ? " over " : " at ") + speed_words(speed);
      RequirementResult& result =
          list.add(RequirementKind::band_line, line.of, {line.of, "within \"" + line.line.name + "\"", scope}, "1", 1);
      result.line = line.line.name;
      result.quantity = quantity_of(line.line);
      result.speed = speed;
      result.excitations = request.selection.excitations;
      const std::size_t place = list.size() - 1;
      list.attempt(place, [&] {
        if (line.bands != request.bands)
          throw foundation::NotComputable(
              fmt::format("[operation] has {} bands, the line {} bands", name(*request.bands), name(*line.bands)));
        const auto loads = response::operating_loads(c.system, c.assembled, request.selection.excitations);
        if (loads.empty()) throw without_excitation("operation");
        project::OperationAnalysis alone = at_speed(request, speed);
        alone.lines = {line};
        set_share_of_line(operating_lines(alone, operating_levels(c, alone, loads, {})).front(), list[place]);
      });
    }
  }
}

}  // namespace trivet::study
