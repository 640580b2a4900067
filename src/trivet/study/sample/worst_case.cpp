// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/sample/worst_case.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "trivet/foundation/index.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/numerics/sampling/sobol_numbers.h"

namespace trivet::study {
namespace {

constexpr std::size_t most_for_all_corners = 12;  // draws
constexpr Eigen::Index sampled_corners = 4096, inside_points = 1024;
constexpr Eigen::Index piece = 120;                             // designs, which kernels judge at once
constexpr int steps = 20;                                       // of a line, each half the one before
constexpr int most_rounds = 200;                                // of a descent
constexpr double difference = 1e-4;                             // of the width of a range, for slopes
constexpr double least_gain = 1e-10;                            // of the margin, for another round
constexpr double same_worst_margin = 1e-9;                      // relative: a corner is preferred
constexpr std::uint64_t scramble = project::sample_replicates;  // independent of the drawn designs

using Places = Eigen::MatrixXd;  // designs × draws, 0 … 1 in their ranges

/// Numbers in the box of all ranges.
class Box {
 public:
  explicit Box(const DrawnDesigns& drawn) : given_(to_index(drawn.draws())) {
    for (std::size_t d = 0; d < drawn.draws(); ++d) {
      ranges_.push_back(worst_range(drawn.distribution(d)));
      const DrawRange& range = ranges_.back();
      const double width = range.to - range.from, mean = drawn.distribution(d).mean;
      given_(to_index(d)) = width > 0 ? std::clamp((mean - range.from) / width, 0.0, 1.0) : 0;
    }
  }

  [[nodiscard]] Eigen::Index draws() const { return given_.size(); }
  /// The design of the file; of a batch that does not contain it the nearest one that is in its range.
  [[nodiscard]] const Eigen::VectorXd& given() const { return given_; }
  /// Exact at the ends, where the range of the kernels ends too.
  [[nodiscard]] Eigen::MatrixXd at(const Places& places) const {
    Eigen::MatrixXd numbers(places.rows(), places.cols());
    for (Eigen::Index d = 0; d < places.cols(); ++d)
      for (Eigen::Index i = 0; i < places.rows(); ++i)
        numbers(i, d) = std::lerp(ranges_[to_size(d)].from, ranges_[to_size(d)].to, places(i, d));
    return numbers;
  }

 private:
  std::vector<DrawRange> ranges_;
  Eigen::VectorXd given_;
};

/// All corners, or some of them: the nearest ones of Sobol's points.
Places corners(const Box& box, const numerics::SobolNumbers& sobol) {
  const Eigen::Index n = box.draws();
  const bool all = to_size(n) <= most_for_all_corners;
  Places found(all ? Eigen::Index{1} << n : sampled_corners, n);
  Eigen::VectorXd point(n);
  for (Eigen::Index i = 0; i < found.rows(); ++i) {
    if (!all) sobol.set_point(to_size(inside_points + i), {point.data(), to_size(n)});
    for (Eigen::Index d = 0; d < n; ++d) found(i, d) = all ? static_cast<double>((i >> d) & 1) : std::round(point(d));
  }
  return found;
}

Places points_inside(const Box& box, const numerics::SobolNumbers& sobol) {
  Places found(inside_points, box.draws());
  Eigen::VectorXd point(box.draws());
  for (Eigen::Index i = 0; i < found.rows(); ++i) {
    sobol.set_point(to_size(i), {point.data(), to_size(point.size())});
    found.row(i) = point.transpose();
  }
  return found;
}

/// The search for one requirement of one case.
class Descent {
 public:
  Descent(const SampledCase& in, Eigen::Index requirement, const Box& box)
      : in_(in), requirement_(requirement), box_(box) {}

  struct Place {
    Eigen::VectorXd at;
    double margin = std::numeric_limits<double>::infinity();
    bool ended = false;
  };

  /// Goes on until neither a step along the slopes nor along one number lowers the margin.
  Place run(Place here) {
    Eigen::VectorXd before = here.at, two_before = here.at;
    for (int round = 0; round < most_rounds; ++round) {
      Places next = along(here.at, -slopes(here));
      if (round > 1) append(next, beyond(here.at, here.at - two_before));
      Place best = worst_of(next, here);
      if (!gains(here, best)) best = worst_of(around(here.at), here);
      if (!gains(here, best)) {
        here.ended = true;
        return here;
      }
      two_before = before;
      before = here.at;
      here = best;
    }
    return here;
  }

