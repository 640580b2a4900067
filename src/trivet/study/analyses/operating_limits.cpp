// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/analyses/operating_limits.h"

#include <algorithm>

#include "trivet/design/design_rules.h"
#include "trivet/study/analyses/summed_orders.h"

namespace trivet::study {

bool OperatingLimit::met() const { return design::meets_limit(judged(), allowed); }

project::OperationAnalysis at_speed(project::OperationAnalysis request, const assembly::Band& speed) {
  request.speeds = {speed};
  return request;
}

double fastest_range(const std::vector<assembly::Band>& speeds) {
  double fastest = 0;
  for (const assembly::Band& speed : speeds)
    if (speed.from < speed.to) fastest = std::max(fastest, speed.to);
  return fastest;
}

std::vector<std::vector<OperatingLimit>> operating_limits(const CaseContext& context,
                                                          const project::OperationAnalysis& request,
                                                          const std::vector<response::OrderLoading>& loads) {
  std::vector<std::vector<OperatingLimit>> result(request.speeds.size());
  if (request.limits.empty()) return result;
  std::vector<assembly::Channel> channels;
  for (const project::AmplitudeLimit& limit : request.limits)
    channels.push_back(assembly::channels(context.system, context.assembled, {limit.name}, limit.quantity).front());
  const SummedOrders summed(context, channels, loads, fastest_range(request.speeds));
  for (std::size_t s = 0; s < request.speeds.size(); ++s) {
    for (std::size_t i = 0; i < request.limits.size(); ++i) {
      const project::AmplitudeLimit& limit = request.limits[i];
      result[s].push_back({limit.quantity, limit.level, limit.amplitude * project::level_factor(limit.level),
                           summed.largest(i, request.speeds[s], limit.level)});
    }
  }
  return result;
}

}  // namespace trivet::study
