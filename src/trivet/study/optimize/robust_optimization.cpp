// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/optimize/robust_optimization.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/judging/changed_case.h"
#include "trivet/study/requirements/margin.h"
#include "trivet/study/sample/sample_run.h"
#include "trivet/study/sample/worst_case.h"

namespace trivet::study {
namespace {

using Margins = std::vector<std::vector<double>>;  ///< per case and requirement

constexpr std::size_t searched_designs = 16384;  // of a round
constexpr int most_rounds = 12;
/// Rounds that need the same reserves within this have settled, ln(margin). Reserves are larger by it, so that the last
/// optimum has what it needs.
constexpr double same_reserves = 1e-3;
/// Bounds of the least margin of the search, which only the sample judges in the end.
constexpr double nearly_met = 1e-2;
/// Added to the numbers of the search, so that the yield is sampled with others.
constexpr std::uint64_t other_numbers = 0x9e3779b9;

/// The project with another design in all its cases.
project::Project with_changes(const project::Project& project, const std::vector<project::Node>& changes) {
  project::Project changed = project;
  for (project::Case& variant : changed.cases)
    if (auto one = judging::changed_case(variant, changes)) variant = std::move(*one);
  return changed;
}

bool meets(double margin) { return margin > 0 && std::log(margin) >= least_met; }

/// What the machines within the tolerances have of a design.
struct Kept {
  Margins nominal, kept;
  double least =
      foundation::infinity;  ///< margin that the wanted share keeps in all requirements, or the worst ones have
};

/// Margins of designs in all cases side by side; 0 where a design cannot be judged.
Eigen::ArrayXXd judged_designs(const SampleRun& run, const foundation::Progress& progress) {
  Eigen::Index columns = 0;
  for (const SampledCase& one : run.cases()) columns += to_index(one.given().size());
  Eigen::ArrayXXd margins(to_index(searched_designs), columns);
  foundation::parallel_for(searched_designs, {.size = run.piece(), .progress = progress, .task = "machines"},
                           [&](std::size_t first, std::size_t last) {
                             const Eigen::MatrixXd draws = run.drawn().draw(first, last - first);
                             Eigen::Index column = 0;
                             for (const SampledCase& one : run.cases()) {
                               const Eigen::ArrayXXd found = one.judged(draws).margins;
                               margins.block(to_index(first), column, draws.rows(), found.cols()) =
                                   found.isNaN().select(0, found);
                               column += found.cols();
                             }
                           });
  return margins;
}

/// Bounds of all columns, each at the same place of its order, above which a share of the rows lies with all columns.
std::vector<double> common_bounds(const Eigen::ArrayXXd& margins, double share) {
  const std::size_t rows = to_size(margins.rows());
  std::vector<std::vector<double>> sorted;
  std::vector<std::size_t> least(rows, rows);  // of each row: how many rows a column has up to it
  for (Eigen::Index c = 0; c < margins.cols(); ++c) {
    std::vector<double>& column = sorted.emplace_back(margins.col(c).begin(), margins.col(c).end());
    std::ranges::sort(column);
    for (std::size_t i = 0; i < rows; ++i) {
      const auto up_to = std::ranges::upper_bound(column, margins(to_index(i), c)) - column.begin();
      least[i] = std::min(least[i], static_cast<std::size_t>(up_to));
    }
  }
  std::ranges::sort(least);
  const auto allowed = static_cast<std::size_t>((1 - share) * static_cast<double>(rows));
  std::vector<double> bounds;
  for (const std::vector<double>& column : sorted) bounds.push_back(column[std::min(least[allowed], rows) - 1]);
  return bounds;
}

Kept nominal_margins(const SampleRun& run) {
  Kept found;
  for (const SampledCase& one : run.cases()) {
    std::vector<double>& nominal = found.nominal.emplace_back();
    for (const RequirementResult& result : one.given()) nominal.push_back(result.margin);
  }
  found.kept = found.nominal;
  return found;
}

/// Which machines of a search are above the bounds of all requirements at once.
struct Aim {
  double wanted = 1;        ///< share of the machines
  bool minimizes = false;   ///< they only have to meet the requirements; false: a margin as large as possible counts
  double share = 1;         ///< above the bounds; less than wanted where most requirements have room to spare
  bool is_adapted = false;  ///< to the design before
};

/// Changes the share by how many machines of a design that has the reserves of the bounds are below what counts.
void adapt(Aim& aim, double below) {
  constexpr double most_change = 4, fewest_above = 0.5;
  const double factor = std::clamp((1 - aim.wanted) / std::max(below, 1e-9), 1 / most_change, most_change);
  aim.share = std::clamp(1 - (1 - aim.share) * factor, fewest_above, 1 - 2.0 / searched_designs);
}

Kept kept_by_share(const SampleRun& run, Aim& aim, const foundation::Progress& progress) {
  Kept found = nominal_margins(run);
  const Eigen::ArrayXXd margins = judged_designs(run, progress);
  const Eigen::ArrayXd least_of_each = margins.rowwise().minCoeff();
  std::vector<double> least(least_of_each.begin(), least_of_each.end());
  std::ranges::sort(least);
  const auto count = static_cast<double>(least.size());
  found.least = least[static_cast<std::size_t>((1 - aim.wanted) * count)];
  std::vector<double> bounds = common_bounds(margins, aim.share);
  if (aim.is_adapted) {
    const double level = aim.minimizes ? 1 : *std::ranges::min_element(bounds);
    adapt(aim, static_cast<double>(std::ranges::lower_bound(least, level) - least.begin()) / count);
    bounds = common_bounds(margins, aim.share);
  }
  std::size_t column = 0;
  for (std::vector<double>& of_case : found.kept)
    for (double& one : of_case) one = bounds[column++];
  return found;
}

Kept kept_by_worst(const SampleRun& run, const foundation::Progress& progress) {
  Kept found = nominal_margins(run);
  WorstStarts none;
  for (const SampledCase& one : run.cases()) none.emplace_back(one.given().size());
  const WorstSearch worst = worst_search(run.cases(), worst_box(run.drawn()), none, run.request().seed, progress);
  for (std::size_t c = 0; c < found.kept.size(); ++c)
    for (std::size_t r = 0; r < found.kept[c].size(); ++r) {
      found.kept[c][r] = worst.failed > 0 ? 0 : std::min(worst.of[c][r].margin, found.nominal[c][r]);
      found.least = std::min(found.least, found.kept[c][r]);
    }
  return found;
}

/// A margin that is no number, or falls to nothing, has no distance that could be kept.
bool has_reserve(double nominal, double kept) { return std::isfinite(nominal) && nominal > 0 && kept > 0; }

DesignObjective::Reserves reserves_for(const Kept& at) {
  DesignObjective::Reserves reserves;
  for (std::size_t c = 0; c < at.nominal.size(); ++c) {
    std::vector<double>& of_case = reserves.emplace_back();
    for (std::size_t r = 0; r < at.nominal[c].size(); ++r) {
      const double nominal = at.nominal[c][r], kept = at.kept[c][r];
      of_case.push_back(has_reserve(nominal, kept) ? std::max(0.0, std::log(nominal / kept)) + same_reserves : 0);
    }
  }
  return reserves;
}

double largest_difference(const DesignObjective::Reserves& a, const DesignObjective::Reserves& b) {
  if (a.empty() || b.empty()) return foundation::infinity;
  double largest = 0;
  for (std::size_t c = 0; c < a.size(); ++c)
    for (std::size_t r = 0; r < a[c].size(); ++r) largest = std::max(largest, std::abs(a[c][r] - b[c][r]));
  return largest;
}

class RobustSearch {
 public:
  RobustSearch(const project::Project& project, const foundation::Progress& progress,
               const std::function<bool()>& enough)
      : project_(with_usual_sample(project)), progress_(progress), enough_(enough) {
    result_.wanted = project.base().analyses.optimize->yield;
    aim_.wanted = aim_.share = result_.wanted.value_or(1);
    aim_.minimizes = !project.base().analyses.optimize->minimize.empty();
  }

