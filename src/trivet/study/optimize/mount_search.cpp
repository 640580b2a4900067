// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/optimize/mount_search.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/judging/changed_case.h"
#include "trivet/study/optimize/design_search.h"
#include "trivet/study/optimize/sampled_starts.h"
#include "trivet/study/requirements/margin.h"
#include "trivet/study/select/mount_combinations.h"
#include "trivet/study/select/mount_prices.h"

namespace trivet::study {
namespace {

/// So many times the combinations that are optimised are judged completely with a few numbers.
constexpr std::size_t considered_per_optimized = 4;
constexpr std::size_t listed_others = 4;

/// Numbers at which each combination is looked at: a combination that has no chance with the given ones (a margin of 0
/// has no slope) may be the best with others. So many by a family, of which the best few are judged completely; and so
/// many without one.
constexpr std::size_t looks_by_family = 1024, judged_looks = 8;
/// Combinations are ordered by their bounds at so many numbers, the given ones in addition; fewer if there are so many
/// combinations that bounds would take longer than a few seconds.
constexpr std::size_t numbers_for_bounds = 8, most_bounds = 2000000;

using numerics::MaxMinPoint;
using numerics::MaxMinProblem;

/// A copy of the project whose only choices are those that take part.
project::Project with_choices_of(const project::Project& project, const project::OptimizeRequest& request) {
  project::Project result = project;
  const auto idle = [&](const project::MountChoice& choice) { return !request.varies(choice.name); };
  for (project::Case& variant : result.cases) std::erase_if(variant.analyses.choices, idle);
  return result;
}

class Combinations {
 public:
  Combinations(const project::Project& project, const project::OptimizeRequest& request,
               const foundation::Progress& progress, const std::function<bool()>& enough)
      : project_(project),
        request_(request),
        progress_(progress),
        enough_(enough),
        space_(project, request.parameters),
        all_(project, deciding_cases(project)) {}

  MountSearch search() {
    return request_.minimized == project::Minimized::price ? cheapest_first() : best_bounds_first();
  }

 private:
  struct Reached {
    std::size_t combination = 0;
    double constraint = -foundation::infinity;  ///< ln of the least margin of what has to be met, at most 0
    double merit = -foundation::infinity;       ///< the least margin, or minus what is minimised
    double margin = 0;                          ///< least one, if the price is minimised
    Eigen::VectorXd numbers;                    ///< as shares of their ranges
    std::string reason;                         ///< why it cannot be judged
    bool ended = false;                         ///< the search ended before its numbers were tried

    [[nodiscard]] bool meets() const { return constraint == 0; }
    [[nodiscard]] bool is_better_than(const Reached& other) const {
      if (constraint != other.constraint) return constraint > other.constraint;
      return merit != other.merit ? merit > other.merit : margin > other.margin;
    }
  };

  MountSearch best_bounds_first() const {
    const auto most = to_size(request_.combinations);
    std::vector<Bounded> order = by_bound();
    order.resize(std::min(order.size(), considered_per_optimized * most));
    std::vector<std::size_t> promising;
    for (const Bounded& one : order) promising.push_back(one.combination);
    std::vector<Reached> considered;
    if (promising.size() > most) {
      const std::vector<Eigen::VectorXd> tried = numbers_to_try();
      considered =
          reached(promising, "mounts with a few numbers", [&](std::size_t place, const DesignObjective& objective) {
            const MaxMinProblem problem = search_problem(objective);
            MaxMinPoint best = numerics::point_at(problem, given_shares(objective));
            if (const std::size_t numbers = order[place].numbers; numbers > 0)
              if (MaxMinPoint other = numerics::point_at(problem, tried[numbers - 1]); rank(other) > rank(best))
                best = std::move(other);
            return best;
          });
      promising.clear();
      for (const Reached& one : considered) promising.push_back(one.combination);
      promising.resize(most);
    }
    std::vector<Reached> optimized = with_best_numbers(promising);
    keep_considered(considered, optimized);
    refuse_hopeless(optimized);
    return described(optimized, order.size());
  }

  /// Combinations whose numbers the search did not come to keep what they reached with a few numbers.
  static void keep_considered(const std::vector<Reached>& considered, std::vector<Reached>& optimized) {
    for (Reached& one : optimized) {
      if (!one.ended) continue;
      const auto before = std::ranges::find(considered, one.combination, &Reached::combination);
      if (before == considered.end()) continue;
      one = *before;
      one.ended = true;
    }
    std::ranges::stable_sort(optimized, [](const Reached& a, const Reached& b) { return a.is_better_than(b); });
  }

