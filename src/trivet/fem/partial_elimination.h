// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace trivet::fem {

struct Pivots {
  int negative = 0;
  bool singular = false;
};

/// Eliminates the first `count` unknowns of the symmetric matrix given by its lower triangle: the lower triangle of its
/// lower right corner becomes that of the Schur complement, its first columns become the factors that `recover_leading`
/// needs. The result does not depend on `threads`.
Pivots eliminate_leading(Eigen::Ref<Eigen::MatrixXd> matrix, Eigen::Index count, int threads);

/// Computes the eliminated unknowns from the others, in place: `values` holds the others after the first
/// `factors.cols()`.
void recover_leading(const Eigen::MatrixXd& factors, Eigen::VectorXd& values);

/// Adds a symmetric matrix to the lower triangle of another, row and column i at place[i].
void add_symmetric(const Eigen::MatrixXd& part, const std::vector<int>& place, Eigen::Ref<Eigen::MatrixXd> whole);

/// The lower triangle of a matrix, column after column.
[[nodiscard]] std::vector<double> packed_lower(const Eigen::Ref<const Eigen::MatrixXd>& matrix);

/// Adds a packed lower triangle to that of a larger matrix, row and column i at place[i], in ascending places.
void add_packed(const std::vector<double>& part, const std::vector<int>& place, Eigen::Ref<Eigen::MatrixXd> whole);

}  // namespace trivet::fem
