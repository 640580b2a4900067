// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/mount_search.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/study/design_search.h"
#include "trivet/study/mount_combinations.h"

namespace trivet::study {
namespace {

/// So many times the combinations that are optimised are judged completely with the given numbers.
constexpr std::size_t considered_per_optimized = 4;
constexpr std::size_t listed_others = 4;
constexpr double met_requirements = -1e-9;  // ln of a margin

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
    const std::vector<Reached> optimized =
        reached(promising, "numbers for each combination of mounts", [](const DesignObjective& objective) {
          return numerics::max_min(search_problem(objective), given_shares(objective));
        });
    refuse_hopeless(optimized);
    return described(optimized, order.size());
  }

 private:
  struct Reached {
    std::size_t combination = 0;
    double constraint = -foundation::infinity;  ///< ln of the least margin of what has to be met, at most 0
    double merit = -foundation::infinity;       ///< the least margin, or minus what is minimised
    std::string reason;                         ///< why it cannot be judged

    [[nodiscard]] bool is_better_than(const Reached& other) const {
      return constraint != other.constraint ? constraint > other.constraint : merit > other.merit;
    }
  };

  [[nodiscard]] std::vector<std::size_t> by_bound() const {
    std::vector<std::size_t> order = all_.all();
    const std::vector<MountCombinations::Bound> bounds = all_.bounds(order, progress_);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return bounds[a].margin > bounds[b].margin; });
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
              result[i].constraint = found.constraint >= met_requirements ? 0 : found.constraint;
              if (found.objective <= DesignObjective::unusable)
                result[i].reason = objective.first_failure().empty() ? "a margin is 0" : objective.first_failure();
              else result[i].merit = (minimizes() ? -1 : 1) * reported_objective(objective, found.objective);
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
    if (std::isfinite(optimized.front().constraint)) return;
    throw foundation::NotComputable("optimize: no combination of mounts can be judged: " + optimized.front().reason);
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
};

}  // namespace

std::optional<MountSearch> mount_search(const project::Project& project, const project::OptimizeRequest& request,
                                        const foundation::Progress& progress) {
  const project::Project chosen = with_choices_of(project, request);
  if (chosen.base().analyses.choices.empty()) return std::nullopt;
  return Combinations(chosen, request, progress).search();
}

}  // namespace trivet::study
