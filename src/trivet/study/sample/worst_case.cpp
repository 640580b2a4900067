// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/sample/worst_case.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "trivet/foundation/index.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/numerics/sampling/sobol_numbers.h"

namespace trivet::study {
namespace {

constexpr std::size_t most_for_all_corners = 12;  // draws
constexpr Eigen::Index sampled_corners = 4096, inside_points = 1024;
constexpr double same_worst_margin = 1e-9;                      // relative: a corner is preferred
constexpr std::uint64_t scramble = project::sample_replicates;  // independent of the drawn designs

/// All corners, or some of them: the nearest ones of Sobol's points.
DrawPlaces corners(const DrawBox& box, const numerics::SobolNumbers& sobol) {
  const Eigen::Index n = box.draws();
  const bool all = to_size(n) <= most_for_all_corners;
  DrawPlaces found(all ? Eigen::Index{1} << n : sampled_corners, n);
  Eigen::VectorXd point(n);
  for (Eigen::Index i = 0; i < found.rows(); ++i) {
    if (!all) sobol.set_point(to_size(inside_points + i), {point.data(), to_size(n)});
    for (Eigen::Index d = 0; d < n; ++d) found(i, d) = all ? static_cast<double>((i >> d) & 1) : std::round(point(d));
  }
  return found;
}

DrawPlaces points_inside(const DrawBox& box, const numerics::SobolNumbers& sobol) {
  DrawPlaces found(inside_points, box.draws());
  Eigen::VectorXd point(box.draws());
  for (Eigen::Index i = 0; i < found.rows(); ++i) {
    sobol.set_point(to_size(i), {point.data(), to_size(point.size())});
    found.row(i) = point.transpose();
  }
  return found;
}

/// The search over all requirements.
class WorstDesigns {
 public:
  WorstDesigns(const std::vector<SampledCase>& cases, const DrawBox& box, const WorstStarts& starts, std::uint64_t seed,
               const foundation::Progress& progress)
      : cases_(cases), box_(box), starts_(starts), progress_(progress) {
    const numerics::SobolNumbers sobol(to_size(box.draws()), seed, scramble);
    const DrawPlaces ends = corners(box_, sobol), inside = points_inside(box_, sobol);
    corners_ = ends.rows();
    places_.resize(1 + ends.rows() + inside.rows(), box_.draws());
    places_ << box_.given().transpose(), ends, inside;
  }

  WorstSearch run() {
    WorstSearch found{.all_corners = to_size(box_.draws()) <= most_for_all_corners,
                      .corners = to_size(corners_),
                      .inside = to_size(inside_points)};
    judge_first(found);
    std::vector<std::pair<std::size_t, std::size_t>> tasks;
    for (std::size_t c = 0; c < cases_.size(); ++c) {
      found.of.emplace_back(cases_[c].given().size());
      for (std::size_t r = 0; r < cases_[c].given().size(); ++r) tasks.emplace_back(c, r);
    }
    std::vector<Failures> failures(tasks.size());
    foundation::parallel_for(tasks.size(), {.size = 1, .progress = progress_, .task = "worst designs"},
                             [&](std::size_t from, std::size_t to) {
                               for (std::size_t i = from; i < to; ++i) {
                                 const auto& [c, r] = tasks[i];
                                 found.of[c][r] = worst(c, to_index(r), failures[i]);
                               }
                             });
    for (const Failures& one : failures) {
      if (found.failed == 0 && one.count > 0) found.first_failure = one.reason, found.first_failed = one.draws;
      found.failed += one.count;
    }
    return found;
  }

 private:
  /// Designs of a search that cannot be judged, and the first of them.
  struct Failures {
    std::uint64_t count = 0;
    std::string reason;
    Eigen::VectorXd draws;
  };

