// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/fem/substructuring.h"

#include <Eigen/Cholesky>
#include <limits>

#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/product_update.h"

namespace trivet::fem {
namespace {

constexpr Eigen::Index block_size = 48;  ///< pivots are chosen within a block; narrow, for the unblocked factorization
constexpr Eigen::Index panel_size = 2 * block_size;  ///< the columns behind it are updated once per panel
constexpr double round_off =
    16 * std::numeric_limits<double>::epsilon();  ///< of a pivot, relative to its diagonal before elimination

/// S and D of a symmetric block A = S⁻ᵀ D S⁻¹: S = Pᵀ L⁻ᵀ of its pivoted LDLᵀ.
struct Diagonalised {
  Eigen::MatrixXd s;
  Eigen::VectorXd inverse_pivots;

  Diagonalised(const Eigen::MatrixXd& block, const Eigen::VectorXd& before, Pivots& pivots) {
    const Eigen::LDLT<Eigen::MatrixXd, Eigen::Lower> factors(block);
    const Eigen::ArrayXd diagonal = factors.vectorD();
    const Eigen::VectorXd scale = factors.transpositionsP() * before;
    pivots.negative += static_cast<int>((diagonal < 0).count());
    pivots.singular = pivots.singular || !(diagonal.abs() > round_off * scale.array()).all();
    inverse_pivots = (diagonal != 0).select(1 / diagonal, 0);
    s.setIdentity(block.rows(), block.rows());
    factors.matrixU().solveInPlace(s);
    s = factors.transpositionsP().transpose() * s;
  }
};

}  // namespace

Pivots eliminate_leading(Eigen::Ref<Eigen::MatrixXd> matrix, Eigen::Index count, int threads) {
  Pivots pivots;
  const Eigen::VectorXd before = matrix.diagonal().head(count).cwiseAbs();
  Eigen::MatrixXd columns, divided;  // of a panel: A S and A S D⁻¹
  numerics::ProductUpdate update;
  for (Eigen::Index first = 0; first < count; first += panel_size) {
    const Eigen::Index end = std::min(first + panel_size, count);
    divided.resize(matrix.rows() - first, end - first);
    for (Eigen::Index at = first; at < end; at += block_size) {
      const Eigen::Index width = std::min(block_size, end - at), next = at + width, rest = matrix.rows() - next;
      auto block = matrix.block(at, at, width, width);
      const Diagonalised diagonal(block, before.segment(at, width), pivots);
      auto below = matrix.block(next, at, rest, width);
      columns.setZero(rest, width);
      update.subtract(below, -diagonal.s.transpose(), columns, numerics::Needed::all, threads);
      below = columns;
      divided.block(next - first, at - first, rest, width) = columns * diagonal.inverse_pivots.asDiagonal();
      block = diagonal.s * diagonal.inverse_pivots.asDiagonal();
      if (next < end)
        update.subtract(divided.block(next - first, at - first, rest, width), below.topRows(end - next),
                        matrix.block(next, next, rest, end - next), numerics::Needed::lower_triangle, threads);
    }
    const Eigen::Index rest = matrix.rows() - end;
    update.subtract(divided.bottomRows(rest), matrix.block(end, first, rest, end - first),
                    matrix.bottomRightCorner(rest, rest), numerics::Needed::lower_triangle, threads);
  }
  return pivots;
}

void recover_leading(const Eigen::MatrixXd& factors, Eigen::VectorXd& values) {
  const Eigen::Index count = factors.cols();
  if (count == 0) return;
  for (Eigen::Index first = (count - 1) / block_size * block_size; first >= 0; first -= block_size) {
    const Eigen::Index width = std::min(block_size, count - first), rest = values.size() - first - width;
    const Eigen::VectorXd load = factors.block(first + width, first, rest, width).transpose() * values.tail(rest);
    values.segment(first, width) = -factors.block(first, first, width, width) * load;
  }
}

void add_symmetric(const Eigen::MatrixXd& part, const std::vector<int>& place, Eigen::Ref<Eigen::MatrixXd> whole) {
  for (Eigen::Index j = 0; j < part.cols(); ++j)
    for (Eigen::Index i = j; i < part.rows(); ++i) {
      const int row = place[i], column = place[j];
      whole(std::max(row, column), std::min(row, column)) += part(i, j);
    }
}

std::vector<double> packed_lower(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  const Eigen::Index n = matrix.rows();
  std::vector<double> packed;
  packed.reserve(to_size(n * (n + 1) / 2));
  for (Eigen::Index j = 0; j < n; ++j) {
    const auto column = matrix.col(j).tail(n - j);
    packed.insert(packed.end(), column.data(), column.data() + column.size());
  }
  return packed;
}

void add_packed(const std::vector<double>& part, const std::vector<int>& place, Eigen::Ref<Eigen::MatrixXd> whole) {
  const double* entry = part.data();
  for (std::size_t j = 0; j < place.size(); ++j) {
    double* const column = &whole(0, place[j]);
    for (std::size_t i = j; i < place.size(); ++i) column[place[i]] += *entry++;
  }
}

}  // namespace trivet::fem
