// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/optimize/design_search.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/study/optimize/search_watch.h"
#include "trivet/study/requirements/margin.h"

namespace trivet::study {
namespace {

using numerics::MaxMinPoint;
using numerics::MaxMinProblem;

/// Designs that are judged completely before climbing: so many per start, within these bounds.
constexpr int looks_per_start = 8, fewest_looks = 64, most_looks = 4096;
/// Climbs over designs that are judged by following branches of motions, if the file states no number.
constexpr int starts_of_expensive_designs = 4;
using Place = DesignObjective::Place;

constexpr std::string_view climbing = "climbing";

/// The search as requested. @param ignored  a requirement that counts as met
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

class Search {
 public:
  Search(const DesignObjective& objective, const SearchOptions& options, const foundation::Progress& progress)
      : objective_(objective),
        searched_(objective.quick() ? *objective.quick() : objective),
        options_(options),
        wanted_(
            options.starts.value_or(objective.is_expensive() ? starts_of_expensive_designs : project::usual_starts)),
        progress_(progress),
        watch_(options.enough) {
    result_.problem = search_problem(objective);
  }

  DesignSearch run() {
    try {
      search();
    } catch (const foundation::Interrupted&) {
      if (!watch_.has_ended()) throw;
      keep_the_best_so_far();
    }
    refuse_hopeless_search();
    return std::move(result_);
  }

 private:
  void search() {
    problem_ = watch_.over(search_problem(searched_));
    const std::vector<MaxMinPoint> chosen = starts();
    const bool on_a_line = objective_.is_expensive() && objective_.space().size() == 1;
    result_.ends = on_a_line ? best_on_the_line(chosen) : climbed(chosen);
    result_.best = nearest_of_the_best(result_.ends);
    if (objective_.minimized().any() && result_.best.constraint < least_met)
      result_.ends = climbed_to_requirements(chosen, on_a_line);
    if (&searched_ != &objective_) judge_completely(on_a_line);
    if (few_agree()) search_between();
  }

  /// Few starts reached the best end: then better ones may be left between them.
  [[nodiscard]] bool few_agree() const {
    constexpr std::size_t fewest_numbers = 4, one_in = 8;
    if (objective_.is_expensive() || objective_.space().size() < fewest_numbers || result_.falls_short) return false;
    const auto agreeing = std::ranges::count_if(
        result_.ends, [&](const MaxMinPoint& end) { return rank(end) >= rank(result_.best) - same_objective; });
    return to_size(agreeing) * one_in < result_.ends.size() && rank(result_.best) < DesignObjective::most;
  }

  /// A population of the ends and of looks evolves through the families; climbs start from its best designs.
  void search_between() {
    if (!can_evolve(objective_)) return;
    constexpr std::size_t per_number = 10, fewest = 60, most = 160, further_climbs = 4;
    const std::size_t wanted = std::clamp(per_number * objective_.space().size(), fewest, most);
    std::vector<Eigen::VectorXd> first;
    for (const MaxMinPoint& end : result_.ends)
      if (first.size() < wanted / 2) first.push_back(end.x);
    for (const MaxMinPoint& look : looks_)
      if (first.size() < wanted) first.push_back(look.x);
    const Eigen::MatrixXd others = sobol_points(to_index(objective_.space().size()), wanted);
    for (Eigen::Index i = 0; first.size() < wanted; ++i) first.emplace_back(others.row(i).transpose());
    std::vector<MaxMinPoint> starts;
    for (const Eigen::VectorXd& one : evolved_designs(objective_, first, further_climbs, progress_))
      starts.push_back(numerics::point_at(problem_, one));
    const std::vector<MaxMinPoint> further = climbed(starts);
    result_.ends.insert(result_.ends.end(), further.begin(), further.end());
    result_.starts = static_cast<int>(result_.ends.size());
    result_.best = nearest_of_the_best(result_.ends);
  }

  /// Climbs from all starts; the results in their order.
  std::vector<MaxMinPoint> climbed(const std::vector<MaxMinPoint>& starts) {
    return found(starts.size(), climbing, [&](std::size_t i) {
      MaxMinPoint end = can_climb(starts[i]) ? max_min(problem_, starts[i].x) : starts[i];
      ++finished_;
      return end;
    });
  }

