// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/massless.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/eigenvalues.h"

namespace trivet::numerics {
namespace {

/// a + b · c; entries that are round-off of their terms are zero. Where condensation cancels all stiffness, as in a
/// mechanism, modes of round-off would grow or vibrate slowly instead of being at rest.
template <typename Matrix>
Matrix condensed_sum(const Matrix& a, const Matrix& b, const Matrix& c) {
  const double share = 64 * std::numeric_limits<double>::epsilon() * static_cast<double>(a.rows() + b.cols());
  Matrix sum = a + b * c;
  const Eigen::MatrixXd terms = a.cwiseAbs() + b.cwiseAbs() * c.cwiseAbs();
  for (Eigen::Index j = 0; j < sum.cols(); ++j)
    for (Eigen::Index i = 0; i < sum.rows(); ++i)
      if (std::abs(sum(i, j)) <= share * terms(i, j)) sum(i, j) = 0;
  return sum;
}

}  // namespace

MassiveSystem massive_system(const DynamicMatrices& m) {
  const std::vector<Eigen::Index> massive = massive_rows(m.A);
  const auto n = to_index(massive.size());
  MassiveSystem result{m.A, m.K, Eigen::MatrixXd::Identity(m.size(), m.size())};
  if (n == m.size()) return result;
  const std::vector<Eigen::Index> massless = rows_without(m.size(), massive);
  assert(to_index(massive.size() + massless.size()) == m.size());
  const Eigen::MatrixXd held = m.K(massless, massless);
  const PivotedLu<double> lu(held);
  if (lu.smallest_pivot() == 0)
    throw foundation::NotComputable("an internal coordinate of an element has neither mass nor stiffness");
  const Eigen::MatrixXd follow = -lu.solve(Eigen::MatrixXd(m.K(massless, massive)));
  result.A = m.A(massive, massive);
  result.K = condensed_sum<Eigen::MatrixXd>(m.K(massive, massive), m.K(massive, massless), follow);
  if (m.symmetric) result.K = (0.5 * (result.K + result.K.transpose())).eval();
  result.recovery.setZero(m.size(), n);
  for (Eigen::Index j = 0; j < n; ++j) result.recovery(massive[j], j) = 1;
  for (std::size_t i = 0; i < massless.size(); ++i) result.recovery.row(massless[i]) = follow.row(to_index(i));
  return result;
}

PartedSystem parted_system(const DynamicMatrices& m) {
  constexpr double rounding_of_data = 1e-12, round_off = 64 * std::numeric_limits<double>::epsilon();
  std::vector<Eigen::Index> rows;
  for (const Eigen::Index i : rows_without(m.size(), massive_rows(m.A)))
    if (!m.B.row(i).isZero(0) || !m.B.col(i).isZero(0)) rows.push_back(i);
  if (rows.empty()) return {};
  const Eigen::VectorXd d = unit_scale(m)(rows);
  const Eigen::MatrixXd across = m.B(rows, Eigen::all), back = m.B(Eigen::all, rows).transpose();
  if (!across.isApprox(back, rounding_of_data)) return {};  // unsymmetric damping: its block must be regular
  const Eigen::MatrixXd damping = d.asDiagonal() * across(Eigen::all, rows) * d.asDiagonal();
  const SymmetricEigen<Eigen::MatrixXd> eigen = symmetric_eigen(damping);
  const double none = round_off * static_cast<double>(rows.size()) * eigen.values.cwiseAbs().maxCoeff();
  if (eigen.values.cwiseAbs().minCoeff() > none) return {};
  PartedSystem result{{}, Eigen::MatrixXd::Identity(m.size(), m.size()), true};
  result.basis(rows, rows) = d.asDiagonal() * eigen.vectors;
  const auto in_basis = [&](const Eigen::MatrixXd& matrix) -> Eigen::MatrixXd {
    const Eigen::MatrixXd turned = result.basis.transpose() * matrix * result.basis;
    return m.symmetric ? Eigen::MatrixXd(0.5 * (turned + turned.transpose())) : turned;
  };
  assert(m.A(rows, Eigen::all).isZero(0) && "the basis leaves the coordinates with mass alone, so A is the same in it");
  result.matrices = {m.A, in_basis(m.B), in_basis(m.K), m.lossy() ? in_basis(m.K_loss) : Eigen::MatrixXd(),
                     m.symmetric};
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (std::abs(eigen.values(to_index(i))) <= none) {
      result.matrices.B.row(rows[i]).setZero();
      result.matrices.B.col(rows[i]).setZero();
    }
  return result;
}

ReducedSystem reduced_system(const DynamicMatrices& m) {
  std::vector<Eigen::Index> kept, idle;
  for (Eigen::Index i = 0; i < m.size(); ++i) {
    const bool moves_itself = !m.A.row(i).isZero(0) || !m.B.row(i).isZero(0) || !m.B.col(i).isZero(0);
    (moves_itself ? kept : idle).push_back(i);
  }
  if (idle.empty()) return {m, {}, false};
  const Eigen::MatrixXcd k = m.complex_stiffness();
  const Eigen::MatrixXcd held = k(idle, idle);
  const PivotedLu<Complex> lu(held);
  if (lu.smallest_pivot() == 0)
    throw foundation::NotComputable(
        "a coordinate of a foundation or an element has neither mass nor damping nor stiffness");
  const Eigen::MatrixXcd follow = -lu.solve(Eigen::MatrixXcd(k(idle, kept)));
  const Eigen::MatrixXcd condensed = condensed_sum<Eigen::MatrixXcd>(k(kept, kept), k(kept, idle), follow);
  ReducedSystem result{{m.A(kept, kept), m.B(kept, kept), condensed.real(),
                        m.lossy() ? Eigen::MatrixXd(condensed.imag()) : Eigen::MatrixXd(), m.symmetric},
                       Eigen::MatrixXcd::Zero(m.size(), to_index(kept.size())),
                       true};
  for (std::size_t j = 0; j < kept.size(); ++j) result.recovery(kept[j], to_index(j)) = 1;
  for (std::size_t i = 0; i < idle.size(); ++i) result.recovery.row(idle[i]) = follow.row(to_index(i));
  return result;
}

}  // namespace trivet::numerics
