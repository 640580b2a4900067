// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/known_poles.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>
#include <limits>

#include "trivet/foundation/index.h"

namespace trivet::numerics {
namespace {

using Complex = std::complex<double>;

/// A product of many factors, z · 2^exponent: sums of logarithms would lose two digits.
class LongProduct {
 public:
  void times(const Complex& factor) {
    z_ *= factor;
    int exponent = 0;
    static_cast<void>(std::frexp(std::max(std::abs(z_.real()), std::abs(z_.imag())), &exponent));
    z_ = {std::ldexp(z_.real(), -exponent), std::ldexp(z_.imag(), -exponent)};
    exponent_ += exponent;
  }
  [[nodiscard]] int exponent() const { return exponent_; }
  [[nodiscard]] Complex value(int unit) const {
    return {std::ldexp(z_.real(), exponent_ - unit), std::ldexp(z_.imag(), exponent_ - unit)};
  }

 private:
  Complex z_ = 1;
  int exponent_ = 0;
};

}  // namespace

std::vector<double> leja_nodes(const std::vector<double>& candidates, const Eigen::VectorXcd& poles,
                               std::size_t count) {
  const Eigen::Map<const Eigen::ArrayXd> x(candidates.data(), std::ssize(candidates));
  Eigen::ArrayXd log_size = Eigen::ArrayXd::Zero(x.size());
  for (const Complex& pole : poles) log_size -= 0.5 * ((x - pole.real()).square() + pole.imag() * pole.imag()).log();
  std::vector<double> nodes;
  while (nodes.size() < std::min(count, candidates.size())) {
    Eigen::Index next = 0;
    log_size.maxCoeff(&next);
    nodes.push_back(x(next));
    log_size += (x - x(next)).abs().log();  // −∞ at the node itself
  }
  return nodes;
}

Eigen::VectorXcd weights_for_poles(const Eigen::VectorXd& nodes, const Eigen::VectorXcd& poles) {
  assert(nodes.size() > poles.size() && "the numerator has a smaller degree than there are nodes");
  std::vector<LongProduct> products(to_size(nodes.size()));
  int largest = std::numeric_limits<int>::min();
  for (Eigen::Index j = 0; j < nodes.size(); ++j) {
    LongProduct& product = products[to_size(j)];
    for (const Complex& pole : poles) product.times(nodes(j) - pole);
    for (Eigen::Index i = 0; i < nodes.size(); ++i)
      if (i != j) product.times(1 / (nodes(j) - nodes(i)));
    largest = std::max(largest, product.exponent());
  }
  Eigen::VectorXcd weights(nodes.size());
  for (Eigen::Index j = 0; j < nodes.size(); ++j) weights(j) = products[to_size(j)].value(largest);
  return weights;
}

}  // namespace trivet::numerics
