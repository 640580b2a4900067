// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/optimization.h"

#include <algorithm>
#include <boost/random/sobol.hpp>
#include <cmath>
#include <iterator>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/study/case_context.h"
#include "trivet/study/design_objective.h"

namespace trivet::study {
namespace {

using numerics::MaxMinPoint;
using numerics::MaxMinProblem;

/// Looks before climbing: so many points of Sobol's sequence per start, within these bounds.
constexpr int looks_per_start = 8, fewest_looks = 64, most_looks = 4096;
/// Optima this near in ln(objective) have the same; if they are also this near in every share of a range, they are one.
constexpr double same_objective = 1e-5, same_place = 1e-3;
/// A requirement within this of the least margin holds the optimum.
constexpr double active_within = 1e-5;

using Place = DesignObjective::Place;

/// The search as asked. @param ignored  a requirement that counts as met
MaxMinProblem problem_of(const DesignObjective& objective, const std::optional<Place>& ignored = std::nullopt) {
  return {to_index(objective.space().size()), objective.is_objective(),
          [&objective, ignored](const Eigen::VectorXd& x, Eigen::VectorXd& values, Eigen::MatrixXd* slopes) {
            objective.evaluate(x, values, slopes, ignored);
          }};
}

/// The largest least margin of the requirements, whatever is minimised.
MaxMinProblem problem_of_requirements(const DesignObjective& objective,
                                      const std::optional<Place>& ignored = std::nullopt) {
  MaxMinProblem problem = problem_of(objective, ignored);
  if (!objective.minimizes()) return problem;
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

constexpr double met_within = -1e-9;  // ln of a margin

/// Violated constraints first count, then the objective.
double rank(const MaxMinPoint& point) {
  constexpr double below_all = -1e3;
  return point.constraint >= met_within ? point.objective : below_all + point.constraint;
}

/// exp of a logarithm that may be cut off.
double whole(double logarithm) {
  return logarithm >= DesignObjective::most ? foundation::infinity : std::exp(logarithm);
}

std::vector<Eigen::VectorXd> sobol_points(Eigen::Index dimensions, int count) {
  boost::random::sobol sequence(static_cast<std::size_t>(dimensions));
  const auto whole = static_cast<double>(boost::random::sobol::max()) + 1;
  std::vector<Eigen::VectorXd> points;
  for (int i = 0; i < count; ++i) {
    Eigen::VectorXd point(dimensions);
    for (double& share : point) share = static_cast<double>(sequence()) / whole;
    points.push_back(std::move(point));
  }
  return points;
}

/// The best looks that lie apart, at most `starts`.
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

std::vector<double> natural_frequencies(const model::System& system) {
  const foundation::Progress silent;
  const CaseContext context(system, silent);
  std::vector<double> result;
  for (const modal::Mode& mode : context.modes.list)
    if (mode.angular_frequency.value_or(0) > 0) result.push_back(*mode.angular_frequency);
  return result;
}

class Search {
 public:
  Search(const project::Project& project, const project::OptimizeRequest& request, const foundation::Progress& progress)
      : project_(project),
        request_(request),
        progress_(progress),
        objective_(project, request),
        problem_(problem_of(objective_)) {}

  Optimization run() {
    const std::vector<MaxMinPoint> chosen = starts();
    std::vector<MaxMinPoint> ends = climbed(problem_, chosen, progress_);
    best_ = nearest_of_the_best(ends);
    if (objective_.minimizes() && best_.constraint < met_within) ends = climbed_to_requirements(chosen);
    refuse_hopeless_search();
    result_.minimizes = objective_.minimizes() && !result_.falls_short;
    leave_idle_parameters_as_given();
    describe_parameters();
    describe_verdicts();
    describe_conditions();
    describe_ends(ends);
    result_.evaluations = objective_.evaluations();
    result_.failed = objective_.failed();
    result_.first_failure = objective_.first_failure();
    result_.differenced = objective_.differenced();
    return std::move(result_);
  }

 private:
  /// No climb met the requirements: climbs to their largest least margin, and from there again if it meets them.
  std::vector<MaxMinPoint> climbed_to_requirements(const std::vector<MaxMinPoint>& chosen) {
    const MaxMinProblem requirements = problem_of_requirements(objective_);
    std::vector<MaxMinPoint> from;
    for (const MaxMinPoint& start : chosen) from.push_back(numerics::point_at(requirements, start.x));
    std::vector<MaxMinPoint> ends = climbed(requirements, from, progress_);
    std::vector<MaxMinPoint> meeting;
    std::copy_if(ends.begin(), ends.end(), std::back_inserter(meeting),
                 [](const MaxMinPoint& end) { return end.objective >= met_within; });
    if (meeting.empty()) {
      problem_ = requirements;
      result_.falls_short = true;
    } else {
      ends = climbed(problem_, meeting, progress_);
    }
    best_ = nearest_of_the_best(ends);
    return ends;
  }

  std::vector<MaxMinPoint> starts() {
    const int looks = std::clamp(looks_per_start * request_.starts, fewest_looks, most_looks);
    std::vector<Eigen::VectorXd> points = sobol_points(problem_.variables, looks);
    Eigen::VectorXd given(problem_.variables);
    bool inside = true;
    for (std::size_t j = 0; j < objective_.space().size(); ++j) {
      const auto& value = objective_.space().given()[j];
      given(to_index(j)) = value ? objective_.space().axes()[j].share(*value) : -1;
      inside = inside && given(to_index(j)) >= 0 && given(to_index(j)) <= 1;
    }
    std::vector<MaxMinPoint> seen(points.size());
    foundation::parallel_for(points.size(), {.progress = progress_, .task = "looking"},
                             [&](std::size_t first, std::size_t last) {
                               for (std::size_t i = first; i < last; ++i)
                                 seen[i] = numerics::point_at(problem_, points[i]);
                             });
    std::vector<MaxMinPoint> chosen = chosen_starts(std::move(seen), to_size(request_.starts));
    if (inside) chosen.push_back(numerics::point_at(problem_, given));
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
    if (objective_.minimizes() && !result_.falls_short && best_.objective >= DesignObjective::most)
      throw foundation::NotComputable("optimize: the minimised results are zero in every design looked at");
    if (best_.objective > DesignObjective::unusable) return;
    if (!objective_.first_failure().empty())
      throw foundation::NotComputable("optimize: no design of the ranges can be computed: " +
                                      objective_.first_failure());
    Eigen::VectorXd values;
    problem_.evaluate(best_.x, values, nullptr);
    Eigen::Index least = 0;
    values.minCoeff(&least);
    const Place& place = objective_.places()[to_size(least)];
    if (objective_.is_objective(place.result))
      throw foundation::NotComputable("optimize: " + objective_.words(place) +
                                      " is unbounded in every design looked at: an undamped resonance lies in the "
                                      "band; add damping, or change the band");
    throw foundation::NotComputable("optimize: the margin of \"" + objective_.words(place) +
                                    "\" is 0 in every design looked at; widen the ranges, or change the requirement");
  }

  /// What changes nothing at the optimum keeps its given value, if the objective does.
  void leave_idle_parameters_as_given() {
    idle_.assign(objective_.space().size(), false);
    if (best_.objective >= DesignObjective::most) return;
    Eigen::VectorXd values;
    Eigen::MatrixXd slopes;
    problem_.evaluate(best_.x, values, &slopes);
    if (values.minCoeff() <= DesignObjective::unusable) {
      result_.no_slopes = objective_.first_failure().empty() ? "a margin is 0 there" : objective_.first_failure();
      return;
    }
    MaxMinPoint kept = best_;
    constexpr double no_slope = 1e-9;  // of ln(margin) over the whole range
    for (std::size_t j = 0; j < idle_.size(); ++j) {
      idle_[j] = slopes.col(to_index(j)).isZero(no_slope);
      if (const auto& value = objective_.space().given()[j]; value && idle_[j])
        if (const double share = objective_.space().axes()[j].share(*value); share >= 0 && share <= 1)
          kept.x(to_index(j)) = share;
    }
    if (kept.x == best_.x) return;
    kept = numerics::point_at(problem_, kept.x);
    constexpr double round_off = 1e-12;
    if (rank(kept) >= rank(best_) - round_off) best_ = kept;
  }

  void describe_parameters() {
    const Eigen::VectorXd values = objective_.space().values(best_.x);
    constexpr double at_bound = 1e-9;
    for (std::size_t j = 0; j < objective_.space().size(); ++j) {
      const double share = best_.x(to_index(j));
      result_.parameters.push_back({objective_.space().axes()[j], objective_.space().given()[j], values(to_index(j)),
                                    values(to_index(j)), values(to_index(j)),
                                    share <= at_bound || share >= 1 - at_bound, idle_[j]});
    }
  }

  void describe_verdicts() {
    const std::vector<std::string> hold_in = project_.base().analyses.requirements
        ? project_.base().analyses.requirements->hold_in
        : project::Requirements().hold_in;
    const Eigen::VectorXd values = objective_.space().values(best_.x);
    for (const project::Case* variant : objective_.cases()) {
      project::Case optimum = *variant;
      optimum.system = objective_.space().system(*variant, values);
      const foundation::Progress silent;
      result_.before.push_back(case_verdict(*variant, hold_in, silent));
      result_.after.push_back(case_verdict(optimum, hold_in, silent));
      result_.frequencies_before.push_back(natural_frequencies(variant->system));
      result_.frequencies_after.push_back(natural_frequencies(optimum.system));
    }
    result_.feasible =
        std::all_of(result_.after.begin(), result_.after.end(), [](const CaseVerdict& judged) { return judged.met(); });
    for (std::size_t c = 0; c < objective_.cases().size(); ++c)
      at_best_.push_back(objective_.results(c, objective_.space().system(*objective_.cases()[c], values)));
    result_.objective_before = objective_of(objective_.given());
    result_.objective_after = objective_of(at_best_).value_or(0);
    for (std::size_t c = 0; c < at_best_.size(); ++c)
      for (std::size_t r = 0; r < at_best_[c].size(); ++r) {
        if (!objective_.is_objective(r)) continue;
        const RequirementResult &before = objective_.given()[c][r], &after = at_best_[c][r];
        const auto limit = objective_.has_limits() ? std::optional(after.allowed) : std::nullopt;
        result_.minimized.push_back(
            {c, after.subject, after.unit, limit, before.value.value_or(0), after.value.value_or(0)});
        if (!limit && result_.minimizes) result_.objective_unit = after.unit;
      }
  }

  /// The least margin, or the largest minimised amplitude, or share of its limit.
  [[nodiscard]] std::optional<double> objective_of(const std::vector<std::vector<RequirementResult>>& found) const {
    double least = foundation::infinity;
    for (const std::vector<RequirementResult>& results : found)
      for (std::size_t r = 0; r < results.size(); ++r) {
        if (objective_.is_objective(r) != result_.minimizes) continue;
        if (!results[r].value) return std::nullopt;
        least = std::min(least, results[r].margin);
      }
    return result_.minimizes ? 1 / least : least;
  }

  /// d ln(margin)/d ln(bound): 1 but for peaks above their tolerance a, with the margin (1 + a)/(1 + p).
  [[nodiscard]] static double effect_of_bound(const RequirementResult& result) {
    return result.kind == RequirementKind::no_peak && result.margin < 1 ? result.allowed / (1 + result.allowed) : 1;
  }

  void describe_conditions() {
    if (best_.objective >= DesignObjective::most || !result_.no_slopes.empty()) return;  // nothing holds it
    const numerics::Multipliers found = numerics::multipliers(problem_, best_, active_within);
    result_.residual = found.residual;
    struct Held {
      Place place;
      double multiplier;
    };
    std::vector<Held> held;
    for (std::size_t i = 0; i < objective_.places().size(); ++i) {
      const double multiplier = found.of_values(to_index(i));
      constexpr double some = 1e-6;
      if (multiplier <= some) continue;
      const Place& place = objective_.places()[i];
      const auto same = std::find_if(held.begin(), held.end(), [&](const Held& one) {
        return one.place.result_case == place.result_case && one.place.result == place.result;
      });
      if (same != held.end()) same->multiplier += multiplier;
      else held.push_back({place, multiplier});
    }
    std::stable_sort(held.begin(), held.end(),
                     [](const Held& a, const Held& b) { return a.multiplier > b.multiplier; });
    for (const Held& one : held) {
      const RequirementResult& result = at_best_[one.place.result_case][one.place.result];
      result_.active.push_back({one.place.result_case, objective_.words(one.place),
                                objective_.is_objective(one.place.result), one.multiplier * effect_of_bound(result)});
      if (!result_.feasible && !result_.minimizes) describe_conflict(one.place, result);
    }
  }

  /// Without a requirement that holds the optimum: what the others reach.
  void describe_conflict(const Place& place, const RequirementResult& result) {
    const MaxMinPoint others = max_min(problem_of_requirements(objective_, place), best_.x);
    const double factor = result.kind == RequirementKind::no_peak ? *result.value / result.allowed : 1 / result.margin;
    result_.conflicts.push_back({place.result_case, objective_.words(place), factor, whole(others.objective)});
  }

  void describe_ends(const std::vector<MaxMinPoint>& ends) {
    struct Top {
      MaxMinPoint point;
      int starts;
    };
    std::vector<Top> places;
    for (const MaxMinPoint& end : ends) {
      if (end.objective <= DesignObjective::unusable) {
        ++result_.stuck;
        continue;
      }
      if (std::abs(rank(best_) - rank(end)) <= same_objective) {
        ++result_.agreeing;
        const Eigen::VectorXd values = objective_.space().values(end.x);
        for (std::size_t j = 0; j < result_.parameters.size(); ++j) {
          study::OptimizedParameter& p = result_.parameters[j];
          p.least = std::min(p.least, values(to_index(j)));
          p.most = std::max(p.most, values(to_index(j)));
        }
        continue;
      }
      const auto same = std::find_if(places.begin(), places.end(), [&](const Top& place) {
        return std::abs(rank(place.point) - rank(end)) <= same_objective &&
            (place.point.x - end.x).lpNorm<Eigen::Infinity>() <= same_place;
      });
      if (same == places.end()) places.push_back({end, 1});
      else ++same->starts;
    }
    std::stable_sort(places.begin(), places.end(),
                     [](const Top& a, const Top& b) { return rank(a.point) > rank(b.point); });
    constexpr std::size_t shown = 3;
    for (std::size_t i = 0; i < places.size() && i < shown; ++i) {
      const Eigen::VectorXd values = objective_.space().values(places[i].point.x);
      const double least = whole(places[i].point.objective);
      result_.others.push_back(
          {{values.begin(), values.end()}, result_.minimizes ? 1 / least : least, places[i].starts});
    }
  }

  const project::Project& project_;
  const project::OptimizeRequest& request_;
  const foundation::Progress& progress_;
  DesignObjective objective_;
  MaxMinProblem problem_;
  MaxMinPoint best_;
  std::vector<bool> idle_;
  std::vector<std::vector<RequirementResult>> at_best_;  ///< per case
  Optimization result_;
};

}  // namespace

Optimization optimization(const project::Project& project, const foundation::Progress& progress) {
  const project::OptimizeRequest request = project.base().analyses.optimize.value_or(project::OptimizeRequest());
  return Search(project, request, progress).run();
}

}  // namespace trivet::study
