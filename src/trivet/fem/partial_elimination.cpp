// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/fem/partial_elimination.h"

#include <Eigen/Cholesky>
#include <limits>

#include "trivet/foundation/index.h"

namespace trivet::fem {
namespace {

constexpr Eigen::Index block_size =
    48;  ///< wide enough for the matrix product, narrow enough for the unblocked factorization
constexpr double round_off =
    16 * std::numeric_limits<double>::epsilon();  ///< of a pivot, relative to its diagonal before elimination

}  // namespace

Pivots eliminate_leading(Eigen::MatrixXd& matrix, Eigen::Index count) {
  Pivots pivots;
  Eigen::MatrixXd multipliers;
  const Eigen::VectorXd before = matrix.diagonal().head(count).cwiseAbs();
  for (Eigen::Index first = 0; first < count; first += block_size) {
    const Eigen::Index width = std::min(block_size, count - first), rest = matrix.rows() - first - width;
    const Eigen::LDLT<Eigen::MatrixXd, Eigen::Lower> block(matrix.block(first, first, width, width));
    const Eigen::VectorXd diagonal = block.vectorD();
    const Eigen::VectorXd scale = block.transpositionsP() * before.segment(first, width);
    pivots.negative += static_cast<int>((diagonal.array() < 0).count());
    pivots.singular = pivots.singular || !(diagonal.array().abs() > round_off * scale.array()).all();
    auto below = matrix.block(first + width, first, rest, width);
    multipliers = block.solve(below.transpose()).transpose();
    matrix.bottomRightCorner(rest, rest).triangularView<Eigen::Lower>() -= multipliers * below.transpose();
    below = multipliers;
  }
  return pivots;
}

void recover_leading(const Eigen::MatrixXd& multipliers, Eigen::VectorXd& values) {
  const Eigen::Index count = multipliers.cols();
  if (count == 0) return;
  for (Eigen::Index first = (count - 1) / block_size * block_size; first >= 0; first -= block_size) {
    const Eigen::Index width = std::min(block_size, count - first), rest = values.size() - first - width;
    values.segment(first, width) =
        -multipliers.block(first + width, first, rest, width).transpose() * values.tail(rest);
  }
}

void add_symmetric(const Eigen::MatrixXd& part, const std::vector<int>& place, Eigen::MatrixXd& whole) {
  for (Eigen::Index j = 0; j < part.cols(); ++j)
    for (Eigen::Index i = j; i < part.rows(); ++i) {
      const int row = place[to_size(i)], column = place[to_size(j)];
      whole(std::max(row, column), std::min(row, column)) += part(i, j);
    }
}

}  // namespace trivet::fem
