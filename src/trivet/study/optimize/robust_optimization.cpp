// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/optimize/robust_optimization.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/study/optimize/kept_margin_climb.h"
#include "trivet/study/optimize/kept_margins.h"
#include "trivet/study/requirements/margin.h"
#include "trivet/study/requirements/verdict.h"

namespace trivet::study {
namespace {

/// A limit of time, not of accuracy: the fan of the examples settles in 3, and shares that are raised need some more.
/// The result says if they have not settled.
constexpr int most_searches = 12;
/// Bounds of the least margin of the search, which only the sample judges in the end.
constexpr double nearly_met = 1e-2;
/// Added to the seed of [analyses.sample], whose own numbers are left to the yields of the result: one for the margins
/// by which designs are searched, one for the yields by which a design is chosen.
constexpr std::uint64_t searching = 0x9e3779b9, choosing = 2 * searching;
/// The lower end of the yield by which a design is chosen is so many of its reaches (1.96 σ, from the estimate to the
/// lower end) above the wanted yield; the estimate is 1 + spare reaches above it. Of other numbers too the lower end
/// has to be above, so their estimate may be lower by `spare` reaches, 2.9 σ. Two estimates differ by √2 σ: that holds
/// in 98 of 100 searches.
constexpr double spare = 1.5;

bool meets(double margin) { return margin > 0 && std::log(margin) >= least_met; }

class RobustSearch {
 public:
  RobustSearch(const project::Project& project, const foundation::Progress& progress,
               const std::function<bool()>& enough, SharedWork* shared)
      : project_(with_usual_sample(project)),
        space_(project_, project_.base().analyses.optimize->parameters),
        given_progress_(progress),
        progress_(in_stages(progress)),
        enough_(enough),
        shared_(shared) {
    result_.wanted = project.base().analyses.optimize->yield;
    aim_.wanted = aim_.searched = aim_.share = result_.wanted.value_or(1);
    aim_.minimizes = !project.base().analyses.optimize->minimize.empty();
  }

  Optimization run() {
    stage_ = "given design";
    result_.given = sampled(project_, kept_by(project_));
    settle();
    if (result_.wanted && aim_.minimizes) reach_the_yield();
    else if (result_.wanted && !best_->optimum.cut_short) raise_kept_margin();
    stage_ = "optimum";
    result_.found = sampled(best_->project, best_->kept);
    result_.held = result_.found.yield ? result_.found.yield->at_least() >= *result_.wanted : meets(best_->kept.least);
    return described();
  }

 private:
  struct Round {
    Optimization optimum;
    project::Project project;  ///< with the optimum
    Kept kept;
  };

  /// Tasks of rounds repeat; each report names the round, or how many designs were tried.
  foundation::Progress in_stages(const foundation::Progress& progress) const {
    if (!progress) return {};
    return [this, progress](std::string_view task, double fraction) {
      progress(fmt::format("{}: {}", stage_, task), fraction);
    };
  }

  /// Its yields alone are sampled: bands and the worst case of `trivet sample` would be computed for every design.
  static project::Project with_usual_sample(const project::Project& project) {
    project::Project result = project;
    for (project::Case& variant : result.cases) {
      if (!variant.analyses.sample) variant.analyses.sample.emplace();
      variant.analyses.sample->worst_case = false;
      variant.analyses.sample->bands.clear();
    }
    return result;
  }

  static project::Project with_numbers(project::Project project, std::uint64_t other) {
    for (project::Case& variant : project.cases) variant.analyses.sample->seed += other;
    return project;
  }

  [[nodiscard]] Kept kept_by(const project::Project& project) {
    const project::Project searched = with_numbers(project, searching);
    const SampleRun run(searched);
    return result_.wanted ? kept_by_share(run, aim_, progress_) : kept_by_worst(run, progress_);
  }

  /// Of what is minimised: rounds with a larger share of the machines while it misses the wanted yield by little, then
  /// steps towards the largest margin kept. The best of them counts.
  void reach_the_yield() {
    std::optional<Round> nearest;
    double most = 0;
    for (;;) {
      const Yield seen = yield_by_choice(best_->project);
      if (!nearest || assured(seen) > most) {
        nearest = best_;
        most = assured(seen);
      }
      const bool may_search_on = assured(seen) < *result_.wanted && seen.interval.estimate < 1 &&
          best_->kept.least > 1 - nearly_met && result_.rounds < most_searches && !best_->optimum.cut_short;
      if (!may_search_on) break;
      aim_higher(seen);
      settle();
    }
    best_ = std::move(nearest);
    if (most < *result_.wanted && !best_->optimum.cut_short) approach_the_largest_margin(most);
  }

