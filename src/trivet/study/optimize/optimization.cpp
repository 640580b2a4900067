// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/optimize/optimization.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/study/family/design_space.h"
#include "trivet/study/optimize/design_objective.h"
#include "trivet/study/optimize/design_search.h"
#include "trivet/study/optimize/mount_search.h"
#include "trivet/study/optimize/optimum_warnings.h"
#include "trivet/study/optimize/robust_optimization.h"
#include "trivet/study/requirements/margin.h"
#include "trivet/study/requirements/mount_loads.h"
#include "trivet/study/requirements/unbounded_peaks.h"

namespace trivet::study {
namespace {

using numerics::MaxMinPoint;
using Place = DesignObjective::Place;

/// Ends this near to each other in every share of a range, and in the objective, are one.
constexpr double same_place = 1e-3;
/// A requirement within this of the least margin holds the optimum.
constexpr double active_within = 1e-5;

/// Of ln(margin), in designs that differ only by a number on which it does not depend.
constexpr double round_off = 1e-9;
/// Starts of a search that knows the ends of one before, besides these, and the designs among which they are chosen.
constexpr int starts_besides_ends = 4;
constexpr std::size_t looks_besides_ends = 4096;
constexpr double both[] = {-1, 1};
/// Of the range of a parameter, for what happens beside the optimum.
constexpr double step = 0.01;

/// exp of a logarithm that may be cut off.
double whole(double logarithm) {
  return logarithm >= DesignObjective::most ? foundation::infinity : std::exp(logarithm);
}

/// What a search found, in the words of an engineer.
class Description {
 public:
  /// @param given  objective of the design of the file, `objective` of that with the chosen mounts
  Description(const project::Project& project, const DesignObjective& given, const DesignObjective& objective,
              DesignSearch found)
      : project_(project),
        given_(given),
        objective_(objective),
        problem_(std::move(found.problem)),
        best_(std::move(found.best)),
        ends_(std::move(found.ends)) {
    result_.search.starts = found.starts;
    result_.search.finished = found.finished;
    result_.falls_short = found.falls_short;
    result_.cut_short = found.cut_short;
    result_.search.looked_at = found.looked_at;
    if (!result_.falls_short) result_.weights = objective.minimized().weights();
  }

  Optimization optimization() {
    result_.minimizes = objective_.minimized().any() && !result_.falls_short;
    leave_idle_parameters_as_given();
    describe_parameters();
    describe_verdicts();
    if (!result_.cut_short) {  // an unfinished search knows no optimum
      describe_conditions();
      describe_gone_peaks();
      describe_ends();
    }
    const EvaluationCounts counts = objective_.counts();
    result_.search.evaluations = counts.evaluations;
    result_.search.failed = counts.failed;
    result_.search.first_failure = counts.first_failure;
    result_.search.differenced = objective_.differenced();
    result_.search.differences = counts.differences;
    describe_families();
    return std::move(result_);
  }

 private:
  /// What changes nothing at the optimum keeps its given value, if the objective does.
  void leave_idle_parameters_as_given() {
    idle_.assign(objective_.space().size(), false);
    if (best_.objective >= DesignObjective::most) return;
    Eigen::VectorXd values;
    Eigen::MatrixXd slopes;
    problem_.evaluate(best_.x, values, &slopes);
    if (values.minCoeff() <= DesignObjective::unusable) {
      const std::string failure = objective_.counts().first_failure;
      result_.no_slopes = failure.empty() ? "a margin is 0 there" : failure;
      return;
    }
    MaxMinPoint kept = best_;
    for (std::size_t j = 0; j < idle_.size(); ++j) {
      constexpr double no_slope = 1e-6;  // of ln(margin) over the whole range
      idle_[j] = slopes.col(to_index(j)).isZero(no_slope) && is_level(to_index(j));
      if (const auto share = objective_.space().given_share(j); share && idle_[j]) kept.x(to_index(j)) = *share;
    }
    if (kept.x == best_.x) return;
    kept = numerics::point_at(problem_, kept.x);
    if (rank(kept) >= rank(best_) - round_off) best_ = kept;
  }

