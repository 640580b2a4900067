// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/fem/substructuring.h"

#include <algorithm>
#include <atomic>
#include <future>
#include <numeric>
#include <span>

#include "trivet/foundation/index.h"
#include "trivet/numerics/lanes/line_memory.h"

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
  Bisection bisection(element_unknowns_, centres, first_retained);
  divide(0, count, bisection);
  first_touch_.assign(to_size(first_retained), count);
  last_touch_.assign(to_size(first_retained), -1);
  for (int place = 0; place < count; ++place)
    for (const int unknown : element_unknowns_[order_[place]])
      if (unknown < first_retained) {
        auto& first = first_touch_[unknown];
        first = std::min(first, place);
        last_touch_[unknown] = place;
      }
  number(0);
  order_boundaries();
  operations_ = parts_[0].operations;
}

int Substructuring::divide(int first, int last, Bisection& bisection) {
  const int self = static_cast<int>(parts_.size());
  parts_.push_back({.first_element = first, .last_element = last});
  if (last - first > smallest_part) {
    const int middle = first + bisection.halve(std::span(order_).subspan(to_size(first), to_size(last - first)));
    const int left = divide(first, middle, bisection), right = divide(middle, last, bisection);
    parts_[self].left = left;
    parts_[self].right = right;
  }
  return self;
}

void Substructuring::number(int index) {
  Part& part = parts_[index];
  std::vector<int> all;
  if (part.left < 0) {
    for (int place = part.first_element; place < part.last_element; ++place) {
      const auto& own = element_unknowns_[order_[place]];
      all.insert(all.end(), own.begin(), own.end());
    }
  } else {
    for (const int child : {part.left, part.right}) {
      number(child);
      const Part& below = parts_[child];
      all.insert(all.end(), below.unknowns.begin() + below.condensed, below.unknowns.end());
      part.operations += below.operations;
    }
  }
  std::ranges::sort(all);
  all.erase(std::ranges::unique(all).begin(), all.end());
  const auto inside = [&](int unknown) {
    return unknown < first_retained_ && first_touch_[unknown] >= part.first_element &&
        last_touch_[unknown] < part.last_element;
  };
  part.condensed = static_cast<int>(std::ranges::stable_partition(all, inside).begin() - all.begin());
  part.unknowns = std::move(all);
  const double k = part.condensed, b = static_cast<double>(part.unknowns.size()) - k;
  part.operations +=
      k * (b * b / 2 + b * k / 2 + k * k / 6) + 1e5 * (part.left < 0 ? part.last_element - part.first_element : 0);
}

/// Orders the boundary of each part as its unknowns are in the part above.
void Substructuring::order_boundaries() {
  std::vector<int> place(to_size(first_retained_ + retained_count_));
  for (const Part& part : parts_) {  // parents come before their children
    if (part.left < 0) continue;
    for (std::size_t i = 0; i < part.unknowns.size(); ++i) place[part.unknowns[i]] = static_cast<int>(i);
    for (const int child : {part.left, part.right}) {
      Part& below = parts_[child];
      for (auto it = below.unknowns.begin() + below.condensed; it != below.unknowns.end(); ++it)
        below.place_in_parent.push_back(place[*it]);
      std::ranges::sort(below.place_in_parent);
      for (std::size_t i = 0; i < below.place_in_parent.size(); ++i)
        below.unknowns[below.condensed + i] = part.unknowns[below.place_in_parent[i]];
    }
  }
}

bool Substructuring::splits(const Part& part, int threads) const { return threads > 1 && part.operations > 1e6; }

/// Numbers in memory during the condensation of a part, in its thread: its largest front, the boundaries that wait for
/// their neighbours, and all of the other threads.
Substructuring::Memory Substructuring::memory(int index, int threads) const {
  const Part& part = parts_[index];
  const double n = static_cast<double>(part.unknowns.size()), boundary = n - part.condensed;
  Memory here{.front = n * n, .boundaries = 0, .result = boundary * (boundary + 1) / 2};
  if (part.left >= 0) {
    const bool split = splits(part, threads);
    const Memory left = memory(part.left, split ? threads - threads / 2 : threads),
                 right = memory(part.right, split ? threads / 2 : threads);
    here.front = std::max(here.front, left.front);
    if (!split) here.front = std::max(here.front, right.front);
    here.boundaries = std::max(left.result + right.result,
                               split ? left.boundaries + right.boundaries + right.front
                                     : std::max(left.boundaries, left.result + right.boundaries));
  }
  here.boundaries = std::max(here.boundaries, here.result);
  return here;
}