  /// A point of each item, which this process or another one that shares the search finds.
  std::vector<MaxMinPoint> found(std::size_t count, std::string_view task,
                                 const std::function<MaxMinPoint(std::size_t)>& find) {
    std::vector<MaxMinPoint> points(count);
    const foundation::ParallelOptions options{.progress = progress_, .task = task};
    if (!options_.shared) {
      foundation::parallel_for(count, options, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) points[i] = find(i);
      });
      return points;
    }
    std::vector<char> is_own(count);
    const auto restored = [&](const std::string& text) { return CountedPoint::restored(text, problem_.variables); };
    const std::vector<std::string> texts = options_.shared->results(
        count, options,
        [&](std::size_t i) {
          const CountedHere here;
          is_own[i] = 1;
          MaxMinPoint point = find(i);
          return CountedPoint{std::move(point), here.counts()}.text();
        },
        [&](std::size_t, const std::string& text) {  // known also to a search that is ended within the loop
          watch_.note(restored(text).point);
          if (task == climbing) ++finished_;
        });
    for (std::size_t i = 0; i < count; ++i) {
      CountedPoint one = restored(texts[i]);
      if (!is_own[i]) judged_by_->add(one.counts);
      points[i] = std::move(one.point);
    }
    return points;
  }

  /// Nothing limits the design, or nothing that limits it has a slope.
  [[nodiscard]] bool can_climb(const MaxMinPoint& start) const {
    return !objective_.is_expensive() ||
        (start.objective > DesignObjective::unusable && start.objective < DesignObjective::unlimited);
  }

  /// No climb met the requirements: climbs to their largest least margin, and from there again if it meets them.
  std::vector<MaxMinPoint> climbed_to_requirements(const std::vector<MaxMinPoint>& chosen, bool on_a_line) {
    problem_ = watch_.over(problem_of_requirements(searched_));
    finished_ = 0;
    std::vector<MaxMinPoint> ends = on_a_line ? best_on_the_line(chosen) : climbed(at(chosen));
    std::vector<MaxMinPoint> meeting;
    std::ranges::copy_if(ends, std::back_inserter(meeting),
                         [](const MaxMinPoint& end) { return end.objective >= least_met; });
    if (meeting.empty()) {
      result_.problem = problem_of_requirements(objective_);
      result_.falls_short = true;
    } else {
      problem_ = watch_.over(search_problem(searched_));
      ends = climbed(at(meeting));
    }
    result_.best = nearest_of_the_best(ends);
    return ends;
  }

  /// The same designs, judged by the current problem.
  [[nodiscard]] std::vector<MaxMinPoint> at(std::vector<MaxMinPoint> points) {
    if (!objective_.is_expensive()) return points;
    return found(points.size(), "judging", [&](std::size_t i) { return numerics::point_at(problem_, points[i].x); });
  }

  std::vector<MaxMinPoint> starts() {
    const bool expensive = objective_.is_expensive();
    const int looks = expensive ? looks_per_start * wanted_ : looks_for(wanted_);
    const SampledStarts found = sampled_starts(objective_, to_size(looks), progress_, options_.among);
    std::vector<Eigen::VectorXd> points = found.points;
    result_.looked_at = found.judged;
    if (expensive && objective_.space().size() == 1) points = even_points();
    std::vector<MaxMinPoint> chosen = chosen_starts(looked_at(points), to_size(wanted_));
    if (const auto given = objective_.space().given_shares()) chosen.push_back(numerics::point_at(problem_, *given));
    for (const Eigen::VectorXd& also : options_.also) chosen.push_back(numerics::point_at(problem_, also));
    result_.starts = static_cast<int>(chosen.size());
    return chosen;
  }

  /// These designs judged; of expensive ones the rest is left out once nothing limits one of them.
  std::vector<MaxMinPoint> looked_at(const std::vector<Eigen::VectorXd>& points) {
    constexpr std::size_t together = 16;
    const std::size_t batch = objective_.is_expensive() ? together : points.size();
    std::vector<MaxMinPoint> seen;
    for (std::size_t from = 0; from < points.size(); from += batch) {
      const std::size_t count = std::min(batch, points.size() - from);
      const std::vector<MaxMinPoint> batch_seen =
          found(count, "looking", [&](std::size_t i) { return numerics::point_at(problem_, points[from + i]); });
      seen.insert(seen.end(), batch_seen.begin(), batch_seen.end());
      if (std::ranges::any_of(seen, [](const MaxMinPoint& one) { return rank(one) >= DesignObjective::unlimited; }))
        break;
    }
    looks_ = seen;
    return seen;
  }

  /// Shares of one range, spread evenly from end to end.
  static std::vector<Eigen::VectorXd> even_points() {
    constexpr int steps = 16;
    std::vector<Eigen::VectorXd> points;
    for (int i = 0; i <= steps; ++i) points.emplace_back(Eigen::VectorXd::Constant(1, i / double{steps}));
    return points;
  }

  /// The maxima of the current problem of one variable, near the best looks and starts.
  std::vector<MaxMinPoint> best_on_the_line(const std::vector<MaxMinPoint>& starts) {
    std::vector<MaxMinPoint> known = at(looks_), more = at(starts);
    known.insert(known.end(), more.begin(), more.end());
    std::vector<MaxMinPoint> maxima = maxima_on_a_line(
        problem_, std::move(known), to_size(wanted_),
        [this](std::size_t count, std::string_view task, const std::function<MaxMinPoint(std::size_t)>& find) {
          return found(count, task, find);
        });
    result_.starts = static_cast<int>(maxima.size());
    return maxima;
  }

