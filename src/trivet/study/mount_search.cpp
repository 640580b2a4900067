// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/mount_search.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/study/design_search.h"
#include "trivet/study/margin.h"
#include "trivet/study/mount_combinations.h"
#include "trivet/study/mount_prices.h"

namespace trivet::study {
namespace {

/// So many times the combinations that are optimised are judged completely with the given numbers.
constexpr std::size_t considered_per_optimized = 4;
constexpr std::size_t listed_others = 4;

using numerics::MaxMinPoint;

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
               const foundation::Progress& progress)
      : project_(project), request_(request), progress_(progress), all_(project, deciding_cases(project)) {}

  MountSearch search() {
    return request_.minimized == project::Minimized::price ? cheapest_first() : best_bounds_first();
  }

 private:
  struct Reached {
    std::size_t combination = 0;
    double constraint = -foundation::infinity;  ///< ln of the least margin of what has to be met, at most 0
    double merit = -foundation::infinity;       ///< the least margin, or minus what is minimised
    double margin = 0;                          ///< least one, if the price is minimised
    std::string reason;                         ///< why it cannot be judged

    [[nodiscard]] bool meets() const { return constraint == 0; }
    [[nodiscard]] bool is_better_than(const Reached& other) const {
      if (constraint != other.constraint) return constraint > other.constraint;
      return merit != other.merit ? merit > other.merit : margin > other.margin;
    }
  };

  MountSearch best_bounds_first() const {
    const auto most = to_size(request_.combinations);
    std::vector<std::size_t> order = by_bound();
    order.resize(std::min(order.size(), considered_per_optimized * most));
    const std::vector<Reached> considered =
        reached(order, "mounts with the given numbers", [](const DesignObjective& objective) {
          return numerics::point_at(search_problem(objective), given_shares(objective));
        });
    std::vector<std::size_t> promising;
    for (const Reached& one : considered) promising.push_back(one.combination);
    promising.resize(std::min(promising.size(), most));
    const std::vector<Reached> optimized = with_best_numbers(promising);
    refuse_hopeless(optimized);
    return described(optimized, order.size());
  }

  /// The numbers of the cheapest are optimised, then those of the next, until some meet every requirement.
  MountSearch cheapest_first() {
    prices_.emplace(all_, *all_.cases().front());
    std::vector<std::size_t> order = by_bound();
    std::vector<double> price(all_.count());
    for (std::size_t i = 0; i < price.size(); ++i) price[i] = prices_->of(i).amount;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return price[a] < price[b]; });
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
    std::stable_sort(optimized.begin(), optimized.end(),
                     [](const Reached& a, const Reached& b) { return a.is_better_than(b); });
    refuse_hopeless(optimized);
    return described(optimized, optimized.size());
  }

  [[nodiscard]] std::vector<Reached> with_best_numbers(const std::vector<std::size_t>& combinations) const {
    return reached(combinations, "numbers for each combination of mounts", [](const DesignObjective& objective) {
      return numerics::max_min(search_problem(objective), given_shares(objective));
    });
  }

  [[nodiscard]] std::vector<std::size_t> by_bound() const {
    std::vector<std::size_t> order = all_.all();
    const std::vector<MountCombinations::Bound> bounds = all_.bounds(order, progress_);
    // Of equal bounds, or without any, not the first of the catalogue come first: an order without meaning.
    const auto scattered = [](std::size_t combination) {
      constexpr std::uint64_t golden = 0x9E3779B97F4A7C15U;  // 2⁶⁴ times the golden section, odd
      return golden * combination;
    };
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return bounds[a].margin != bounds[b].margin ? bounds[a].margin > bounds[b].margin : scattered(a) < scattered(b);
    });
    return order;
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
            try {
              const project::Project here = all_.project(project_, combinations[i]);
              const DesignObjective objective(here, request_);
              const MaxMinPoint found = point(objective);
              const double to_meet = prices_ ? found.objective : found.constraint;
              result[i].constraint = to_meet >= least_met ? 0 : to_meet;
              if (found.objective <= DesignObjective::unusable) {
                result[i].reason = objective.first_failure().empty() ? "a margin is 0" : objective.first_failure();
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
    std::stable_sort(result.begin(), result.end(),
                     [](const Reached& a, const Reached& b) { return a.is_better_than(b); });
    return result;
  }

  static void refuse_hopeless(const std::vector<Reached>& optimized) {
    const Reached& best = optimized.front();
    if (std::isfinite(best.constraint) && best.merit > -foundation::infinity) return;
    throw foundation::NotComputable("optimize: no combination of mounts can be judged: " + best.reason);
  }

  [[nodiscard]] MountSearch described(const std::vector<Reached>& optimized, std::size_t considered) const {
    MountSearch result;
    result.best = all_.project(project_, optimized.front().combination);
    OptimizedMounts& found = result.found;
    found.choices = all_.choices();
    found.chosen = all_.mounts(optimized.front().combination);
    found.combinations = all_.count();
    found.considered = considered;
    found.optimized = optimized.size();
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
  MountCombinations all_;
  std::optional<MountPrices> prices_;  ///< if their sum is minimised
};

}  // namespace

std::optional<MountSearch> mount_search(const project::Project& project, const project::OptimizeRequest& request,
                                        const foundation::Progress& progress) {
  const project::Project chosen = with_choices_of(project, request);
  if (chosen.base().analyses.choices.empty()) return std::nullopt;
  return Combinations(chosen, request, progress).search();
}

}  // namespace trivet::study
