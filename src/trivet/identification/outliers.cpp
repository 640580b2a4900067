// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/identification/outliers.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "trivet/foundation/index.h"
#include "trivet/identification/student_distribution.h"

namespace trivet::identification {
namespace {

/// A reading with nearly full leverage determines a constant alone: no other reading can contradict it.
constexpr double judged_below_leverage = 1 - 1e-6;

Contradiction worst(const Regression& regression, const RegressionFit& fit, double risk) {
  Contradiction found;
  Eigen::VectorXd limits = Eigen::VectorXd::Zero(regression.groups);
  for (int g = 0; g < regression.groups; ++g)
    if (fit.group_freedom(g) >= 2)
      limits(g) = student_quantile(1 - risk / static_cast<double>(fit.residual.size()), fit.group_freedom(g) - 1);
  for (Eigen::Index r = 0; r < fit.residual.size(); ++r) {
    const int group = regression.group[r];
    const double freedom = fit.group_freedom(group) - 1, limit = limits(group);
    if (fit.leverage(r) > judged_below_leverage || limit == 0) continue;
    const double internal = fit.residual(r) / (fit.deviation(r) * std::sqrt(1 - fit.leverage(r)));
    const double left =
        std::max(freedom + 1 - internal * internal, 1e-9 * freedom);  // share of the noise from the others
    const double external = internal * std::sqrt(freedom / left);
    if (std::abs(external) / limit > (found.limit > 0 ? std::abs(found.studentised) / found.limit : 0))
      found = {r, fit.residual(r) / (1 - fit.leverage(r)), external, limit};
  }
  return found;
}

void drop(Regression& regression, Eigen::Index reading) {
  const Eigen::Index left = regression.measured.size() - 1, below = left - reading;
  regression.design.middleRows(reading, below) = regression.design.bottomRows(below).eval();
  regression.measured.segment(reading, below) = regression.measured.tail(below).eval();
  regression.relative_deviation.segment(reading, below) = regression.relative_deviation.tail(below).eval();
  regression.design.conservativeResize(left, Eigen::NoChange);
  regression.measured.conservativeResize(left);
  regression.relative_deviation.conservativeResize(left);
  regression.group.erase(regression.group.begin() + reading);
}

}  // namespace

std::vector<Contradiction> contradictions(Regression regression, double risk) {
  std::vector<Contradiction> found;
  std::vector<Eigen::Index> name(to_size(regression.measured.size()));
  std::iota(name.begin(), name.end(), Eigen::Index{0});
  const std::size_t most = name.size() / 10;
  while (found.size() < most) {
    const RegressionFit current = fit(regression);
    if (current.null_space.cols() > 0) break;
    Contradiction next = worst(regression, current, risk);
    if (next.limit == 0 || std::abs(next.studentised) <= next.limit) break;
    drop(regression, next.reading);
    const Eigen::Index place = next.reading;
    next.reading = name[place];
    name.erase(name.begin() + place);
    found.push_back(next);
  }
  return found;
}

}  // namespace trivet::identification
