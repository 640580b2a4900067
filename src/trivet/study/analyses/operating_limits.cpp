// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/analyses/operating_limits.h"

#include <algorithm>
#include <limits>

#include "trivet/design/design_rules.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/study/analyses/summed_orders.h"

namespace trivet::study {

bool OperatingLimit::met() const { return refusal.empty() && design::meets_limit(judged(), allowed); }

double OperatingLimit::judged() const {
  return refusal.empty() ? value.at_level(level) : std::numeric_limits<double>::quiet_NaN();
}

std::string OperatingLimit::remark() const {
  if (!refusal.empty()) return refusal;
  if (!value.reason.empty()) return value.reason;
  const bool is_bound = value.is_bound && level != project::Level::rms;
  return is_bound ? "an upper bound: not all orders have a common period" : "";
}

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
      OperatingLimit judged{limit.quantity, project::level_of(limit),
                            limit.amplitude * project::level_factor(project::level_of(limit))};
      try {
        judged.value = summed.largest(i, request.speeds[s], project::level_of(limit));
      } catch (const foundation::NotComputable& reason) {
        judged.value = {.name = channels[i].name, .unit = channels[i].unit};
        judged.refusal = reason.what();
      }
      result[s].push_back(std::move(judged));
    }
  }
  return result;
}

}  // namespace trivet::study