  /// The search aims at the yield y whose interval would be high enough. Its reach goes with √(1 − y), so
  /// wanted = y − r √(1 − y), with r of the yield that was seen: a quadratic equation of √(1 − y).
  void aim_higher(const Yield& seen) {
    constexpr double most_share = 1 - 2.0 / searched_machines;
    const double missed = 1 - seen.interval.estimate, reach = (1 - missed - assured(seen)) / std::sqrt(missed);
    const double root = (std::sqrt(reach * reach + 4 * (1 - *result_.wanted)) - reach) / 2;
    const double before = aim_.searched;
    aim_.searched = std::min(most_share, 1 - (1 - before) * root * root / missed);
    aim_.share = 1 - (1 - aim_.share) * (1 - aim_.searched) / (1 - before);
    aim_.is_adapted = false;
    reserves_ = reserves_for(kept_by(best_->project));
    aim_.is_adapted = true;
    best_.reset();
  }

  /// Where the next round starts.
  [[nodiscard]] std::vector<Eigen::VectorXd> ends_of(const Optimization& optimum) const {
    std::vector<Eigen::VectorXd> ends = {shares_of(optimum)};
    for (const OtherOptimum& other : optimum.search.others) {
      Eigen::VectorXd& shares = ends.emplace_back(to_index(space_.size()));
      for (std::size_t j = 0; j < space_.size(); ++j)
        shares(to_index(j)) = std::clamp(space_.axes()[j].share(other.values[j]), 0.0, 1.0);
    }
    return ends;
  }

  /// Rounds until the reserves are those that their optimum needs; the best one is kept.
  void settle() {
    result_.settled = false;
    while (result_.rounds < most_searches && !result_.settled) {
      stage_ = fmt::format("round {} of at most {}", result_.rounds + 1, most_searches);
      Optimization optimum = optimization_with_reserves(project_, reserves_, progress_, enough_, near_, shared_);
      near_ = ends_of(optimum);
      project::Project there = with_changes(project_, optimum_changes(optimum));
      Kept kept = kept_by(there);
      if (result_.rounds++ == 0) {
        result_.nominal = sampled(there, kept);
        first_search_ = optimum.search;
        if (!optimum.cut_short) first_search_.finished = first_search_.starts;
      }
      DesignObjective::Reserves needed = reserves_for(kept);
      result_.settled = largest_difference(reserves_, needed) <= same_reserves;
      reserves_ = std::move(needed);
      aim_.is_adapted = true;
      Round round{std::move(optimum), std::move(there), std::move(kept)};
      const bool ends = round.optimum.cut_short;
      if (!best_ || replaces(round, *best_)) best_.emplace(std::move(round));
      if (ends) break;
    }
  }

  [[nodiscard]] KeptMarginClimb climb_of_machines() const {
    return {with_numbers(best_->project, searching), space_, *result_.wanted, given_progress_, enough_};
  }

  /// Reserves are alike for all requirements, and the machines are not: a search by steps of the numbers (Hooke and
  /// Jeeves), around the best of the rounds and the given design, for the margin that the machines keep. It takes many
  /// designs, so only those that kernels judge.
  void raise_kept_margin() {
    KeptMarginClimb climb = climb_of_machines();
    result_.is_raised = climb.has_kernels();
    if (!result_.is_raised) return;
    Eigen::VectorXd best = shares_of(best_->optimum);
    double least = best_->kept.least;
    if (const auto given = space_.given_shares(); given && result_.given.kept > least) {
      best = *given;
      least = result_.given.kept;
    }
    climb.raise(best, least);
    stage_ = "design towards the largest margin";
    if (least > best_->kept.least) move_to(best);
    for (std::size_t j = 0; j < space_.size(); ++j) {
      OptimizedParameter& parameter = best_->optimum.parameters[j];
      for (auto* step : {&parameter.below, &parameter.above}) {
        if (!*step) continue;
        Eigen::VectorXd moved = best;
        moved(to_index(j)) = std::clamp(space_.axes()[j].share((*step)->value), 0.0, 1.0);
        (*step)->objective = climb.kept_at(moved, 0);
        (*step)->met = meets(*(*step)->objective);
      }
    }
    result_.looked_at = climb.looked_at();
  }

  /// Of what is minimised: from an optimum that just misses the wanted yield towards the design with the largest margin
  /// kept, as far as it needs. @param assured_before  yield of that optimum
  void approach_the_largest_margin(double assured_before) {
    KeptMarginClimb climb = climb_of_machines();
    if (!climb.has_kernels()) return;
    const Eigen::VectorXd from = shares_of(best_->optimum);
    Eigen::VectorXd safe = from;
    double least = best_->kept.least;
    climb.raise(safe, least);
    stage_ = "design towards the largest margin";
    result_.looked_at = climb.looked_at();
    if (safe == from) return;
    const auto assured_at = [&](double share) {
      return assured(yield_by_choice(with_changes(project_, space_.changes(from + share * (safe - from)))));
    };
    const double most = assured_at(1);
    if (most <= assured_before) return;
    double missed = 0, reached = 1;
    for (int halvings = 0; halvings < 8 && most >= *result_.wanted; ++halvings) {
      const double middle = (missed + reached) / 2;
      (assured_at(middle) >= *result_.wanted ? reached : missed) = middle;
    }
    move_to(from + reached * (safe - from));
  }

