// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/transient/exact_steps.h"

#include <algorithm>
#include <cassert>

namespace trivet::response {
namespace {

double column_norm(const Eigen::MatrixXd& F) { return F.size() > 0 ? F.cwiseAbs().colwise().sum().maxCoeff() : 0; }

}  // namespace

ExactSteps::ExactSteps(const StateSpace& space, double step, double largest_kappa)
    : F_(space.F()), groups_(space.groups()), step_(step), fastest_(std::max(column_norm(F_), largest_kappa)) {
  const Eigen::Index P = groups_.pairs;
  pair_rates_.resize(P, 4);
  for (Eigen::Index j = 0; j < P; ++j) {
    const std::vector<Eigen::Index> at = {j, P + j};
    pairs_.emplace_back(F_(at, at), step, fastest_);
    pair_rates_.row(j) << F_(j, j), F_(j, P + j), F_(P + j, j), F_(P + j, P + j);
  }
  Eigen::Index first = 2 * P;
  for (const Eigen::Index size : groups_.dense) {
    dense_.emplace_back(F_.block(first, first, size, size), step, fastest_);
    first += size;
  }
  assert(first == F_.rows() && "every state belongs to a pair or to a dense group");
  if (!pairs_.empty() || !dense_.empty()) levels_ = (pairs_.empty() ? dense_ : pairs_).front().levels();
  [[maybe_unused]] const auto is_as_fine = [&](const ExponentialStep& one) { return one.levels() == levels_; };
  assert(std::ranges::all_of(pairs_, is_as_fine) && std::ranges::all_of(dense_, is_as_fine) &&
         "halvings depend on the fastest rate of all states");
  for (std::size_t level = 0; level < levels_ && P > 0; ++level) pair_matrices_.push_back(pair_matrix(level));
}

Eigen::ArrayXXd ExactSteps::pair_matrix(std::size_t level) const {
  Eigen::ArrayXXd matrix(groups_.pairs, 4);
  for (Eigen::Index j = 0; j < groups_.pairs; ++j) {
    const Eigen::MatrixXd& phi = pairs_[j].state(level);
    matrix.row(j) << phi(0, 0), phi(0, 1), phi(1, 0), phi(1, 1);
  }
  return matrix;
}

std::vector<InputMatrix> ExactSteps::input(const InputMatrix& G, double kappa) const {
  std::vector<InputMatrix> result(levels_, InputMatrix::Zero(G.rows(), 5));
  const Eigen::Index P = groups_.pairs;
  for (Eigen::Index j = 0; j < P; ++j) {
    InputMatrix own(2, 5);
    own << G.row(j), G.row(P + j);
    if (own.isZero(0)) continue;
    const std::vector<InputMatrix> gamma = pairs_[j].input(own, kappa);
    for (std::size_t level = 0; level < levels_; ++level) {
      result[level].row(j) = gamma[level].row(0);
      result[level].row(P + j) = gamma[level].row(1);
    }
  }
  Eigen::Index first = 2 * P;
  for (std::size_t g = 0; g < dense_.size(); ++g) {
    const Eigen::Index size = groups_.dense[g];
    const std::vector<InputMatrix> gamma = dense_[g].input(G.middleRows(first, size), kappa);
    for (std::size_t level = 0; level < levels_; ++level) result[level].middleRows(first, size) = gamma[level];
    first += size;
  }
  return result;
}

void ExactSteps::take(std::size_t level, const std::vector<numerics::StepInput>& inputs,
                      const Eigen::Ref<const Eigen::MatrixXd>& w, Eigen::Ref<Eigen::MatrixXd> states) const {
  const Eigen::Index P = groups_.pairs;
  if (P > 0)
    numerics::take_pair_steps({P, pair_matrices_[level].data(), inputs.data(), inputs.data() + inputs.size()}, w,
                              states);
  Eigen::Index first = 2 * P;
  for (std::size_t g = 0; g < dense_.size(); ++g) {
    const Eigen::Index size = groups_.dense[g];
    for (Eigen::Index i = 0; i < w.cols(); ++i) {
      auto next = states.col(i + 1).segment(first, size);
      next.noalias() = dense_[g].state(level) * states.col(i).segment(first, size);
      for (const numerics::StepInput& input : inputs)
        next += w(input.row, i) * Eigen::Map<const Eigen::VectorXd>(input.gamma + first, size);
    }
    first += size;
  }
}

void ExactSteps::rate(const Eigen::VectorXd& x, Eigen::VectorXd& result) const {
  const Eigen::Index P = groups_.pairs;
  for (Eigen::Index j = 0; j < P; ++j) {
    const double one = x(j), two = x(P + j);
    result(j) = pair_rates_(j, 0) * one + pair_rates_(j, 1) * two;
    result(P + j) = pair_rates_(j, 2) * one + pair_rates_(j, 3) * two;
  }
  Eigen::Index first = 2 * P;
  for (const Eigen::Index size : groups_.dense) {
    result.segment(first, size).noalias() = F_.block(first, first, size, size) * x.segment(first, size);
    first += size;
  }
}

}  // namespace trivet::response
