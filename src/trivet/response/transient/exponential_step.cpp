// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/transient/exponential_step.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "trivet/foundation/invalid_input.h"

namespace trivet::response {
namespace {

using ExtendedMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
using ExtendedInput = Eigen::Matrix<long double, Eigen::Dynamic, 5>;
using ExtendedRates = Eigen::Matrix<long double, 5, 5>;

/// m S(κ), with ∬u → ∫u → u → u̇ → ü → −κ²u̇ in S.
ExtendedRates times_rates(const ExtendedRates& m, double kappa) {
  ExtendedRates product;
  product.col(0).setZero();
  product.rightCols<4>() = m.leftCols<4>();
  product.col(3) -= static_cast<long double>(kappa) * kappa * m.col(4);
  return product;
}

}  // namespace

InputVector rate(const InputVector& w, double kappa) {
  InputVector d;
  d << w(1), w(2), w(3), w(4), -kappa * kappa * w(3);
  return d;
}

ExponentialStep::ExponentialStep(const Eigen::MatrixXd& F, double step, double largest_kappa)
    : F_(F.cast<long double>()), step_(step) {
  constexpr int most_levels = 60;
  const double norm = F.size() > 0 ? F.cwiseAbs().colwise().sum().maxCoeff() : 0;
  const double turn = std::max(norm, largest_kappa) * step;
  if (!std::isfinite(turn))
    throw foundation::NotComputable("the matrices of the motion contain numbers beyond the range of computation");
  int finest = 0;
  while (std::ldexp(turn, -finest) > 0.5) ++finest;
  if (finest > most_levels)
    throw foundation::NotComputable("the fastest mode oscillates more than 2^60 times within one step");
  const ExtendedMatrix scaled = F_ * std::ldexp(static_cast<long double>(step), -finest);
  const ExtendedMatrix one = ExtendedMatrix::Identity(F.rows(), F.cols());
  assert(std::ldexp(turn, -finest) <= 0.5 && "the series of e^{F h} converges faster than 2⁻ᵏ/k!");
  ExtendedMatrix phi = one;
  for (int k = series_terms; k > 0; --k) phi = (one + scaled * phi / static_cast<long double>(k)).eval();
  exact_.push_back(phi);
  for (int level = 0; level < finest; ++level) exact_.push_back(exact_.back() * exact_.back());
  std::ranges::reverse(exact_);
  for (const ExtendedMatrix& each : exact_) state_.push_back(each.cast<double>());
}

std::vector<InputMatrix> ExponentialStep::input(const InputMatrix& G, double kappa) const {
  const std::size_t finest = levels() - 1;
  assert(G.rows() == F_.rows());
  const long double h = std::ldexp(static_cast<long double>(step_), -static_cast<int>(finest));
  // Input columns of the Taylor series of the whole matrix: R_k = (F R_{k−1} + G S^{k−1} h^{k-1}/(k−1)!) h/k.
  ExtendedInput term = ExtendedInput::Zero(G.rows(), 5), gamma = term, next = term;
  const ExtendedInput drive = G.cast<long double>();
  ExtendedRates own = ExtendedRates::Identity(), e = own;
  for (int k = 1; k <= series_terms; ++k) {
    const long double part = h / static_cast<long double>(k);
    next.noalias() = F_ * term;
    next.noalias() += drive.lazyProduct(own);
    term = next * part;
    own = times_rates(own, kappa) * part;
    gamma += term;
    e += own;
  }
  std::vector<InputMatrix> result(levels());
  for (std::size_t level = finest;; --level) {
    result[level] = gamma.cast<double>();
    if (level == 0) return result;
    next.noalias() = exact_[level] * gamma;
    next.noalias() += gamma.lazyProduct(e);
    gamma.swap(next);
    e = e.lazyProduct(e).eval();
  }
}

}  // namespace trivet::response