  [[nodiscard]] Yield yield_by_choice(const project::Project& project) const {
    return sample(with_numbers(project, choosing), progress_).yield;
  }

  /// What other numbers find as well, see `spare`.
  static double assured(const Yield& seen) {
    return seen.at_least() - spare * (seen.interval.estimate - seen.at_least());
  }

  [[nodiscard]] Eigen::VectorXd shares_of(const Optimization& optimum) const {
    Eigen::VectorXd shares(to_index(space_.size()));
    for (std::size_t j = 0; j < space_.size(); ++j)
      shares(to_index(j)) = std::clamp(space_.axes()[j].share(optimum.parameters[j].best), 0.0, 1.0);
    return shares;
  }

  /// Takes another design in place of the best one.
  void move_to(const Eigen::VectorXd& best) {
    project::Project there = with_changes(project_, space_.changes(best));
    aim_.is_adapted = false;
    Kept kept = kept_by(there);
    Optimization optimum = optimum_at(project_, reserves_for(kept), best, best_->optimum);
    best_ = Round{std::move(optimum), std::move(there), std::move(kept)};
  }

  /// Of what is minimised the last round counts, whose reserves are the most exact.
  [[nodiscard]] static bool replaces(const Round& one, const Round& before) {
    return one.optimum.minimizes || one.kept.least > before.kept.least;
  }

  [[nodiscard]] SampledDesign sampled(const project::Project& project, const Kept& kept) {
    SampledDesign design{kept.least, std::nullopt, kept.failed, kept.first_failure};
    if (!result_.wanted) return design;
    const Sample found = sample(project, progress_);
    result_.designs = found.yield.designs;
    result_.seed = found.request.seed;
    return {kept.least, found.yield, found.failed, found.first_failure};
  }

  Optimization described() {
    Optimization optimum = std::move(best_->optimum);
    const Kept& kept = best_->kept;
    for (std::size_t c = 0; c < kept.kept.size(); ++c)
      for (std::size_t r = 0; r < kept.kept[c].size(); ++r) {
        const RequirementResult& judged = optimum.after[c].results[r];
        const double nominal = kept.nominal[c][r], bound = kept.kept[c][r];
        result_.margins.push_back({c, judged.words.text(), judged.words_for_people(optimum.after[c].display), nominal,
                                   kept.alone[c][r], has_reserve(nominal, bound) || meets(bound)});
      }
    optimum.feasible = optimum.feasible && result_.held;
    if (!optimum.minimizes) {
      // Margins of the search are those of the machines but for the last change of the reserves.
      const double change =
          result_.found.kept > 0 && optimum.objective_after > 0 ? result_.found.kept / optimum.objective_after : 1;
      for (OptimizedParameter& parameter : optimum.parameters)
        if (!result_.is_raised)
          for (auto* step : {&parameter.below, &parameter.above})
            if (*step && (*step)->objective) *(*step)->objective *= change;
      optimum.objective_before = result_.given.kept;
      optimum.objective_after = result_.found.kept;
    }
    optimum.search = std::move(first_search_);
    if (optimum.cut_short) {
      optimum.search.agreeing = 0;
      optimum.search.others.clear();
    }
    optimum.robust = std::move(result_);
    return optimum;
  }

  project::Project project_;
  DesignSpace space_;
  std::string stage_;
  const foundation::Progress& given_progress_;
  foundation::Progress progress_;  ///< names the stage
  const std::function<bool()>& enough_;
  SharedWork* shared_;
  DesignObjective::Reserves reserves_;
  std::vector<Eigen::VectorXd> near_;  ///< ends of the last round
  /// Later rounds start at its ends: that these reach the same optimum again is no evidence.
  SearchStatistics first_search_;
  Aim aim_;
  std::optional<Round> best_;  ///< of the rounds with one aim; at the end the result
  RobustOptimum result_;
};

}  // namespace

Optimization robust_optimization(const project::Project& project, const foundation::Progress& progress,
                                 const std::function<bool()>& enough, SharedWork* shared) {
  if (std::ranges::none_of(project.cases, has_something_to_judge))
    throw foundation::InvalidInput(fmt::format(
        "optimize: {} without requirements and limits, which the machines within the tolerances have to meet; "
        "add [requirements]",
        project.base().analyses.optimize->yield ? "yield" : "worst_case"));
  return RobustSearch(project, progress, enough, shared).run();
}

}  // namespace trivet::study
