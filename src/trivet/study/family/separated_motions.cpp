// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/family/separated_motions.h"

#include <algorithm>
#include <numeric>

#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/general_eigen.h"
#include "trivet/numerics/linalg/pivoted_lu.h"

namespace trivet::study {

Eigen::MatrixXd separated_motions(const std::vector<Eigen::MatrixXcd>& changes, const Eigen::VectorXd& towards,
                                  const std::function<double(std::complex<double>)>& measure) {
  const Eigen::Index m = changes.front().rows();
  Eigen::MatrixXd slopes(m, to_index(changes.size()));
  Eigen::MatrixXcd motions = Eigen::MatrixXcd::Identity(m, m);
  if (m > 1) {
    double widest = -1;
    for (std::size_t j = 0; j < changes.size(); ++j) {
      const Eigen::MatrixXcd change = towards(to_index(j)) * changes[j];
      const numerics::GeneralEigen found = numerics::general_eigen(change);
      if (!found.converged) continue;
      std::vector<Eigen::Index> order(to_size(m));
      std::iota(order.begin(), order.end(), 0);
      std::ranges::stable_sort(
          order, [&](Eigen::Index a, Eigen::Index b) { return measure(found.values(a)) < measure(found.values(b)); });
      const double width = measure(found.values(order.back())) - measure(found.values(order.front()));
      if (!(width > widest)) continue;
      widest = width;
      motions = found.vectors(Eigen::all, order);
    }
  }
  const numerics::PivotedLu<std::complex<double>> basis(motions);
  for (std::size_t j = 0; j < changes.size(); ++j) {
    const Eigen::MatrixXcd in_motions = basis.solve(Eigen::MatrixXcd(changes[j] * motions));
    slopes.col(to_index(j)) = in_motions.diagonal().unaryExpr(measure);
  }
  return slopes;
}

}  // namespace trivet::study
