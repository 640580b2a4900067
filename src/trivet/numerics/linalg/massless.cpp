// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/massless.h"

#include <algorithm>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/pivoted_lu.h"

namespace trivet::numerics {

MassiveSystem massive_system(const DynamicMatrices& m) {
  const std::vector<Eigen::Index> massive = massive_rows(m.A);
  const auto n = to_index(massive.size());
  MassiveSystem result{m.A, m.K, Eigen::MatrixXd::Identity(m.size(), m.size())};
  if (n == m.size()) return result;
  const std::vector<Eigen::Index> massless = rows_without(m.size(), massive);
  const Eigen::MatrixXd held = m.K(massless, massless);
  const PivotedLu<double> lu(held);
  if (lu.smallest_pivot() == 0)
    throw foundation::NotComputable("an internal coordinate of an element has neither mass nor stiffness");
  const Eigen::MatrixXd follow = -lu.solve(Eigen::MatrixXd(m.K(massless, massive)));
  result.A = m.A(massive, massive);
  result.K = m.K(massive, massive) + m.K(massive, massless) * follow;
  if (m.symmetric) result.K = (0.5 * (result.K + result.K.transpose())).eval();
  result.recovery.setZero(m.size(), n);
  for (Eigen::Index j = 0; j < n; ++j) result.recovery(massive[to_size(j)], j) = 1;
  for (std::size_t i = 0; i < massless.size(); ++i) result.recovery.row(massless[i]) = follow.row(to_index(i));
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
  const Eigen::MatrixXcd condensed = k(kept, kept) + k(kept, idle) * follow;
  ReducedSystem result{{m.A(kept, kept), m.B(kept, kept), condensed.real(),
                        m.lossy() ? Eigen::MatrixXd(condensed.imag()) : Eigen::MatrixXd(), m.symmetric},
                       Eigen::MatrixXcd::Zero(m.size(), to_index(kept.size())),
                       true};
  for (std::size_t j = 0; j < kept.size(); ++j) result.recovery(kept[j], to_index(j)) = 1;
  for (std::size_t i = 0; i < idle.size(); ++i) result.recovery.row(idle[i]) = follow.row(to_index(i));
  return result;
}

}  // namespace trivet::numerics
