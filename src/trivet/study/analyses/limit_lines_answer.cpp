// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/invalid_input.h"
#include "trivet/study/analyses/case_context.h"

namespace trivet::study {

assembly::MotionQuantity quantity_of(const assembly::LimitLine& line) {
  if (line.unit == "m/s" || line.unit == "rad/s") return assembly::MotionQuantity::velocity;
  if (line.unit == "m/s²" || line.unit == "rad/s²") return assembly::MotionQuantity::acceleration;
  return assembly::MotionQuantity::displacement;
}

std::vector<LimitLineResult> limit_line_answer(const CaseContext& c,
                                               const std::vector<project::LimitLineRequest>& requests,
                                               const project::AnswerSelection& selection, const assembly::Band& band) {
  const assembly::Loading loading = assembly::harmonic_loading(c.system, c.assembled, selection.excitations);
  std::vector<LimitLineResult> results;
  for (const project::LimitLineRequest& request : requests) {
    const std::vector<assembly::Channel> channel =
        assembly::channels(c.system, c.assembled, {request.of}, quantity_of(request.line));
    const response::Peaks peaks =
        response::peaks(c.assembled, channel, loading, c.modes, c.roots(), {.search_to = band.to}, c.progress);
    results.push_back({request.of, request.line,
                       response::compared_with_limit(c.assembled, channel.front(), loading, c.roots().poles, peaks,
                                                     request.line, band, c.progress)});
  }
  return results;
}

}  // namespace trivet::study
