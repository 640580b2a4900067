// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/optimize/design_search.h"

#include <algorithm>

#include "trivet/numerics/search/zeros_and_minima.h"

namespace trivet::study {
namespace {

using numerics::MaxMinPoint;

/// A known point between its neighbours.
struct Bracket {
  MaxMinPoint middle;
  double from = 0, to = 0;
};

/// Points that are no worse than their neighbours, the best first.
std::vector<Bracket> brackets_of(std::vector<MaxMinPoint> known) {
  std::ranges::sort(known, [](const MaxMinPoint& a, const MaxMinPoint& b) { return a.x(0) < b.x(0); });
  known.erase(
      std::ranges::unique(known, [](const MaxMinPoint& a, const MaxMinPoint& b) { return a.x(0) == b.x(0); }).begin(),
      known.end());
  std::vector<Bracket> result;
  for (std::size_t i = 0; i < known.size(); ++i) {
    const bool first = i == 0, last = i + 1 == known.size();
    const double here = rank(known[i]);
    // Of equal neighbours one counts.
    if ((!first && rank(known[i - 1]) >= here) || (!last && rank(known[i + 1]) > here)) continue;
    result.push_back({known[i], first ? known[i].x(0) : known[i - 1].x(0), last ? known[i].x(0) : known[i + 1].x(0)});
  }
  std::ranges::stable_sort(result, [](const Bracket& a, const Bracket& b) { return rank(a.middle) > rank(b.middle); });
  return result;
}

MaxMinPoint refined(const numerics::MaxMinProblem& problem, const Bracket& bracket) {
  constexpr int bits = 12;  // 5e-4 of half a bracket: less than 0.1 % of a range in 16 steps
  MaxMinPoint best = bracket.middle;
  if (!(bracket.from < bracket.to)) return best;
  static_cast<void>(numerics::minimum_between(
      bracket.from, bracket.to,
      [&](double share) {
        MaxMinPoint here = numerics::point_at(problem, Eigen::VectorXd::Constant(1, share));
        const double value = rank(here);
        if (value > rank(best)) best = std::move(here);
        return -value;
      },
      bits));
  return best;
}

}  // namespace

std::vector<MaxMinPoint> maxima_on_a_line(const numerics::MaxMinProblem& problem, std::vector<MaxMinPoint> known,
                                          std::size_t most, const FindPoints& find) {
  std::vector<Bracket> brackets = brackets_of(std::move(known));
  brackets.resize(std::min(brackets.size(), most));
  return find(brackets.size(), "refining", [&](std::size_t i) {
    const MaxMinPoint& middle = brackets[i].middle;
    const bool level = middle.objective <= DesignObjective::unusable || rank(middle) >= DesignObjective::unlimited;
    return level ? middle : refined(problem, brackets[i]);
  });
}

}  // namespace trivet::study
