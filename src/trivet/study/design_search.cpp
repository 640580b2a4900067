// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/design_search.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/study/design_looks.h"
#include "trivet/study/margin.h"

namespace trivet::study {
namespace {

using numerics::MaxMinPoint;
using numerics::MaxMinProblem;

/// Designs that are judged completely before climbing: so many per start, within these bounds.
constexpr int looks_per_start = 8, fewest_looks = 64, most_looks = 4096;
using Place = DesignObjective::Place;

/// The search as asked. @param ignored  a requirement that counts as met
MaxMinProblem problem_of(const DesignObjective& objective, const std::optional<Place>& ignored = std::nullopt) {
  return {to_index(objective.space().size()), objective.is_objective(),
          [&objective, ignored](const Eigen::VectorXd& x, Eigen::VectorXd& values, Eigen::MatrixXd* slopes) {
            objective.evaluate(x, values, slopes, ignored);
          }};
}

/// The largest −Σ weight × amplitude, in amplitudes at the given design.
MaxMinProblem weighted_problem(const DesignObjective& objective) {
  MaxMinProblem problem = problem_of(objective);
  problem.weights = objective.minimized().weights();
  for (const Place& place : objective.places())
    problem.group.push_back(objective.minimized().contain(place) ? objective.minimized().number(place) : 0);
  problem.evaluate = [&objective, unit = weighted_unit(objective)](const Eigen::VectorXd& x, Eigen::VectorXd& values,
                                                                   Eigen::MatrixXd* slopes) {
    objective.evaluate(x, values, slopes);
    for (std::size_t i = 0; i < objective.places().size(); ++i) {
      if (!objective.is_objective()[i]) continue;
      double& value = values(to_index(i));
      constexpr double far_below = -1e3;
      const double amplitude = value <= DesignObjective::unusable ? -far_below : std::exp(-value) / unit;
      value = std::max(far_below, -amplitude);
      if (slopes) slopes->row(to_index(i)) *= amplitude;
    }
  };
  return problem;
}

/// Climbs from all starts; the results in their order.
std::vector<MaxMinPoint> climbed(const MaxMinProblem& problem, const std::vector<MaxMinPoint>& starts,
                                 const foundation::Progress& progress) {
  std::vector<MaxMinPoint> ends(starts.size());
  foundation::parallel_for(starts.size(), {.progress = progress, .task = "climbing"},
                           [&](std::size_t first, std::size_t last) {
                             for (std::size_t i = first; i < last; ++i) ends[i] = max_min(problem, starts[i].x);
                           });
  return ends;
}

class Search {
 public:
  Search(const DesignObjective& objective, int starts, const foundation::Progress& progress)
      : objective_(objective), wanted_(starts), progress_(progress) {
    result_.problem = search_problem(objective);
  }

  DesignSearch run() {
    const std::vector<MaxMinPoint> chosen = starts();
    result_.ends = climbed(result_.problem, chosen, progress_);
    result_.best = nearest_of_the_best(result_.ends);
    if (objective_.minimized().any() && result_.best.constraint < least_met)
      result_.ends = climbed_to_requirements(chosen);
    refuse_hopeless_search();
    return std::move(result_);
  }

 private:
  /// No climb met the requirements: climbs to their largest least margin, and from there again if it meets them.
  std::vector<MaxMinPoint> climbed_to_requirements(const std::vector<MaxMinPoint>& chosen) {
    const MaxMinProblem requirements = problem_of_requirements(objective_);
    std::vector<MaxMinPoint> ends = climbed(requirements, chosen, progress_);
    std::vector<MaxMinPoint> meeting;
    std::copy_if(ends.begin(), ends.end(), std::back_inserter(meeting),
                 [](const MaxMinPoint& end) { return end.objective >= least_met; });
    if (meeting.empty()) {
      result_.problem = requirements;
      result_.falls_short = true;
    } else {
      ends = climbed(result_.problem, meeting, progress_);
    }
    result_.best = nearest_of_the_best(ends);
    return ends;
  }

  std::vector<MaxMinPoint> starts() {
    const int looks = looks_for(wanted_);
    const DesignLooks found = design_looks(objective_, to_size(looks), progress_);
    const std::vector<Eigen::VectorXd>& points = found.points;
    result_.looked_at = found.judged;
    std::vector<MaxMinPoint> seen(points.size());
    foundation::parallel_for(points.size(), {.progress = progress_, .task = "looking"},
                             [&](std::size_t first, std::size_t last) {
                               for (std::size_t i = first; i < last; ++i)
                                 seen[i] = numerics::point_at(result_.problem, points[i]);
                             });
    std::vector<MaxMinPoint> chosen = chosen_starts(std::move(seen), to_size(wanted_));
    if (const auto given = objective_.space().given_shares())
      chosen.push_back(numerics::point_at(result_.problem, *given));
    result_.starts = static_cast<int>(chosen.size());
    return chosen;
  }