  /// The designs were judged by upper bounds. In the order of falling bounds they are judged completely, until none
  /// that is left can be better; if the best bound is not the margin, the search goes on from there.
  void judge_completely(bool on_a_line) {
    judged_by_ = &objective_;
    problem_ = watch_.over(result_.problem);
    std::vector<MaxMinPoint> bounds = result_.ends;
    if (!result_.falls_short) bounds.insert(bounds.end(), looks_.begin(), looks_.end());
    std::ranges::stable_sort(bounds, [](const MaxMinPoint& a, const MaxMinPoint& b) { return rank(a) > rank(b); });
    std::optional<MaxMinPoint> best;
    bool confirmed = true;
    for (const MaxMinPoint& bound : bounds) {
      if (best && rank(*best) >= rank(bound) - same_objective) break;
      MaxMinPoint complete = numerics::point_at(problem_, bound.x);
      confirmed = confirmed && rank(complete) >= rank(bound) - same_objective;
      if (!best || rank(complete) > rank(*best)) best = std::move(complete);
    }
    result_.ends = at(result_.ends);
    if (std::ranges::none_of(result_.ends, [&](const MaxMinPoint& end) { return end.x == best->x; }))
      result_.ends.push_back(*best);
    if (!confirmed && can_climb(*best)) {
      const std::vector<MaxMinPoint> further = on_a_line ? best_on_the_line({*best}) : climbed({*best});
      result_.ends.insert(result_.ends.end(), further.begin(), further.end());
    }
    result_.best = nearest_of_the_best(result_.ends);
  }

  void keep_the_best_so_far() {
    result_.cut_short = true;
    const std::optional<Eigen::VectorXd> given =
        options_.also.empty() ? objective_.space().given_shares() : options_.also.front();
    std::vector<Eigen::VectorXd> found = watch_.best();
    if (found.empty() && given) found.push_back(*given);
    if (found.empty())
      throw foundation::NotComputable("optimize: ended before the first design was judged; give it more time");
    result_.best = numerics::point_at(result_.problem, found.front());
    for (std::size_t i = 1; i < found.size(); ++i)
      if (MaxMinPoint other = numerics::point_at(result_.problem, found[i]); rank(other) > rank(result_.best))
        result_.best = std::move(other);
    result_.ends = {result_.best};
    result_.starts = std::max(result_.starts, wanted_);
    result_.finished = std::min(finished_.load(), result_.starts);
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
    if (const std::string failure = objective_.counts().first_failure; !failure.empty())
      throw foundation::NotComputable("optimize: no design of the ranges can be computed: " + failure);
    Eigen::VectorXd values;
    result_.problem.evaluate(result_.best.x, values, nullptr);
    Eigen::Index least = 0;
    values.minCoeff(&least);
    const Place& place = objective_.places()[least];
    if (objective_.minimized().contain(place))
      throw foundation::NotComputable("optimize: " + objective_.words(place) +
                                      " is unbounded in every design looked at: an undamped resonance lies in the "
                                      "band; add damping, or change the band");
    throw foundation::NotComputable("optimize: the margin of \"" + objective_.words(place) +
                                    "\" is 0 in every design looked at; widen the ranges, or change the requirement");
  }

  const DesignObjective& objective_;
  const DesignObjective& searched_;                ///< `objective_`, or upper bounds of its margins
  const DesignObjective* judged_by_ = &searched_;  ///< points of `problem_`
  const SearchOptions& options_;
  int wanted_;
  const foundation::Progress& progress_;
  SearchWatch watch_;
  MaxMinProblem problem_;           ///< of `searched_`, under watch
  std::vector<MaxMinPoint> looks_;  ///< judged by `problem_` as requested
  std::atomic<int> finished_ = 0;   ///< climbs
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
  std::ranges::stable_sort(looks, [](const MaxMinPoint& a, const MaxMinPoint& b) { return rank(a) > rank(b); });
  std::vector<MaxMinPoint> chosen;
  for (const double apart : {0.15, 0.05, 0.0})
    for (const MaxMinPoint& look : looks) {
      if (chosen.size() >= starts) return chosen;
      const bool near = std::ranges::any_of(
          chosen, [&](const MaxMinPoint& other) { return (other.x - look.x).lpNorm<Eigen::Infinity>() <= apart; });
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

DesignSearch design_search(const DesignObjective& objective, const SearchOptions& options,
                           const foundation::Progress& progress) {
  return Search(objective, options, progress).run();
}

}  // namespace trivet::study
