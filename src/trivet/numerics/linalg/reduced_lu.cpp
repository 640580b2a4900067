// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/reduced_lu.h"

#include <cassert>
#include <utility>

namespace trivet::numerics {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Unknowns that can be removed, and the others.
std::pair<std::vector<Index>, std::vector<Index>> split(const MatrixXd& A, ReducedLu::Border border) {
  std::pair<std::vector<Index>, std::vector<Index>> found;
  const Index n = A.rows(), last = border == ReducedLu::Border::last_row ? n - 1 : n;
  assert(A.cols() == n);
  for (Index j = 0; j < n; ++j) {
    const bool is_alone =
        j + 1 < n && A(j, j) != 0 && A.col(j).head(j).isZero(0) && A.col(j).segment(j + 1, last - j - 1).isZero(0);
    (is_alone ? found.first : found.second).push_back(j);
  }
  return found;
}

}  // namespace

ReducedLu::ReducedLu(const MatrixXd& A, Border border) : ReducedLu(A, border, split(A, border)) {}

ReducedLu::ReducedLu(const MatrixXd& A, Border border, std::pair<std::vector<Index>, std::vector<Index>> unknowns)
    : removed_(std::move(unknowns.first)),
      kept_(std::move(unknowns.second)),
      diagonal_(A.diagonal()(removed_)),
      border_(Eigen::RowVectorXd::Zero(diagonal_.size())),
      by_kept_(A(removed_, kept_)),
      factors_(reduced(A, border)) {}

MatrixXd ReducedLu::reduced(const MatrixXd& A, Border border) {
  if (removed_.empty()) return A;
  MatrixXd rest = A(kept_, kept_);
  if (border == Border::none) return rest;
  for (Index i = 0; i < border_.size(); ++i)
    border_(i) = A(A.rows() - 1, removed_[static_cast<std::size_t>(i)]) / diagonal_(i);
  assert(!kept_.empty() && kept_.back() == A.rows() - 1 && "the last unknown is kept, so the border is the last row");
  rest.bottomRows<1>() -= border_ * by_kept_;
  return rest;
}

VectorXd ReducedLu::solve(const VectorXd& b) const {
  assert(b.size() == std::ssize(removed_) + std::ssize(kept_));
  if (removed_.empty()) return factors_.solve(b);
  VectorXd right = b(kept_);
  const VectorXd own = b(removed_);
  right(right.size() - 1) -= border_.dot(own.transpose());
  const VectorXd rest = factors_.solve(right);
  VectorXd found(b.size());
  found(kept_) = rest;
  found(removed_) = (own - by_kept_ * rest).cwiseQuotient(diagonal_);
  return found;
}

int ReducedLu::determinant_sign() const {
  int sign = factors_.determinant_sign();
  for (const double one : diagonal_)
    if (one < 0) sign = -sign;
  return sign;
}

}  // namespace trivet::numerics