  /// The corner that the slopes of a design point to.
  Place pointed_corner(const Place& from) {
    const Eigen::VectorXd slope = slopes(from);
    Places corner(1, box_.draws());
    for (Eigen::Index d = 0; d < corner.cols(); ++d)
      corner(0, d) = slope(d) != 0 ? (slope(d) < 0 ? 1 : 0) : std::round(from.at(d));
    return worst_of(corner, {corner.row(0).transpose(), std::numeric_limits<double>::infinity()});
  }

  std::uint64_t looked_at = 0, failed = 0;
  std::string first_failure;

 private:
  static bool gains(const Place& here, const Place& next) {
    return next.margin < here.margin &&
        (!std::isfinite(here.margin) || here.margin - next.margin > least_gain * std::abs(here.margin));
  }
  static void append(Places& to, const Places& more) {
    const Eigen::Index rows = to.rows();
    to.conservativeResize(rows + more.rows(), Eigen::NoChange);
    to.bottomRows(more.rows()) = more;
  }

  /// Designs that cannot be judged are counted, and infinite here.
  Eigen::ArrayXd margins(const Places& places) {
    const SampledMargins found = in_.judged(box_.at(places));
    looked_at += to_size(places.rows());
    for (const std::string& one : found.failures) {
      if (one.empty()) continue;
      if (failed++ == 0) first_failure = one;
    }
    const Eigen::ArrayXd column = found.margins.col(requirement_);
    return column.isNaN().select(std::numeric_limits<double>::infinity(), column);
  }

  Place worst_of(const Places& places, const Place& otherwise) {
    const Eigen::ArrayXd all = margins(places);
    Eigen::Index least = 0;
    const double margin = all.minCoeff(&least);
    return margin < otherwise.margin ? Place{places.row(least).transpose(), margin} : otherwise;
  }

  /// Per width of each range; 0 where there is none.
  Eigen::VectorXd slopes(const Place& here) {
    const Eigen::Index n = box_.draws();
    Places places = here.at.transpose().replicate(2 * n, 1);
    for (Eigen::Index d = 0; d < n; ++d) {
      places(2 * d, d) = std::max(0.0, here.at(d) - difference);
      places(2 * d + 1, d) = std::min(1.0, here.at(d) + difference);
    }
    const Eigen::ArrayXd all = margins(places);
    Eigen::VectorXd slope(n);
    for (Eigen::Index d = 0; d < n; ++d) {
      const double change = (all(2 * d + 1) - all(2 * d)) / (places(2 * d + 1, d) - places(2 * d, d));
      slope(d) = std::isfinite(change) ? change : 0;
    }
    return slope;
  }

  /// Steps in a direction, cut at the box: the largest passes one range.
  [[nodiscard]] static Places along(const Eigen::VectorXd& at, Eigen::VectorXd direction) {
    for (Eigen::Index d = 0; d < at.size(); ++d)
      if ((at(d) <= 0 && direction(d) < 0) || (at(d) >= 1 && direction(d) > 0)) direction(d) = 0;
    const double largest = direction.cwiseAbs().maxCoeff();
    if (largest > 0) direction /= largest;
    Places places(steps, at.size());
    for (int k = 0; k < steps; ++k)
      places.row(k) = (at + std::ldexp(1.0, -k) * direction).cwiseMax(0.0).cwiseMin(1.0).transpose();
    return places;
  }
  /// Further along the way of the last two rounds, which a narrow valley makes zigzag.
  [[nodiscard]] static Places beyond(const Eigen::VectorXd& at, const Eigen::VectorXd& way) {
    constexpr int most = 8;
    Places places(most, at.size());
    for (int k = 0; k < most; ++k)
      places.row(k) = (at + std::ldexp(1.0, k - 1) * way).cwiseMax(0.0).cwiseMin(1.0).transpose();
    return places;
  }
  /// Steps of each number alone, both ways.
  [[nodiscard]] static Places around(const Eigen::VectorXd& at) {
    Places places = at.transpose().replicate(2 * steps * at.size(), 1);
    Eigen::Index row = 0;
    for (Eigen::Index d = 0; d < at.size(); ++d)
      for (int k = 0; k < steps; ++k)
        for (const double way : {-1.0, 1.0}) places(row++, d) = std::clamp(at(d) + way * std::ldexp(1.0, -k), 0.0, 1.0);
    return places;
  }

