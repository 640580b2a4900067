// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/fem/substructuring.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "trivet/foundation/index.h"

namespace trivet::fem {
namespace {

constexpr double smallest_side = 0.3;  ///< part of the elements
constexpr double uneven_cost = 0.5;    ///< added part of the cost if all elements were on one side

}  // namespace

Bisection::Bisection(const std::vector<std::vector<int>>& element_unknowns, const Eigen::Matrix3Xd& centres,
                     int first_retained)
    : element_unknowns_(element_unknowns),
      centres_(centres),
      first_retained_(first_retained),
      first_(to_size(first_retained), -1),
      last_(to_size(first_retained), -1) {}

/// For each place of a sequence of elements the number of unknowns that belong to elements before and after it.
const std::vector<int>& Bisection::shared_before(std::span<const int> elements) {
  for (std::size_t at = 0; at < elements.size(); ++at)
    for (const int unknown : element_unknowns_[elements[at]]) {
      if (unknown >= first_retained_) continue;
      int& first = first_[unknown];
      if (first < 0) first = static_cast<int>(at);
      last_[unknown] = static_cast<int>(at);
    }
  shared_.assign(elements.size() + 1, 0);
  for (const int element : elements)
    for (const int unknown : element_unknowns_[element]) {
      if (unknown >= first_retained_ || first_[unknown] < 0) continue;
      ++shared_[first_[unknown] + 1];
      --shared_[last_[unknown] + 1];
      first_[unknown] = -1;
    }
  for (std::size_t at = 1; at < shared_.size(); ++at) shared_[at] += shared_[at - 1];
  return shared_;
}

int Bisection::halve(std::span<int> elements) {
  const int count = static_cast<int>(elements.size()), margin = std::max(1, static_cast<int>(smallest_side * count));
  std::vector<int> sorted(elements.begin(), elements.end());
  int best = count / 2;
  double lowest = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    std::ranges::sort(sorted,
                      [&](int a, int b) { return std::pair(centres_(axis, a), a) < std::pair(centres_(axis, b), b); });
    const std::vector<int>& shared = shared_before(sorted);
    bool better = false;
    for (int cut = margin; cut <= count - margin; ++cut) {
      const double cost = (1 + shared[cut]) * (1 + uneven_cost * std::abs(2.0 * cut / count - 1));
      if (cost < lowest) {
        lowest = cost;
        best = cut;
        better = true;
      }
    }
    if (better) std::ranges::copy(sorted, elements.begin());
  }
  return best;
}

}  // namespace trivet::fem
