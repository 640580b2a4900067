// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/quadratic_form.h"

namespace trivet::numerics {

long double quadratic_form(const Eigen::MatrixXd& M, const Eigen::Ref<const Eigen::VectorXd>& v) {
  using Extended = long double;
  Extended sum = 0;
  for (Eigen::Index j = 0; j < v.size(); ++j) {
    Extended column = 0.5L * M(j, j) * v(j);
    for (Eigen::Index i = 0; i < j; ++i) column += Extended(M(i, j)) * v(i);
    sum += 2 * column * v(j);
  }
  return sum;
}

}  // namespace trivet::numerics