double Substructuring::bytes(bool recoverable, int threads) const {
  double factors = 0;
  for (const Part& part : parts_) factors += static_cast<double>(part.unknowns.size()) * part.condensed;
  const Memory root = memory(0, threads);
  return 8 * ((recoverable ? factors : 0) + root.front + root.boundaries);
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

/// Of one thread: memory of the front in work, and the place of each unknown in it.
struct Substructuring::Workspace {
  numerics::LineMemory front;
  std::vector<int> place;

  /// The front, with zeros on and below its diagonal.
  Eigen::Map<Eigen::MatrixXd> zero_front(Eigen::Index size) {
    if (front.size() < to_size(size * size)) {
      front.resize(0);  // releases the old memory first
      front.resize(to_size(size * size));
    }
    Eigen::Map<Eigen::MatrixXd> matrix(front.data(), size, size);
    for (Eigen::Index j = 0; j < size; ++j) matrix.col(j).tail(size - j).setZero();
    return matrix;
  }
};

void Substructuring::add_elements(const Part& part, Run& run, Workspace& workspace,
                                  Eigen::Map<Eigen::MatrixXd>& front) const {
  workspace.place.resize(to_size(first_retained_ + retained_count_));
  for (std::size_t i = 0; i < part.unknowns.size(); ++i) workspace.place[part.unknowns[i]] = static_cast<int>(i);
  for (int at = part.first_element; at < part.last_element && !run.stopped; ++at) {
    const int element = order_[at];
    const Eigen::MatrixXd matrix = run.element_matrix(element);
    std::vector<int> place;
    for (const int unknown : element_unknowns_[element]) place.push_back(workspace.place[unknown]);
    add_symmetric(matrix, place, front);
  }
}

std::vector<double> Substructuring::condense_part(int index, Run& run, Workspace& workspace, int threads,
                                                  bool reports) {
  Part& part = parts_[index];
  const Eigen::Index n = to_index(part.unknowns.size()), k = part.condensed;
  std::vector<double> left, right;
  if (part.left >= 0) {
    const bool split = splits(part, threads);
    std::future<std::vector<double>> other;
    if (split)
      other = std::async(std::launch::async, [&] {
        Workspace own;
        return condense_part(part.right, run, own, threads / 2, false);
      });
    try {
      left = condense_part(part.left, run, workspace, split ? threads - threads / 2 : threads, reports);
    } catch (...) {
      run.stopped = true;
      if (split) other.wait();
      throw;
    }
    right = split ? other.get() : condense_part(part.right, run, workspace, threads, reports);
  }
  if (run.stopped) return {};
  Eigen::Map<Eigen::MatrixXd> front = workspace.zero_front(n);
  if (part.left < 0) add_elements(part, run, workspace, front);
  else {
    add_packed(left, parts_[part.left].place_in_parent, front);
    add_packed(right, parts_[part.right].place_in_parent, front);
    left = {};
    right = {};
  }
  const Pivots pivots = eliminate_leading(front, k, threads);
  run.negative_pivots += pivots.negative;
  if (pivots.singular) run.singular = true;
  if (run.recoverable) part.factors = front.leftCols(k);
  double below = 0;
  for (const int child : {part.left, part.right})
    if (child >= 0) below += parts_[child].operations;
  run.done += part.operations - below;
  if (reports) foundation::report_progress(run.progress, "condensing the solid", std::min(1.0, run.done / run.total));
  return packed_lower(front.bottomRightCorner(n - k, n - k));
}

Substructuring::Condensed Substructuring::condense(const ElementMatrix& element_matrix, bool recoverable, int threads,
                                                   const foundation::Progress& progress) {
  Run run{.element_matrix = element_matrix, .recoverable = recoverable, .progress = progress, .total = operations_};
  Workspace workspace;
  const std::vector<double> boundary = condense_part(0, run, workspace, std::max(1, threads), true);
  Condensed result{Eigen::MatrixXd::Zero(retained_count_, retained_count_), run.negative_pivots, run.singular};
  const Part& root = parts_[0];
  const std::size_t first = to_size(root.condensed);
  auto entry = boundary.begin();
  for (std::size_t j = first; j < root.unknowns.size(); ++j)
    for (std::size_t i = j; i < root.unknowns.size(); ++i) {
      const int row = root.unknowns[i] - first_retained_, column = root.unknowns[j] - first_retained_;
      result.matrix(row, column) = result.matrix(column, row) = *entry++;
    }
  return result;
}

Eigen::VectorXd Substructuring::recover(const Eigen::VectorXd& retained) const {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(first_retained_ + retained_count_);
  all.tail(retained_count_) = retained;
  for (const Part& part : parts_) {  // parents come before their children
    Eigen::VectorXd own(to_index(part.unknowns.size()));
    for (Eigen::Index i = 0; i < own.size(); ++i) own(i) = all(part.unknowns[i]);
    recover_leading(part.factors, own);
    for (Eigen::Index i = 0; i < part.condensed; ++i) all(part.unknowns[i]) = own(i);
  }
  return all;
}

}  // namespace trivet::fem
