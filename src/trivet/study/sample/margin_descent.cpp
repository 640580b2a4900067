// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/sample/margin_descent.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "trivet/foundation/index.h"

namespace trivet::study {
namespace {

constexpr int steps = 20;                 // of a line, each half the one before
constexpr int most_descent_rounds = 200;  // of a descent
constexpr double difference = 1e-4;       // of the width of a range, for slopes
constexpr double least_gain = 1e-10;      // of the margin, for another round

bool gains(const MarginDescent::Place& here, const MarginDescent::Place& next) {
  return next.margin < here.margin &&
      (!std::isfinite(here.margin) || here.margin - next.margin > least_gain * std::abs(here.margin));
}

void append(DrawPlaces& to, const DrawPlaces& more) {
  const Eigen::Index rows = to.rows();
  to.conservativeResize(rows + more.rows(), Eigen::NoChange);
  to.bottomRows(more.rows()) = more;
}

/// Steps in a direction, cut at the box: the largest passes one range.
DrawPlaces along(const Eigen::VectorXd& at, Eigen::VectorXd direction) {
  for (Eigen::Index d = 0; d < at.size(); ++d)
    if ((at(d) <= 0 && direction(d) < 0) || (at(d) >= 1 && direction(d) > 0)) direction(d) = 0;
  const double largest = direction.cwiseAbs().maxCoeff();
  if (largest > 0) direction /= largest;
  DrawPlaces places(steps, at.size());
  for (int k = 0; k < steps; ++k)
    places.row(k) = (at + std::ldexp(1.0, -k) * direction).cwiseMax(0.0).cwiseMin(1.0).transpose();
  return places;
}

/// Further along the way of the last two rounds, which a narrow valley makes zigzag.
DrawPlaces beyond(const Eigen::VectorXd& at, const Eigen::VectorXd& way) {
  constexpr int most = 8;
  DrawPlaces places(most, at.size());
  for (int k = 0; k < most; ++k)
    places.row(k) = (at + std::ldexp(1.0, k - 1) * way).cwiseMax(0.0).cwiseMin(1.0).transpose();
  return places;
}

/// Steps of each number alone, both ways.
DrawPlaces around(const Eigen::VectorXd& at) {
  DrawPlaces places = at.transpose().replicate(2 * at.size() * steps, 1);
  Eigen::Index row = 0;
  for (Eigen::Index d = 0; d < at.size(); ++d)
    for (int k = 0; k < steps; ++k)
      for (const double way : {-1.0, 1.0}) places(row++, d) = std::clamp(at(d) + way * std::ldexp(1.0, -k), 0.0, 1.0);
  return places;
}

}  // namespace

DrawBox::DrawBox(std::vector<DrawRange> ranges, const Eigen::VectorXd& given) : ranges_(std::move(ranges)) {
  given_ = place(given);
}

Eigen::VectorXd DrawBox::place(const Eigen::VectorXd& numbers) const {
  Eigen::VectorXd found(numbers.size());
  for (Eigen::Index d = 0; d < numbers.size(); ++d) {
    const DrawRange& range = ranges_[to_size(d)];
    const double width = range.to - range.from;
    found(d) = width > 0 ? std::clamp((numbers(d) - range.from) / width, 0.0, 1.0) : 0;
  }
  return found;
}

Eigen::MatrixXd DrawBox::at(const DrawPlaces& places) const {
  Eigen::MatrixXd numbers(places.rows(), places.cols());
  for (Eigen::Index d = 0; d < places.cols(); ++d)
    for (Eigen::Index i = 0; i < places.rows(); ++i)
      numbers(i, d) = std::lerp(ranges_[to_size(d)].from, ranges_[to_size(d)].to, places(i, d));
  return numbers;
}

MarginDescent::Place MarginDescent::run(Place here) {
  Eigen::VectorXd before = here.at, two_before = here.at;
  for (int round = 0; round < most_descent_rounds; ++round) {
    DrawPlaces next = along(here.at, -slopes(here));
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

MarginDescent::Place MarginDescent::pointed_corner(const Place& from) {
  const Eigen::VectorXd slope = slopes(from);
  DrawPlaces corner(1, box_.draws());
  for (Eigen::Index d = 0; d < corner.cols(); ++d)
    corner(0, d) = slope(d) != 0 ? (slope(d) < 0 ? 1 : 0) : std::round(from.at(d));
  return worst_of(corner, {corner.row(0).transpose(), std::numeric_limits<double>::infinity()});
}

Eigen::ArrayXd MarginDescent::margins(const DrawPlaces& places) {
  const Eigen::MatrixXd numbers = box_.at(places);
  const SampledMargins found = in_.judged(numbers);
  looked_at += to_size(places.rows());
  for (std::size_t i = 0; i < found.failures.size(); ++i) {
    if (found.failures[i].empty() || failed++ > 0) continue;
    first_failure = found.failures[i];
    first_failed = numbers.row(to_index(i)).transpose();
  }
  const Eigen::ArrayXd column = found.margins.col(requirement_);
  return column.isNaN().select(std::numeric_limits<double>::infinity(), column);
}

MarginDescent::Place MarginDescent::worst_of(const DrawPlaces& places, const Place& otherwise) {
  const Eigen::ArrayXd all = margins(places);
  Eigen::Index least = 0;
  const double margin = all.minCoeff(&least);
  return margin < otherwise.margin ? Place{places.row(least).transpose(), margin} : otherwise;
}

Eigen::VectorXd MarginDescent::slopes(const Place& here) {
  const Eigen::Index n = box_.draws();
  DrawPlaces places = here.at.transpose().replicate(2 * n, 1);
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

}  // namespace trivet::study