  /// True if steps of a parameter in both directions change nothing: not the top of a curve.
  [[nodiscard]] bool is_level(Eigen::Index parameter) const {
    return std::all_of(std::begin(both), std::end(both), [&](double direction) {
      Eigen::VectorXd moved = best_.x;
      moved(parameter) = std::clamp(moved(parameter) + direction * step, 0.0, 1.0);
      return std::abs(rank(numerics::point_at(problem_, moved)) - rank(best_)) <= round_off;
    });
  }

  void describe_parameters() {
    const Eigen::VectorXd values = objective_.space().values(best_.x);
    constexpr double at_bound = 1e-9;
    for (std::size_t j = 0; j < objective_.space().size(); ++j) {
      const double share = best_.x(to_index(j)), value = values(to_index(j));
      OptimizedParameter& one = result_.parameters.emplace_back();
      one.axis = objective_.space().axes()[j];
      one.given = objective_.space().given()[j];
      one.best = one.least = one.most = value;
      one.at_bound = share <= at_bound || share >= 1 - at_bound;
      one.idle = idle_[j];
      one.below = changed_by(to_index(j), -step);
      one.above = changed_by(to_index(j), step);
    }
  }

  /// The objective beside the optimum.
  [[nodiscard]] std::optional<OptimizedParameter::Step> changed_by(Eigen::Index parameter, double change) const {
    Eigen::VectorXd moved = best_.x;
    moved(parameter) += change;
    if (moved(parameter) < 0 || moved(parameter) > 1 || best_.objective >= DesignObjective::most) return std::nullopt;
    const MaxMinPoint there = numerics::point_at(problem_, moved);
    OptimizedParameter::Step result;
    result.value = objective_.space().values(moved)(parameter);
    if (there.objective <= DesignObjective::unusable) return result;
    result.objective = reported(there.objective);
    result.met = there.constraint >= least_met && (result_.minimizes || there.objective >= least_met);
    return result;
  }

  void describe_verdicts() {
    const std::vector<std::string> hold_in = cases_to_hold(project_);
    const Eigen::VectorXd values = objective_.space().values(best_.x);
    const foundation::Progress silent;
    for (std::size_t c = 0; c < objective_.cases().size(); ++c) {
      const project::Case& before = *given_.cases()[c];
      project::Case optimum = *objective_.cases()[c];
      optimum.system = objective_.space().system(*objective_.cases()[c], values);
      result_.before.push_back(case_verdict(before, hold_in, silent));
      result_.after.push_back(case_verdict(optimum, hold_in, silent));
      result_.summaries_before.push_back(design_summary(before.system));
      result_.summaries_after.push_back(design_summary(optimum.system));
    }
    result_.feasible = std::ranges::all_of(result_.after, [](const CaseVerdict& judged) {
      return std::ranges::all_of(judged.results,
                                 [](const RequirementResult& one) { return one.met() || one.misses_speed; });
    });
    for (std::size_t c = 0; c < objective_.cases().size(); ++c)
      at_best_.push_back(objective_.results(c, objective_.space().system(*objective_.cases()[c], values)));
    result_.objective_before = objective_of(given_.given());
    result_.objective_after = objective_of(at_best_).value_or(0);
    for (std::size_t c = 0; c < at_best_.size(); ++c)
      for (std::size_t r = 0; r < at_best_[c].size(); ++r) {
        if (!objective_.minimized().contain({c, r})) continue;
        const RequirementResult &before = given_.given()[c][r], &after = at_best_[c][r];
        const auto limit = objective_.minimized().have_limits() ? std::optional(after.allowed) : std::nullopt;
        result_.minimized.push_back(
            {c, after.subject, after.unit, limit, before.value.value_or(0), after.value.value_or(0)});
        if (!limit && result_.minimizes) result_.objective_unit = after.unit;
      }
  }

  /// The least margin, or the largest minimised amplitude, or share of its limit.
  [[nodiscard]] std::optional<double> objective_of(const std::vector<std::vector<RequirementResult>>& found) const {
    if (is_weighted()) return objective_.minimized().weighted_sum(found);
    double least = foundation::infinity;
    for (std::size_t c = 0; c < found.size(); ++c)
      for (std::size_t r = 0; r < found[c].size(); ++r) {
        if (objective_.minimized().contain({c, r}) != result_.minimizes) continue;
        if (!found[c][r].value) return std::nullopt;
        least = std::min(least, found[c][r].margin * std::exp(-objective_.reserve({c, r})));
      }
    return result_.minimizes ? 1 / least : least;
  }

