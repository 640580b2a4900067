// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exchange/fixed_components.h"

#include <algorithm>
#include <cmath>

#include "trivet/numerics/linalg/pivoted_lu.h"

namespace trivet::exchange {

std::vector<int> fixed_components(const Eigen::MatrixXd& matrix) {
  constexpr double beyond_arms = 1e12, beyond_stiffness = 1e30;
  std::vector<int> rows;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    double largest = 0;
    for (Eigen::Index j = 0; j < matrix.cols(); ++j)
      if (j != i) largest = std::max(largest, std::abs(matrix(i, j)));
    const double diagonal = std::abs(matrix(i, i));
    if (diagonal >= beyond_stiffness || (largest > 0 && diagonal > beyond_arms * largest))
      rows.push_back(static_cast<int>(i));
  }
  return rows;
}

Eigen::Matrix<double, 12, 12> completed_by_rigid_motion(const Eigen::Matrix<double, 12, 12>& matrix,
                                                        const std::vector<int>& rows,
                                                        const Eigen::Matrix<double, 12, 6>& motions) {
  Eigen::Matrix<double, 12, 12> result = matrix;
  for (const int i : rows) result(i, i) = 0;
  for (const int first : {0, 6}) {
    const Eigen::Matrix<double, 6, 6> own = motions.middleRows<6>(first);
    const Eigen::Matrix<double, 12, 6> unit = motions *
        numerics::PivotedLu<double>(own).solve(Eigen::MatrixXd(Eigen::MatrixXd::Identity(own.rows(), own.rows())));
    for (const int i : rows)
      if (i >= first && i < first + 6) result(i, i) = -result.row(i).dot(unit.col(i - first));
  }
  return result;
}

}  // namespace trivet::exchange