  const SampledCase& in_;
  Eigen::Index requirement_;
  const Box& box_;
};

/// The search over all requirements.
class WorstDesigns {
 public:
  WorstDesigns(const std::vector<SampledCase>& cases, const DrawnDesigns& drawn, std::uint64_t seed,
               const foundation::Progress& progress)
      : cases_(cases), box_(drawn), progress_(progress) {
    const numerics::SobolNumbers sobol(drawn.draws(), seed, scramble);
    const Places ends = corners(box_, sobol), inside = points_inside(box_, sobol);
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
    std::vector<std::pair<std::uint64_t, std::string>> failures(tasks.size());
    foundation::parallel_for(tasks.size(), {.size = 1, .progress = progress_, .task = "worst designs"},
                             [&](std::size_t from, std::size_t to) {
                               for (std::size_t i = from; i < to; ++i) {
                                 const auto& [c, r] = tasks[i];
                                 found.of[c][r] = worst(c, to_index(r), failures[i]);
                               }
                             });
    for (const auto& [count, reason] : failures) {
      if (found.failed == 0) found.first_failure = reason;
      found.failed += count;
    }
    return found;
  }

 private:
  /// Designs that begin the searches of all requirements.
  void judge_first(WorstSearch& found) {
    for (const SampledCase& one : cases_) margins_.emplace_back(places_.rows(), to_index(one.given().size()));
    std::vector<std::string> failures(to_size(places_.rows()));
    foundation::parallel_for(
        to_size(places_.rows()), {.size = to_size(piece), .progress = progress_, .task = "corners and designs inside"},
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
    for (const std::string& one : failures) {
      if (one.empty()) continue;
      if (found.failed++ == 0) found.first_failure = one;
    }
  }

  [[nodiscard]] Descent::Place worst_in(const Eigen::ArrayXd& margins, Eigen::Index first, Eigen::Index count) const {
    Eigen::Index least = 0;
    const double margin = margins.segment(first, count).minCoeff(&least);
    return {places_.row(first + least).transpose(), margin};
  }

  WorstFound worst(std::size_t c, Eigen::Index requirement, std::pair<std::uint64_t, std::string>& failures) const {
    Descent search(cases_[c], requirement, box_);
    const Eigen::ArrayXd margins = margins_[c].col(requirement);
    const Descent::Place given{box_.given(), margins(0)};
    std::vector<Descent::Place> starts = {worst_in(margins, 1, corners_)};
    if (to_size(box_.draws()) > most_for_all_corners) starts.push_back(search.pointed_corner(given));
    starts.push_back(worst_in(margins, 1 + corners_, inside_points));
    starts.push_back(given);
    Descent::Place worst;
    for (std::size_t s = 0; s < starts.size(); ++s) {
      const Descent::Place found = search.run(starts[s]);
      const bool lower = found.margin < worst.margin &&
          !(std::abs(worst.margin - found.margin) <= same_worst_margin * std::abs(found.margin));
      if (s == 0 || lower) worst = found;
    }
    failures = {search.failed, search.first_failure};
    WorstFound found{.margin = worst.margin,
                     .draws = box_.at(worst.at.transpose()).row(0).transpose(),
                     .ended = worst.ended,
                     .looked_at = search.looked_at + to_size(places_.rows())};
    found.at_ends = to_size((worst.at.array() == 0 || worst.at.array() == 1).count());
    found.is_corner = found.at_ends == to_size(box_.draws());
    return found;
  }

  const std::vector<SampledCase>& cases_;
  Box box_;
  const foundation::Progress& progress_;
  Eigen::Index corners_ = 0;
  Places places_;                         ///< the given design, corners, designs inside
  std::vector<Eigen::ArrayXXd> margins_;  ///< of these, per case
};

}  // namespace

DrawRange worst_range(const numerics::Distribution& distribution) {
  const auto [from, to] = numerics::ends(distribution);
  return {std::isfinite(from) ? from : numerics::quantile(distribution, beyond_worst_range / 2),
          std::isfinite(to) ? to : numerics::quantile(distribution, 1 - beyond_worst_range / 2)};
}

WorstSearch worst_search(const std::vector<SampledCase>& cases, const DrawnDesigns& drawn, std::uint64_t seed,
                         const foundation::Progress& progress) {
  return WorstDesigns(cases, drawn, seed, progress).run();
}

}  // namespace trivet::study
