// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/modal/exact_roots.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "trivet/numerics/linalg/pivoted_lu.h"

namespace trivet::modal {
namespace {

using Complex = std::complex<double>;

/// True if all elements have a dynamic stiffness at this frequency.
bool is_defined(const assembly::Assembled& assembled, double omega) {
  return omega > 0 && std::ranges::all_of(assembled.elements, [&](const assembly::ElementMap& map) {
           return omega >= map.defined_from && omega <= map.defined_to;
         });
}

}  // namespace

Eigen::MatrixXcd stiffness_slope(const assembly::Assembled& assembled, Complex lambda) {
  assert(std::abs(lambda) > 0 && "the step of the difference is a share of λ");
  // A central difference along the real axis of λ; Z is analytic, so the step may be as coarse as ε^(1/3).
  const double step = 6e-6 * std::abs(lambda), near = lambda.imag();
  const Complex minus_i(0, -1);
  return (assembled.dynamic_stiffness(minus_i * (lambda + step), near) -
          assembled.dynamic_stiffness(minus_i * (lambda - step), near)) /
      (2 * step);
}

ExactRoot exact_root(const assembly::Assembled& assembled, Complex start, const Eigen::VectorXcd& shape) {
  assert(start.imag() > 0 && "D(ω) of the elements is that of a positive frequency");
  assert(assembled.frequency_dependent() && shape.size() >= assembled.constant.size());
  constexpr int most_steps = 25;
  constexpr double settled = 1e-12, strayed = 0.3;
  ExactRoot root{start, shape.head(assembled.constant.size()), false};
  const Eigen::VectorXd scale = numerics::unit_scale(assembled.constant);
  Eigen::VectorXcd v = root.shape.cwiseQuotient(scale.cast<Complex>());
  if (v.norm() == 0) return root;
  v.normalize();
  for (int i = 0; i < most_steps && !root.converged; ++i) {
    const Complex lambda = root.eigenvalue;
    if (!is_defined(assembled, lambda.imag()) || std::abs(lambda - start) > strayed * std::abs(start))
      return {start, shape, false};
    const Eigen::MatrixXcd z =
        scale.asDiagonal() * assembled.dynamic_stiffness(Complex(0, -1) * lambda, lambda.imag()) * scale.asDiagonal();
    const Eigen::MatrixXcd rate = scale.asDiagonal() * stiffness_slope(assembled, lambda) * scale.asDiagonal();
    const Eigen::VectorXcd right = rate * v, u = numerics::lu_solution(z, right);
    const Complex share = v.dot(u);
    if (!std::isfinite(std::abs(share))) {
      root.converged = true;  // singular to the last digit: λ is a root already
      break;
    }
    const Complex change = 1.0 / share;
    root.eigenvalue -= change;
    v = u.normalized();
    root.converged = std::abs(change) <= settled * std::abs(lambda);
  }
  root.shape = scale.asDiagonal() * v;
  Eigen::Index largest = 0;
  v.cwiseAbs().maxCoeff(&largest);
  root.shape *= scale(largest) / root.shape(largest);
  return root;
}

}  // namespace trivet::modal