  /// Designs that begin the searches of all requirements.
  void judge_first(WorstSearch& found) {
    for (const SampledCase& one : cases_) margins_.emplace_back(places_.rows(), to_index(one.given().size()));
    std::vector<std::string> failures(to_size(places_.rows()));
    foundation::parallel_for(
        to_size(places_.rows()),
        {.size = SampledCase::kernel_piece, .progress = progress_, .task = "corners and designs inside"},
        [&](std::size_t from, std::size_t to) {
          const Eigen::MatrixXd draws = box_.at(places_.middleRows(to_index(from), to_index(to - from)));
          for (std::size_t c = 0; c < cases_.size(); ++c) {
            const SampledMargins part = cases_[c].judged(draws);
            margins_[c].middleRows(to_index(from), draws.rows()) =
                part.margins.isNaN().select(std::numeric_limits<double>::infinity(), part.margins);
            for (std::size_t i = from; i < to; ++i)
              if (failures[i].empty()) failures[i] = part.failures[i - from];
          }
        });
    for (std::size_t i = 0; i < failures.size(); ++i) {
      if (failures[i].empty() || found.failed++ > 0) continue;
      found.first_failure = failures[i];
      found.first_failed = box_.at(places_.row(to_index(i))).row(0).transpose();
    }
  }

  [[nodiscard]] MarginDescent::Place worst_in(const Eigen::ArrayXd& margins, Eigen::Index first,
                                              Eigen::Index count) const {
    Eigen::Index least = 0;
    const double margin = margins.segment(first, count).minCoeff(&least);
    return {places_.row(first + least).transpose(), margin};
  }

  WorstFound worst(std::size_t c, Eigen::Index requirement, Failures& failures) const {
    MarginDescent search(cases_[c], requirement, box_);
    const Eigen::ArrayXd margins = margins_[c].col(requirement);
    const MarginDescent::Place given{box_.given(), margins(0)};
    std::vector<MarginDescent::Place> starts = {worst_in(margins, 1, corners_)};
    if (to_size(box_.draws()) > most_for_all_corners) starts.push_back(search.pointed_corner(given));
    starts.push_back(worst_in(margins, 1 + corners_, inside_points));
    starts.push_back(given);
    for (const Eigen::VectorXd& known : starts_[c][to_size(requirement)])
      starts.push_back(search.judged(box_.place(known)));
    MarginDescent::Place worst;
    for (std::size_t s = 0; s < starts.size(); ++s) {
      const MarginDescent::Place found = search.run(starts[s]);
      const bool lower = found.margin < worst.margin &&
          !(std::abs(worst.margin - found.margin) <= same_worst_margin * std::abs(found.margin));
      if (s == 0 || lower) worst = found;
    }
    failures = {search.failed, search.first_failure, search.first_failed};
    WorstFound found{.margin = worst.margin,
                     .draws = box_.at(worst.at.transpose()).row(0).transpose(),
                     .ended = worst.ended,
                     .looked_at = search.looked_at + to_size(places_.rows())};
    found.at_ends = to_size((worst.at.array() == 0 || worst.at.array() == 1).count());
    found.is_corner = found.at_ends == to_size(box_.draws());
    return found;
  }

  const std::vector<SampledCase>& cases_;
  const DrawBox& box_;
  const WorstStarts& starts_;
  const foundation::Progress& progress_;
  Eigen::Index corners_ = 0;
  DrawPlaces places_;                     ///< the given design, corners, designs inside
  std::vector<Eigen::ArrayXXd> margins_;  ///< of these, per case
};

}  // namespace

DrawRange worst_range(const numerics::Distribution& distribution) {
  const auto [from, to] = numerics::ends(distribution);
  return {std::isfinite(from) ? from : numerics::quantile(distribution, beyond_worst_range / 2),
          std::isfinite(to) ? to : numerics::quantile(distribution, 1 - beyond_worst_range / 2)};
}

DrawBox worst_box(const DrawnDesigns& drawn) {
  std::vector<DrawRange> ranges;
  Eigen::VectorXd given(to_index(drawn.draws()));
  for (std::size_t d = 0; d < drawn.draws(); ++d) {
    ranges.push_back(worst_range(drawn.distribution(d)));
    given(to_index(d)) = drawn.distribution(d).mean;
  }
  return {std::move(ranges), given};
}

WorstSearch worst_search(const std::vector<SampledCase>& cases, const DrawBox& box, const WorstStarts& starts,
                         std::uint64_t seed, const foundation::Progress& progress) {
  return WorstDesigns(cases, box, starts, seed, progress).run();
}

}  // namespace trivet::study