  void describe_families() {
    for (std::size_t c = 0; c < objective_.cases().size(); ++c) {
      const DesignBatch& one = objective_.families()[c];
      const std::string& name = objective_.cases()[c]->name;
      const std::string of_case = name.empty() ? "" : "case " + name + ": ";
      if (one.reason().empty()) result_.families.push_back(of_case + one.family().words());
      else result_.no_families.push_back(of_case + one.reason());
    }
  }

  /// d ln(margin)/d ln(bound): 1 but for peaks above their tolerance a, with the margin (1 + a)/(1 + p).
  [[nodiscard]] static double effect_of_bound(const RequirementResult& result) {
    return result.kind == RequirementKind::no_peak && result.margin < 1 ? result.allowed / (1 + result.allowed) : 1;
  }

  [[nodiscard]] bool is_weighted() const { return result_.minimizes && !objective_.minimized().weights().empty(); }

  /// The objective of an end of the search, as it is reported.
  [[nodiscard]] double reported(double objective) const {
    return result_.falls_short ? whole(objective) : reported_objective(objective_, objective);
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
      const double multiplier = found.of_values(to_index(i)) / (is_weighted() ? -best_.objective : 1);
      constexpr double some = 1e-6;
      if (multiplier <= some) continue;
      const Place& place = objective_.places()[i];
      const auto same = std::ranges::find_if(held, [&](const Held& one) {
        return one.place.result_case == place.result_case && one.place.result == place.result;
      });
      if (same != held.end()) same->multiplier += multiplier;
      else held.push_back({place, multiplier});
    }
    std::ranges::stable_sort(held, std::ranges::greater{}, &Held::multiplier);
    for (const Held& one : held) {
      const RequirementResult& result = at_best_[one.place.result_case][one.place.result];
      result_.active.push_back({one.place.result_case, objective_.words(one.place),
                                objective_.words_for_people(one.place), objective_.minimized().contain(one.place),
                                one.multiplier * effect_of_bound(result)});
      if (!result_.feasible && !result_.minimizes) describe_conflict(one.place, result);
    }
  }

  /// Without a requirement that holds the optimum: what the others reach.
  void describe_conflict(const Place& place, const RequirementResult& result) {
    const DesignObjective& searched = objective_.quick() ? *objective_.quick() : objective_;
    MaxMinPoint others = max_min(problem_of_requirements(searched, place), best_.x);
    if (&searched != &objective_) others = numerics::point_at(problem_of_requirements(objective_, place), others.x);
    const double factor = result.kind == RequirementKind::no_peak ? *result.value / result.allowed : 1 / result.margin;
    result_.conflicts.push_back({place.result_case, objective_.words(place), objective_.words_for_people(place), factor,
                                 whole(others.objective)});
  }

  void describe_gone_peaks() {
    if (best_.objective < DesignObjective::most || objective_.minimized().any()) return;
    const Eigen::VectorXd values = objective_.space().values(best_.x);
    for (std::size_t c = 0; c < at_best_.size(); ++c) {
      const auto absent = objective_.absent_peaks_at(c, objective_.space().system(*objective_.cases()[c], values));
      for (std::size_t r = 0; r < absent.size(); ++r)
        if (absent[r])
          result_.gone_peaks.push_back({c, at_best_[c][r].subject, absent[r]->measure, absent[r]->angular_frequency});
    }
  }

  void describe_ends() {
    struct Top {
      MaxMinPoint point;
      int starts;
    };
    std::vector<Top> places;
    for (const MaxMinPoint& end : ends_) {
      if (end.objective <= DesignObjective::unusable) {
        ++result_.search.stuck;
        continue;
      }
      if (std::abs(rank(best_) - rank(end)) <= same_objective) {
        ++result_.search.agreeing;
        const Eigen::VectorXd values = objective_.space().values(end.x);
        for (std::size_t j = 0; j < result_.parameters.size(); ++j) {
          study::OptimizedParameter& p = result_.parameters[j];
          p.least = std::min(p.least, values(to_index(j)));
          p.most = std::max(p.most, values(to_index(j)));
        }
        continue;
      }
      const auto same = std::ranges::find_if(places, [&](const Top& place) {
        return std::abs(rank(place.point) - rank(end)) <= same_objective &&
            (place.point.x - end.x).lpNorm<Eigen::Infinity>() <= same_place;
      });
      if (same == places.end()) places.push_back({end, 1});
      else ++same->starts;
    }
    std::ranges::stable_sort(places, [](const Top& a, const Top& b) { return rank(a.point) > rank(b.point); });
    constexpr std::size_t shown = 3;
    for (std::size_t i = 0; i < places.size() && i < shown; ++i) {
      const Eigen::VectorXd values = objective_.space().values(places[i].point.x);
      result_.search.others.push_back(
          {{values.begin(), values.end()}, reported(places[i].point.objective), places[i].starts});
    }
  }

