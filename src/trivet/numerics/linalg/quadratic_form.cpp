// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/quadratic_form.h"

#include <cassert>
#include <cmath>

#include "trivet/foundation/index.h"

namespace trivet::numerics {

QuadraticForm::QuadraticForm(const Eigen::MatrixXd& M) : diagonal_(M.diagonal()) {
  assert(M.rows() == M.cols());
  end_of_.reserve(to_size(M.cols()));
  for (Eigen::Index j = 0; j < M.cols(); ++j) {
    for (Eigen::Index i = 0; i < j; ++i)
      if (M(i, j) != 0 || M(j, i) != 0)
        entries_.push_back({i, 0.5 * (M(i, j) + M(j, i)), 0.5 * (std::abs(M(i, j)) + std::abs(M(j, i)))});
    end_of_.push_back(entries_.size());
  }
}

long double QuadraticForm::operator()(const Eigen::Ref<const Eigen::VectorXd>& v) const {
  assert(v.size() == diagonal_.size());
  using Extended = long double;
  Extended sum = 0;
  std::size_t e = 0;
  for (Eigen::Index j = 0; j < v.size(); ++j) {
    Extended column = 0.5L * diagonal_(j) * v(j);
    for (; e < end_of_[j]; ++e) column += Extended(entries_[e].value) * v(entries_[e].row);
    sum += 2 * column * v(j);
  }
  return sum;
}

double QuadraticForm::terms(const Eigen::Ref<const Eigen::VectorXd>& v) const {
  assert(v.size() == diagonal_.size());
  double sum = 0;
  std::size_t e = 0;
  for (Eigen::Index j = 0; j < v.size(); ++j) {
    double column = 0.5 * std::abs(diagonal_(j) * v(j));
    for (; e < end_of_[j]; ++e) column += entries_[e].magnitude * std::abs(v(entries_[e].row));
    sum += 2 * column * std::abs(v(j));
  }
  return sum;
}

}  // namespace trivet::numerics