  Optimization run() {
    result_.given = sampled(project_, kept_by(project_));
    for (;;) {
      settle();
      result_.found = sampled(best_->project, best_->kept);
      judge();
      if (result_.held || !result_.wanted || !nearly_meets(best_->kept)) break;
      if (result_.rounds >= most_rounds || best_->optimum.cut_short) break;
      // The search aimed at too few for the numbers of the sample.
      constexpr double more_than_missing = 1.5, most_share = 1 - 2.0 / searched_designs;
      const double missing = *result_.wanted - result_.found.yield->interval.from, before = aim_.wanted;
      aim_.wanted = std::min(most_share, before + more_than_missing * missing);
      aim_.share = 1 - (1 - aim_.share) * (1 - aim_.wanted) / (1 - before);
      best_.reset();
    }
    return described();
  }

 private:
  struct Round {
    Optimization optimum;
    project::Project project;  ///< with the optimum
    Kept kept;
  };

  static project::Project with_usual_sample(const project::Project& project) {
    project::Project result = project;
    for (project::Case& variant : result.cases)
      if (!variant.analyses.sample) variant.analyses.sample.emplace();
    return result;
  }

  static project::Project searched(const project::Project& project) {
    project::Project result = project;
    for (project::Case& variant : result.cases) variant.analyses.sample->seed += other_numbers;
    return result;
  }