  /// The numbers of the cheapest are optimised, then those of the next, until some meet every requirement.
  MountSearch cheapest_first() {
    prices_.emplace(all_, *all_.cases().front());
    std::vector<std::size_t> order;
    for (const Bounded& one : by_bound()) order.push_back(one.combination);
    std::vector<double> price(all_.count());
    for (std::size_t i = 0; i < price.size(); ++i) price[i] = prices_->of(i).amount;
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return price[a] < price[b]; });
    order.resize(std::min(order.size(), to_size(request_.combinations)));
    constexpr std::size_t batch = 32;
    std::vector<Reached> optimized;
    double cheapest = foundation::infinity;  // of those that meet every requirement
    for (std::size_t first = 0; first < order.size() && price[order[first]] <= cheapest; first += batch) {
      const auto from = order.begin() + static_cast<std::ptrdiff_t>(first);
      const auto size = static_cast<std::ptrdiff_t>(std::min(batch, order.size() - first));
      const std::vector<Reached> found = with_best_numbers({from, from + size});
      optimized.insert(optimized.end(), found.begin(), found.end());
      if (found.front().meets()) cheapest = std::min(cheapest, price[found.front().combination]);
    }
    std::ranges::stable_sort(optimized, [](const Reached& a, const Reached& b) { return a.is_better_than(b); });
    refuse_hopeless(optimized);
    return described(optimized, optimized.size());
  }

  [[nodiscard]] std::vector<Reached> with_best_numbers(const std::vector<std::size_t>& combinations) const {
    return reached(combinations, "numbers for each combination of mounts",
                   [](std::size_t, const DesignObjective& objective) {
                     const MaxMinProblem problem = search_problem(objective);
                     const Eigen::VectorXd given = given_shares(objective);
                     MaxMinPoint best = numerics::max_min(problem, given);
                     const MaxMinPoint look = best_look(problem, objective);
                     if (look.objective <= DesignObjective::unusable) return best;
                     if (MaxMinPoint other = numerics::max_min(problem, look.x); rank(other) > rank(best))
                       best = std::move(other);
                     return best;
                   });
  }

  /// The best of a few designs of one combination, spread over the ranges of the numbers.
  static MaxMinPoint best_look(const MaxMinProblem& problem, const DesignObjective& objective) {
    const foundation::ThreadLimit alone(1);  // combinations are done at once
    MaxMinPoint best;
    for (const Eigen::VectorXd& point : sampled_starts(objective, judged_looks, {}, looks_by_family).points)
      if (MaxMinPoint look = numerics::point_at(problem, point); best.x.size() == 0 || rank(look) > rank(best))
        best = std::move(look);
    return best;
  }

  /// A combination with its largest bound over a few numbers.
  struct Bounded {
    std::size_t combination = 0;
    double margin = 0;
    std::size_t numbers = 0;  ///< with this bound: 0 the given ones, else one more than their place in numbers_to_try()
  };

  /// All combinations by descending bound.
  [[nodiscard]] std::vector<Bounded> by_bound() const {
    const std::vector<std::size_t> all = all_.all();
    std::vector<Bounded> order(all.size());
    const auto add = [&](const MountCombinations& there, std::size_t numbers) {
      const std::vector<MountCombinations::Bound> bounds = there.bounds(all, progress_);
      for (std::size_t i = 0; i < all.size(); ++i)
        if (numbers == 0 || bounds[i].margin > order[i].margin) order[i] = {all[i], bounds[i].margin, numbers};
    };
    add(all_, 0);
    if (all.size() > to_size(request_.combinations)) {
      const std::vector<Eigen::VectorXd> tried = numbers_to_try();
      for (std::size_t k = 0; k < tried.size(); ++k) try {
          if (const auto project = with_numbers(tried[k])) add({*project, deciding_cases(*project)}, k + 1);
        } catch (const foundation::InvalidInput&) {  // a mount cannot be used with these numbers
        }
    }
    // Of equal bounds, or without any, not the first of the catalogue come first: an order without meaning.
    const auto scattered = [](std::size_t combination) {
      constexpr std::uint64_t golden = 0x9E3779B97F4A7C15U;  // 2⁶⁴ times the golden section, odd
      return golden * combination;
    };
    std::ranges::sort(order, [&](const Bounded& a, const Bounded& b) {
      return a.margin != b.margin ? a.margin > b.margin : scattered(a.combination) < scattered(b.combination);
    });
    return order;
  }

  [[nodiscard]] std::vector<Eigen::VectorXd> numbers_to_try() const {
    const Eigen::MatrixXd points = sobol_points(
        to_index(space_.size()), std::clamp(most_bounds / all_.count(), std::size_t{1}, numbers_for_bounds));
    std::vector<Eigen::VectorXd> shares;
    for (Eigen::Index i = 0; i < points.rows(); ++i) shares.emplace_back(points.row(i).transpose());
    return shares;
  }

  /// The project with other numbers; none if a model is not valid then.
  [[nodiscard]] std::optional<project::Project> with_numbers(const Eigen::VectorXd& shares) const {
    const std::vector<project::Node> changes = space_.changes(shares);
    project::Project result{project_.title, project_.source, project_.folder, project_.sha256, {}};
    for (const project::Case& variant : project_.cases) {
      auto changed = judging::changed_case(variant, changes);
      if (!changed) return std::nullopt;
      result.cases.push_back(std::move(*changed));
    }
    return result;
  }

