// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace trivet::fem {

/// Halves a set of elements so that the halves share few unknowns: the cost of a condensation grows with the cube of
/// their number.
class Bisection {
 public:
  /// @param element_unknowns  per element the numbers of its unknowns; those ≥ `first_retained` are not counted
  /// @param centres  per element a point [m]
  Bisection(const std::vector<std::vector<int>>& element_unknowns, const Eigen::Matrix3Xd& centres, int first_retained);

  /// Sorts at least two elements along one axis of the mesh and returns the number of those in the first half.
  int halve(std::span<int> elements);

 private:
  const std::vector<int>& shared_before(std::span<const int> elements);

  const std::vector<std::vector<int>>& element_unknowns_;
  const Eigen::Matrix3Xd& centres_;
  int first_retained_;
  std::vector<int> first_, last_, shared_;  ///< working memory: per unknown, its first and last place in a set
};

}  // namespace trivet::fem
