// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/numerics/search/max_min.h"
#include "trivet/study/optimize/design_objective.h"
#include "trivet/study/optimize/sampled_starts.h"
#include "trivet/study/shared/shared_work.h"

namespace trivet::study {

// Where the best designs are: looks over the ranges, climbs, and what they reached.

/// What a caller adds to a search.
struct SearchOptions {
  std::optional<int> starts = {};          ///< climbs; none: as many as are usual for the time that a design takes
  std::vector<Eigen::VectorXd> also = {};  ///< further starts, as shares
  std::size_t among = sampled_designs;     ///< designs judged by kernels, among which the starts are chosen
  /// True if the search is to end with the best design so far; called between designs, on any thread.
  std::function<bool()> enough = {};
  SharedWork* shared = nullptr;  ///< looks and climbs together with other processes; null: alone
};

struct DesignSearch {
  numerics::MaxMinProblem problem;  ///< that was climbed last: as requested, or of the requirements alone
  numerics::MaxMinPoint best;       ///< of equally good ends the nearest one to the given design
  std::vector<numerics::MaxMinPoint> ends;
  int starts = 0;
  int finished = 0;           ///< climbs, of `starts`, that came to their end
  std::size_t looked_at = 0;  ///< designs judged by kernels before, see sampled_starts.h
  bool cut_short = false;     ///< ended by `enough`
  bool falls_short = false;   ///< no end met the requirements: `problem` is their largest least margin
};

/// @param objective  used by the result
/// @throws foundation::NotComputable if no design can be computed, or none is better than another
[[nodiscard]] DesignSearch design_search(const DesignObjective& objective, const SearchOptions& options,
                                         const foundation::Progress& progress);

/// The search as requested.
[[nodiscard]] numerics::MaxMinProblem search_problem(const DesignObjective& objective);

/// The objective of such a search as it is reported: the least margin, the largest amplitude or share, the weighted
/// sum.
[[nodiscard]] double reported_objective(const DesignObjective& objective, double of_search);

/// The largest least margin of the requirements, whatever is minimised.
/// @param ignored  a requirement that counts as met
[[nodiscard]] numerics::MaxMinProblem problem_of_requirements(
    const DesignObjective& objective, const std::optional<DesignObjective::Place>& ignored = std::nullopt);

/// How many designs are judged completely before climbing.
[[nodiscard]] int looks_for(int starts);

/// The best looks that lie apart, at most `starts`.
[[nodiscard]] std::vector<numerics::MaxMinPoint> chosen_starts(std::vector<numerics::MaxMinPoint> looks,
                                                               std::size_t starts);

/// The weighted sum at the given design, in which a search counts it; 1 if it is unbounded there.
[[nodiscard]] double weighted_unit(const DesignObjective& objective);

/// Violated constraints first count, then the objective.
[[nodiscard]] double rank(const numerics::MaxMinPoint& point);

/// Ends this near in rank are equally good.
inline constexpr double same_objective = 1e-5;

/// True if a population can be judged: families cover every case, and the objective is a least margin.
[[nodiscard]] bool can_evolve(const DesignObjective& objective);

/// The best designs of a population that evolved through the families of designs, some ten thousand designs without
/// their models: differential evolution towards the best ones (Zhang, J.; Sanderson, A. C.: JADE: adaptive differential
/// evolution with optional external archive. IEEE Trans. Evol. Comput. 13 (2009) 945–958; without the archive). It
/// finds designs between local optima that climbs from single points miss. The same for any number of threads.
/// @param first  the population before, as shares; more than 4 designs
/// @returns at most `wanted`, the best first, that lie apart
[[nodiscard]] std::vector<Eigen::VectorXd> evolved_designs(const DesignObjective& objective,
                                                           const std::vector<Eigen::VectorXd>& first,
                                                           std::size_t wanted, const foundation::Progress& progress);

/// Finds a point for each item of a task, on several threads, and in several processes if they share the search.
using FindPoints = std::function<std::vector<numerics::MaxMinPoint>(
    std::size_t count, std::string_view task, const std::function<numerics::MaxMinPoint(std::size_t item)>& find)>;

/// Local maxima of a problem of one variable whose values take long, each by Brent's method between the neighbours of a
/// point that is the best near it. No slopes are needed.
/// @param known  points that were judged, some of them near every maximum worth finding; at least one
/// @param most   so many of the best of them are refined
/// @returns the best point of each, in the order of `known` by rank; without a rise between neighbours the known one
[[nodiscard]] std::vector<numerics::MaxMinPoint> maxima_on_a_line(const numerics::MaxMinProblem& problem,
                                                                  std::vector<numerics::MaxMinPoint> known,
                                                                  std::size_t most, const FindPoints& find);

}  // namespace trivet::study
