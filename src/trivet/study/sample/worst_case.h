// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/study/sample/margin_descent.h"
#include "trivet/study/sample/sample.h"
#include "trivet/study/sample/sampled_case.h"

namespace trivet::study {

/// The design with the least margin of a requirement that a search within the tolerances found.
struct WorstFound {
  double margin = 0;
  Eigen::VectorXd draws;
  bool is_corner = false;       ///< every drawn number is at an end of its range
  std::size_t at_ends = 0;      ///< drawn numbers that are
  bool ended = true;            ///< no step along the slopes or along one number lowers the margin
  std::uint64_t looked_at = 0;  ///< designs that were judged for it
};

struct WorstSearch {
  bool all_corners = false;
  std::uint64_t corners = 0, inside = 0;    ///< designs that begin the search, the same for all requirements
  std::uint64_t failed = 0;                 ///< designs of all searches without a model, or that cannot be judged
  std::string first_failure;                ///< the reason of the first
  Eigen::VectorXd first_failed;             ///< its draws
  std::vector<std::vector<WorstFound>> of;  ///< per case and requirement
};

/// Draws of designs, per case and requirement.
using WorstStarts = std::vector<std::vector<std::vector<Eigen::VectorXd>>>;

/// The range of a drawn number in which the worst design is searched: the whole one, or of an unbounded one that of all
/// but `beyond_worst_range` of its numbers.
[[nodiscard]] DrawRange worst_range(const numerics::Distribution& distribution);
/// These ranges of all draws.
[[nodiscard]] DrawBox worst_box(const DrawnDesigns& drawn);

/// Searches the least margin of each requirement in a box: all corners of up to twelve draws, else
/// 4096 of them and the one that the slopes of the given design point to; 1024 designs inside; and descents of the
/// margin from the worst of both, from the given design and from `starts`. A search, no proof. The same for any number
/// of threads.
/// @param starts  of each requirement, designs that are known to have small margins; the nearest in the box are taken
[[nodiscard]] WorstSearch worst_search(const std::vector<SampledCase>& cases, const DrawBox& box,
                                       const WorstStarts& starts, std::uint64_t seed,
                                       const foundation::Progress& progress);

}  // namespace trivet::study