  const project::Project& project_;
  const DesignObjective& given_;
  const DesignObjective& objective_;
  numerics::MaxMinProblem problem_;
  MaxMinPoint best_;
  std::vector<MaxMinPoint> ends_;
  std::vector<bool> idle_;
  std::vector<std::vector<RequirementResult>> at_best_;  ///< per case
  Optimization result_;
};

}  // namespace

Optimization optimization(const project::Project& project, const foundation::Progress& progress,
                          const std::function<bool()>& enough, SharedWork* shared) {
  const auto& request = project.base().analyses.optimize;
  return request && request->is_robust() ? robust_optimization(project, progress, enough, shared)
                                         : optimization_with_reserves(project, {}, progress, enough, {}, shared);
}

Optimization optimization_with_reserves(const project::Project& project, const DesignObjective::Reserves& reserves,
                                        const foundation::Progress& progress, const std::function<bool()>& enough,
                                        const std::vector<Eigen::VectorXd>& near, SharedWork* shared) {
  const project::OptimizeRequest request = project.base().analyses.optimize.value_or(project::OptimizeRequest());
  const DesignObjective given(project, request, reserves);
  for (const project::Case* variant : given.cases()) refuse_unbounded_peaks(*variant, given.space().axes());
  std::optional<MountSearch> mounts = mount_search(project, request, progress, enough);
  const auto searched = [&](const DesignObjective& objective) {
    SearchOptions options{.starts = request.starts, .also = near, .enough = enough, .shared = shared};
    if (!near.empty()) {  // what differs are the reserves
      options.starts = std::min(starts_besides_ends, request.starts.value_or(starts_besides_ends));
      options.among = looks_besides_ends;
    }
    if (mounts && mounts->numbers.size() > 0) options.also.push_back(mounts->numbers);
    Optimization result =
        Description(project, given, objective, design_search(objective, options, progress)).optimization();
    result.minimized_kind = request.minimized;
    result.warnings = parameter_warnings(project, given.space());
    result.warnings.add(optimum_warnings(project, result));
    return result;
  };
  if (!mounts) return searched(given);
  Optimization result = searched(DesignObjective(mounts->best, request));
  result.mounts = std::move(mounts->found);
  if (const auto& price = result.mounts->price) {
    const std::optional<model::Price> before = sums_of_mounts(project.base().system).price;
    if (before && before->currency == price->currency) result.mounts->price_before = before;
  }
  return result;
}

Optimization optimum_at(const project::Project& project, const DesignObjective::Reserves& reserves,
                        const Eigen::VectorXd& shares, const Optimization& search) {
  const project::OptimizeRequest request = project.base().analyses.optimize.value_or(project::OptimizeRequest());
  const DesignObjective objective(project, request, reserves);
  DesignSearch at;
  at.problem = search_problem(objective);
  at.best = numerics::point_at(at.problem, shares);
  at.ends = {at.best};
  Optimization result = Description(project, objective, objective, std::move(at)).optimization();
  result.active.clear();
  result.no_slopes = "it is that of many machines";
  result.conflicts.clear();
  result.search = search.search;
  result.minimized_kind = search.minimized_kind;
  result.warnings = search.warnings;
  return result;
}

std::vector<project::Node> optimum_changes(const Optimization& found) {
  std::vector<project::Node> changes;
  for (std::size_t c = 0; found.mounts && c < found.mounts->choices.size(); ++c)
    changes.push_back(project::change_of(found.mounts->choices[c], found.mounts->chosen[c]));
  for (const OptimizedParameter& parameter : found.parameters)
    changes.push_back(project::ModelNumber(parameter.axis).change(parameter.best));
  return changes;
}

}  // namespace trivet::study
