// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/steady/parts_by_delay.h"

#include <algorithm>
#include <cassert>
#include <complex>

#include "trivet/foundation/index.h"

namespace trivet::response {
namespace {

numerics::Load undelayed_load(const numerics::Load& load, double delay) {
  numerics::Load part(load.size());
  for (const numerics::LoadTerm& term : load.terms())
    if (term.delay == delay) part.add({term.power, 0, term.value});
  return part;
}

}  // namespace

assembly::Loading undelayed(const assembly::Loading& loading, double delay) {
  return {undelayed_load(loading.force, delay), undelayed_load(loading.motion, delay)};
}

std::vector<double> delays_of(const assembly::Loading& loading) {
  std::vector<double> delays;
  for (const numerics::Load* load : {&loading.force, &loading.motion})
    for (const numerics::LoadTerm& term : load->terms()) delays.push_back(term.delay);
  if (delays.empty()) delays.push_back(0);
  std::ranges::sort(delays);
  delays.erase(std::ranges::unique(delays).begin(), delays.end());
  return delays;
}

Eigen::VectorXcd summed(const Eigen::VectorXcd& parts, const std::vector<double>& delays, double omega) {
  assert(!delays.empty() && parts.size() % std::ssize(delays) == 0 && "all curves by the first delay, then the next");
  const Eigen::Index curves = parts.size() / std::ssize(delays);
  Eigen::VectorXcd sum = Eigen::VectorXcd::Zero(curves);
  for (std::size_t d = 0; d < delays.size(); ++d)
    sum += std::polar(1.0, -omega * delays[d]) * parts.segment(to_index(d) * curves, curves);
  return sum;
}

}  // namespace trivet::response