  [[nodiscard]] Kept kept_by(const project::Project& project) {
    const project::Project with_other_numbers = searched(project);
    const SampleRun run(with_other_numbers);
    return result_.wanted ? kept_by_share(run, aim_, progress_) : kept_by_worst(run, progress_);
  }

  [[nodiscard]] static bool nearly_meets(const Kept& kept) { return kept.least > 1 - nearly_met; }

  /// Rounds until the reserves are those that their optimum needs; the best one is kept.
  void settle() {
    result_.settled = false;
    while (result_.rounds < most_rounds && !result_.settled) {
      Optimization optimum = optimization_with_reserves(project_, reserves_, progress_, enough_);
      project::Project there = with_changes(project_, optimum_changes(optimum));
      Kept kept = kept_by(there);
      if (result_.rounds++ == 0) result_.nominal = sampled(there, kept);
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

  /// Of what is minimised the last round counts, whose reserves are the most exact.
  [[nodiscard]] static bool replaces(const Round& one, const Round& before) {
    return one.optimum.minimizes || one.kept.least > before.kept.least;
  }

  [[nodiscard]] SampledDesign sampled(const project::Project& project, const Kept& kept) {
    SampledDesign design{kept.least, std::nullopt};
    if (!result_.wanted) return design;
    project::Project counted = project;
    for (project::Case& variant : counted.cases) {
      variant.analyses.sample->worst_case = false;
      variant.analyses.sample->bands.clear();
    }
    const Sample found = sample(counted, progress_);
    design.yield = found.yield;
    result_.designs = found.yield.designs;
    result_.failed = found.failed;
    return design;
  }

  void judge() {
    result_.held = result_.wanted ? result_.found.yield->interval.from >= *result_.wanted : meets(best_->kept.least);
  }

  Optimization described() {
    Optimization optimum = std::move(best_->optimum);
    const Kept& kept = best_->kept;
    for (std::size_t c = 0; c < kept.kept.size(); ++c)
      for (std::size_t r = 0; r < kept.kept[c].size(); ++r) {
        const RequirementResult& judged = optimum.after[c].results[r];
        result_.margins.push_back({c, judged.words.text(), judged.words_at_level(), kept.nominal[c][r], kept.kept[c][r],
                                   has_reserve(kept.nominal[c][r], kept.kept[c][r]) || meets(kept.kept[c][r])});
      }
    optimum.feasible = optimum.feasible && result_.held;
    if (!optimum.minimizes) {
      const double of_search = optimum.objective_after;  // the same but for the last change of the reserves
      for (OptimizedParameter& parameter : optimum.parameters)
        for (auto* step : {&parameter.below, &parameter.above})
          if (*step && (*step)->objective && of_search > 0) *(*step)->objective *= result_.found.kept / of_search;
      optimum.objective_before = result_.given.kept;
      optimum.objective_after = result_.found.kept;
    }
    optimum.robust = std::move(result_);
    return optimum;
  }

  project::Project project_;
  const foundation::Progress& progress_;
  const std::function<bool()>& enough_;
  DesignObjective::Reserves reserves_;
  Aim aim_;
  std::optional<Round> best_;
  RobustOptimum result_;
};

}  // namespace

Optimization robust_optimization(const project::Project& project, const foundation::Progress& progress,
                                 const std::function<bool()>& enough) {
  return RobustSearch(project, progress, enough).run();
}

}  // namespace trivet::study
