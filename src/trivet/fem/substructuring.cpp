// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/fem/substructuring.h"

#include <algorithm>
#include <atomic>
#include <future>
#include <numeric>

#include "trivet/fem/partial_elimination.h"
#include "trivet/foundation/index.h"

namespace trivet::fem {
namespace {

constexpr int smallest_part = 4;  ///< elements: for smaller parts, joining costs more than it saves

}  // namespace

Substructuring::Substructuring(std::vector<std::vector<int>> element_unknowns, const Eigen::Matrix3Xd& centres,
                               int first_retained, int retained_count)
    : element_unknowns_(std::move(element_unknowns)), first_retained_(first_retained), retained_count_(retained_count) {
  const int count = static_cast<int>(element_unknowns_.size());
  order_.resize(element_unknowns_.size());
  std::iota(order_.begin(), order_.end(), 0);
  divide(0, count, centres);
  first_touch_.assign(to_size(first_retained), count);
  last_touch_.assign(to_size(first_retained), -1);
  for (int place = 0; place < count; ++place)
    for (const int unknown : element_unknowns_[to_size(order_[to_size(place)])])
      if (unknown < first_retained) {
        auto& first = first_touch_[to_size(unknown)];
        first = std::min(first, place);
        last_touch_[to_size(unknown)] = place;
      }
  number(0);
  operations_ = parts_[0].operations;
}

/// Cuts a range of elements at the widest gap near the middle of its longest side, so that layers of a regular mesh
/// stay whole.
int Substructuring::split_index(int first, int last, const Eigen::Matrix3Xd& centres) {
  const auto begin = order_.begin() + first, end = order_.begin() + last;
  Eigen::Array3d low = Eigen::Array3d::Constant(1e300), high = -low;
  for (auto it = begin; it != end; ++it) {
    low = low.min(centres.col(*it).array());
    high = high.max(centres.col(*it).array());
  }
  Eigen::Index axis = 0;
  (high - low).maxCoeff(&axis);
  std::stable_sort(begin, end, [&](int a, int b) { return centres(axis, a) < centres(axis, b); });
  const int count = last - first, margin = std::max(1, (35 * count) / 100);
  int best = first + count / 2;
  const auto gap = [&](int at) { return centres(axis, order_[to_size(at)]) - centres(axis, order_[to_size(at - 1)]); };
  const double clear = 1.05 * gap(best) + 1e-9 * (high - low).maxCoeff();
  for (int away = 1; away <= count / 2 - margin; ++away)
    for (const int at : {first + count / 2 - away, first + count / 2 + away})
      if (at > first && at < last && gap(at) > clear && gap(at) > 1.05 * gap(best)) best = at;
  return best;
}

int Substructuring::divide(int first, int last, const Eigen::Matrix3Xd& centres) {
  const int self = static_cast<int>(parts_.size());
  parts_.push_back({.first_element = first, .last_element = last});
  if (last - first > smallest_part) {
    const int middle = split_index(first, last, centres);
    const int left = divide(first, middle, centres), right = divide(middle, last, centres);
    parts_[to_size(self)].left = left;
    parts_[to_size(self)].right = right;
  }
  return self;
}

void Substructuring::number(int index) {
  Part& part = parts_[to_size(index)];
  std::vector<int> all;
  if (part.left < 0) {
    for (int place = part.first_element; place < part.last_element; ++place) {
      const auto& own = element_unknowns_[to_size(order_[to_size(place)])];
      all.insert(all.end(), own.begin(), own.end());
    }
  } else {
    for (const int child : {part.left, part.right}) {
      number(child);
      const Part& below = parts_[to_size(child)];
      all.insert(all.end(), below.unknowns.begin() + below.condensed, below.unknowns.end());
      part.operations += below.operations;
    }
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  const auto inside = [&](int unknown) {
    return unknown < first_retained_ && first_touch_[to_size(unknown)] >= part.first_element &&
        last_touch_[to_size(unknown)] < part.last_element;
  };
  part.condensed = static_cast<int>(std::stable_partition(all.begin(), all.end(), inside) - all.begin());
  part.unknowns = std::move(all);
  const double k = part.condensed, b = static_cast<double>(part.unknowns.size()) - k;
  part.operations +=
      k * (b * b / 2 + b * k / 2 + k * k / 6) + 1e5 * (part.left < 0 ? part.last_element - part.first_element : 0);
  if (part.left >= 0) place_children(index);
}

void Substructuring::place_children(int index) {
  const Part& part = parts_[to_size(index)];
  const auto boundary = part.unknowns.begin() + part.condensed;
  for (const int child : {part.left, part.right}) {
    Part& below = parts_[to_size(child)];
    for (auto it = below.unknowns.begin() + below.condensed; it != below.unknowns.end(); ++it) {
      auto found = std::lower_bound(part.unknowns.begin(), boundary, *it);
      if (found == boundary || *found != *it) found = std::lower_bound(boundary, part.unknowns.end(), *it);
      below.place_in_parent.push_back(static_cast<int>(found - part.unknowns.begin()));
    }
  }
}

double Substructuring::bytes(bool recoverable) const {
  double factors = 0, largest = 0, deepest = 0;
  for (const Part& part : parts_) {
    const double n = static_cast<double>(part.unknowns.size());
    factors += n * part.condensed;
    largest = std::max(largest, n * n);
    if (part.left >= 0 && n * n > deepest) deepest = n * n;
  }
  return 8 *
      ((recoverable ? factors : 0) + largest +
       2 * deepest);  // the largest front, and boundaries waiting for their neighbours
}

struct Substructuring::Run {
  const ElementMatrix& element_matrix;
  bool recoverable;
  const foundation::Progress& progress;
  double total;
  std::atomic<double> done = 0;
  std::atomic<int> negative_pivots = 0;
  std::atomic<bool> singular = false, stopped = false;
};

Eigen::MatrixXd Substructuring::condense_part(int index, Run& run, int threads, bool reports) {
  Part& part = parts_[to_size(index)];
  const Eigen::Index n = to_index(part.unknowns.size()), k = part.condensed;
  Eigen::MatrixXd front;
  if (part.left < 0) {
    front = Eigen::MatrixXd::Zero(n, n);
    const auto boundary = part.unknowns.begin() + part.condensed;
    for (int place = part.first_element; place < part.last_element && !run.stopped; ++place) {
      const int element = order_[to_size(place)];
      const Eigen::MatrixXd matrix = run.element_matrix(element);
      std::vector<int> at;
      for (const int unknown : element_unknowns_[to_size(element)]) {
        auto found = std::lower_bound(part.unknowns.begin(), boundary, unknown);
        if (found == boundary || *found != unknown) found = std::lower_bound(boundary, part.unknowns.end(), unknown);
        at.push_back(static_cast<int>(found - part.unknowns.begin()));
      }
      add_symmetric(matrix, at, front);
    }
  } else {
    const bool split = threads > 1 && part.operations > 1e6;
    std::future<Eigen::MatrixXd> other;
    if (split)
      other = std::async(std::launch::async, [&] { return condense_part(part.right, run, threads / 2, false); });
    Eigen::MatrixXd left, right;
    try {
      left = condense_part(part.left, run, split ? threads - threads / 2 : threads, reports);
    } catch (...) {
      run.stopped = true;
      if (split) other.wait();
      throw;
    }
    right = split ? other.get() : condense_part(part.right, run, threads, reports);
    front = Eigen::MatrixXd::Zero(n, n);
    add_symmetric(left, parts_[to_size(part.left)].place_in_parent, front);
    left.resize(0, 0);
    add_symmetric(right, parts_[to_size(part.right)].place_in_parent, front);
  }
  if (run.stopped) return Eigen::MatrixXd::Zero(n - k, n - k);
  const Pivots pivots = eliminate_leading(front, k);
  run.negative_pivots += pivots.negative;
  if (pivots.singular) run.singular = true;
  if (run.recoverable) part.factors = front.leftCols(k);
  double below = 0;
  for (const int child : {part.left, part.right})
    if (child >= 0) below += parts_[to_size(child)].operations;
  run.done += part.operations - below;
  if (reports) foundation::report_progress(run.progress, "condensing the solid", std::min(1.0, run.done / run.total));
  return front.bottomRightCorner(n - k, n - k);
}

Substructuring::Condensed Substructuring::condense(const ElementMatrix& element_matrix, bool recoverable, int threads,
                                                   const foundation::Progress& progress) {
  Run run{.element_matrix = element_matrix, .recoverable = recoverable, .progress = progress, .total = operations_};
  const Eigen::MatrixXd boundary = condense_part(0, run, std::max(1, threads), true);
  Condensed result{Eigen::MatrixXd::Zero(retained_count_, retained_count_), run.negative_pivots, run.singular};
  const Part& root = parts_[0];
  for (std::size_t i = 0; i + to_size(root.condensed) < root.unknowns.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      const int row = root.unknowns[i + to_size(root.condensed)] - first_retained_;
      const int column = root.unknowns[j + to_size(root.condensed)] - first_retained_;
      result.matrix(row, column) = result.matrix(column, row) = boundary(to_index(i), to_index(j));
    }
  return result;
}

Eigen::VectorXd Substructuring::recover(const Eigen::VectorXd& retained) const {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(first_retained_ + retained_count_);
  all.tail(retained_count_) = retained;
  for (const Part& part : parts_) {  // parents come before their children
    Eigen::VectorXd own(to_index(part.unknowns.size()));
    for (Eigen::Index i = 0; i < own.size(); ++i) own(i) = all(part.unknowns[to_size(i)]);
    recover_leading(part.factors, own);
    for (Eigen::Index i = 0; i < part.condensed; ++i) all(part.unknowns[to_size(i)]) = own(i);
  }
  return all;
}

}  // namespace trivet::fem