  static Eigen::VectorXd given_shares(const DesignObjective& objective) {
    Eigen::VectorXd shares(to_index(objective.space().size()));
    constexpr double middle = 0.5;  // of a parameter whose places have different values
    for (std::size_t j = 0; j < objective.space().size(); ++j) {
      const auto& value = objective.space().given()[j];
      shares(to_index(j)) = value ? std::clamp(objective.space().axes()[j].share(*value), 0.0, 1.0) : middle;
    }
    return shares;
  }

  /// What each combination reaches, the best first.
  template <typename Point>
  [[nodiscard]] std::vector<Reached> reached(const std::vector<std::size_t>& combinations, const char* task,
                                             const Point& point) const {
    std::vector<Reached> result(combinations.size());
    foundation::parallel_for(
        combinations.size(), {.progress = progress_, .task = task}, [&](std::size_t first, std::size_t last) {
          for (std::size_t i = first; i < last; ++i) {
            result[i].combination = combinations[i];
            if (enough_ && enough_()) {
              result[i].ended = true;
              continue;
            }
            try {
              const project::Project here = all_.project(project_, combinations[i]);
              const DesignObjective objective(here, request_);
              const MaxMinPoint found = point(i, objective);
              result[i].numbers = found.x;
              const double to_meet = prices_ ? found.objective : found.constraint;
              result[i].constraint = to_meet >= least_met ? 0 : to_meet;
              if (found.objective <= DesignObjective::unusable) {
                result[i].reason = why_unusable(objective, found);
              } else if (prices_) {
                result[i].merit = -prices_->of(combinations[i]).amount;
                result[i].margin = reported_objective(objective, found.objective);
              } else {
                result[i].merit = (minimizes() ? -1 : 1) * reported_objective(objective, found.objective);
              }
            } catch (const foundation::NotComputable& refused) {
              result[i].reason = refused.what();
            }
          }
        });
    std::ranges::stable_sort(result, [](const Reached& a, const Reached& b) { return a.is_better_than(b); });
    return result;
  }

  /// Why a design has no margin above 0.
  static std::string why_unusable(const DesignObjective& objective, const MaxMinPoint& found) {
    if (const std::string failure = objective.counts().first_failure; !failure.empty()) return failure;
    Eigen::VectorXd values;
    search_problem(objective).evaluate(found.x, values, nullptr);
    Eigen::Index least = 0;
    values.minCoeff(&least);
    return "the margin of \"" + objective.words(objective.places()[least]) + "\" is 0 with all numbers that were tried";
  }

  void refuse_hopeless(const std::vector<Reached>& optimized) const {
    const Reached& best = optimized.front();
    if (std::isfinite(best.constraint) && best.merit > -foundation::infinity) return;
    if (std::any_of(optimized.begin(), optimized.end(), [](const Reached& one) { return one.ended; }))
      throw foundation::NotComputable(
          "optimize: ended before a combination of mounts with a design that can be judged was found; give it more "
          "time");
    std::string mounts;
    for (std::size_t c = 0; c < all_.choices().size(); ++c)
      mounts +=
          (c ? ", " : "") + all_.choices()[c].name + " = " + all_.choices()[c].mounts[all_.mount(best.combination, c)];
    throw foundation::NotComputable("optimize: no combination of mounts has a design that can be judged; with " +
                                    mounts + ": " + best.reason +
                                    "; widen the ranges, let other mounts take part, or change the requirement");
  }

  [[nodiscard]] MountSearch described(const std::vector<Reached>& optimized, std::size_t considered) const {
    MountSearch result;
    result.best = all_.project(project_, optimized.front().combination);
    result.numbers = optimized.front().numbers;
    OptimizedMounts& found = result.found;
    found.choices = all_.choices();
    found.chosen = all_.mounts(optimized.front().combination);
    found.combinations = all_.count();
    found.considered = considered;
    found.optimized = to_size(std::ranges::count_if(optimized, [](const Reached& one) { return !one.ended; }));
    if (prices_) found.price = prices_->of(optimized.front().combination);
    found.some_met = prices_ && optimized.front().meets();
    for (std::size_t i = 1; i < optimized.size() && i <= listed_others; ++i) {
      if (optimized[i].constraint < 0 || std::isinf(optimized[i].merit)) break;  // a requirement is violated
      found.others.push_back({all_.mounts(optimized[i].combination), std::abs(optimized[i].merit)});
    }
    return result;
  }

  [[nodiscard]] bool minimizes() const { return !request_.minimize.empty(); }

  const project::Project& project_;
  const project::OptimizeRequest& request_;
  const foundation::Progress& progress_;
  const std::function<bool()>& enough_;
  DesignSpace space_;
  MountCombinations all_;
  std::optional<MountPrices> prices_;  ///< if their sum is minimised
};

}  // namespace

std::optional<MountSearch> mount_search(const project::Project& project, const project::OptimizeRequest& request,
                                        const foundation::Progress& progress, const std::function<bool()>& enough) {
  const project::Project chosen = with_choices_of(project, request);
  if (chosen.base().analyses.choices.empty()) return std::nullopt;
  return Combinations(chosen, request, progress, enough).search();
}

}  // namespace trivet::study