  /// Of equally good ends the one nearest to the given design.
  [[nodiscard]] const MaxMinPoint& nearest_of_the_best(const std::vector<MaxMinPoint>& ends) const {
    const MaxMinPoint* best = &ends.front();
    for (const MaxMinPoint& end : ends)
      if (rank(end) > rank(*best)) best = &end;
    const double highest = rank(*best);
    for (const MaxMinPoint& end : ends)
      if (rank(end) >= highest - same_objective && from_given(end.x) < from_given(best->x)) best = &end;
    return *best;
  }

  [[nodiscard]] double from_given(const Eigen::VectorXd& shares) const {
    double distance = 0;
    for (std::size_t j = 0; j < objective_.space().size(); ++j)
      if (const auto& value = objective_.space().given()[j])
        distance += std::pow(shares(to_index(j)) - objective_.space().axes()[j].share(*value), 2);
    return distance;
  }

  void refuse_hopeless_search() const {
    if (objective_.minimized().any() && !result_.falls_short && result_.best.objective >= DesignObjective::most)
      throw foundation::NotComputable("optimize: the minimised results are zero in every design looked at");
    if (result_.best.objective > DesignObjective::unusable) return;
    if (!objective_.first_failure().empty())
      throw foundation::NotComputable("optimize: no design of the ranges can be computed: " +
                                      objective_.first_failure());
    Eigen::VectorXd values;
    result_.problem.evaluate(result_.best.x, values, nullptr);
    Eigen::Index least = 0;
    values.minCoeff(&least);
    const Place& place = objective_.places()[to_size(least)];
    if (objective_.minimized().contain(place))
      throw foundation::NotComputable("optimize: " + objective_.words(place) +
                                      " is unbounded in every design looked at: an undamped resonance lies in the "
                                      "band; add damping, or change the band");
    throw foundation::NotComputable("optimize: the margin of \"" + objective_.words(place) +
                                    "\" is 0 in every design looked at; widen the ranges, or change the requirement");
  }

  const DesignObjective& objective_;
  int wanted_;
  const foundation::Progress& progress_;
  DesignSearch result_;
};

}  // namespace

MaxMinProblem search_problem(const DesignObjective& objective) {
  return objective.minimized().weights().empty() ? problem_of(objective) : weighted_problem(objective);
}

double reported_objective(const DesignObjective& objective, double of_search) {
  if (!objective.minimized().weights().empty()) return -of_search * weighted_unit(objective);
  const double least = of_search >= DesignObjective::most ? foundation::infinity : std::exp(of_search);
  return objective.minimized().any() ? 1 / least : least;
}

MaxMinProblem problem_of_requirements(const DesignObjective& objective, const std::optional<Place>& ignored) {
  MaxMinProblem problem = problem_of(objective, ignored);
  if (!objective.minimized().any()) return problem;
  problem.is_objective.flip();
  problem.evaluate = [all = problem.evaluate, &objective](const Eigen::VectorXd& x, Eigen::VectorXd& values,
                                                          Eigen::MatrixXd* slopes) {
    all(x, values, slopes);
    for (std::size_t i = 0; i < objective.is_objective().size(); ++i) {
      if (!objective.is_objective()[i]) continue;
      values(to_index(i)) = DesignObjective::most;
      if (slopes) slopes->row(to_index(i)).setZero();
    }
  };
  return problem;
}

std::vector<MaxMinPoint> chosen_starts(std::vector<MaxMinPoint> looks, std::size_t starts) {
  std::stable_sort(looks.begin(), looks.end(),
                   [](const MaxMinPoint& a, const MaxMinPoint& b) { return rank(a) > rank(b); });
  std::vector<MaxMinPoint> chosen;
  for (const double apart : {0.15, 0.05, 0.0})
    for (const MaxMinPoint& look : looks) {
      if (chosen.size() >= starts) return chosen;
      const bool near = std::any_of(chosen.begin(), chosen.end(), [&](const MaxMinPoint& other) {
        return (other.x - look.x).lpNorm<Eigen::Infinity>() <= apart;
      });
      if (!near) chosen.push_back(look);
    }
  return chosen;
}

int looks_for(int starts) { return std::clamp(looks_per_start * starts, fewest_looks, most_looks); }

double weighted_unit(const DesignObjective& objective) {
  const double given = objective.minimized().weighted_sum(objective.given()).value_or(0);
  return std::isfinite(given) && given > 0 ? given : 1;
}

double rank(const MaxMinPoint& point) { return rank(point.objective, point.constraint); }

DesignSearch design_search(const DesignObjective& objective, int starts, const foundation::Progress& progress) {
  return Search(objective, starts, progress).run();
}

}  // namespace trivet::study
