// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace trivet::fem {

struct Pivots {
  int negative = 0;
  bool singular = false;
};

/// Eliminates the first `count` unknowns of the symmetric matrix given by its lower triangle: its lower right corner
/// becomes the Schur complement, its first columns the multipliers below each diagonal block that `recover_leading`
/// needs.
Pivots eliminate_leading(Eigen::MatrixXd& matrix, Eigen::Index count);

/// Computes the eliminated unknowns from the others, in place: `values` holds the others after the first
/// `multipliers.cols()`.
void recover_leading(const Eigen::MatrixXd& multipliers, Eigen::VectorXd& values);

/// Adds a symmetric matrix to the lower triangle of another, row and column i at place[i].
void add_symmetric(const Eigen::MatrixXd& part, const std::vector<int>& place, Eigen::MatrixXd& whole);

}  // namespace trivet::fem
