// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/dynamic_matrices.h"

#include <algorithm>
#include <cassert>

namespace trivet::numerics {

std::vector<Eigen::Index> rows_without(Eigen::Index n, const std::vector<Eigen::Index>& rows) {
  assert(std::ranges::is_sorted(rows) && (rows.empty() || (rows.front() >= 0 && rows.back() < n)));
  std::vector<Eigen::Index> result;
  for (Eigen::Index i = 0; i < n; ++i)
    if (!std::ranges::binary_search(rows, i)) result.push_back(i);
  return result;
}

std::vector<Eigen::Index> massive_rows(const Eigen::MatrixXd& A) {
  std::vector<Eigen::Index> rows;
  for (Eigen::Index i = 0; i < A.rows(); ++i)
    if (A(i, i) != 0 || !A.row(i).isZero(0)) rows.push_back(i);
  return rows;
}

Eigen::VectorXd unit_scale(const DynamicMatrices& m) {
  assert(m.B.rows() == m.size() && m.K.rows() == m.size() && "A, B and K have one size");
  Eigen::VectorXd d = unit_scale(m.A);
  double stiffest = 0;
  for (const Eigen::Index i : massive_rows(m.A)) stiffest = std::max(stiffest, d(i) * d(i) * std::abs(m.K(i, i)));
  if (stiffest == 0) return d;
  for (Eigen::Index i = 0; i < m.size(); ++i)
    if (m.A(i, i) == 0 && m.K(i, i) != 0 && m.A.row(i).isZero(0)) d(i) = std::sqrt(stiffest / std::abs(m.K(i, i)));
  return d;
}

}  // namespace trivet::numerics
