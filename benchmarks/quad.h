// SPDX-License-Identifier: BSD-3-Clause
// True solution for comparisons: Z(ω) q = h by pivoted elimination in quadruple precision (113 bits).
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <complex>
#include <vector>

#include "trivet/foundation/index.h"

namespace trivet::benchmarks {

using Quad = __float128;

struct QuadComplex {
  Quad re = 0, im = 0;
};
inline QuadComplex operator*(QuadComplex a, QuadComplex b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
inline QuadComplex operator-(QuadComplex a, QuadComplex b) { return {a.re - b.re, a.im - b.im}; }
inline Quad size(QuadComplex a) { return (a.re < 0 ? -a.re : a.re) + (a.im < 0 ? -a.im : a.im); }
inline QuadComplex inverse(QuadComplex a) {
  const Quad scale = 1 / (a.re * a.re + a.im * a.im);
  return {a.re * scale, -a.im * scale};
}

/// (K + iωB − ω²A)⁻¹ h
template <typename Matrix, typename Vector>
std::vector<QuadComplex> quad_solution(const Matrix& A, const Matrix& B, const Matrix& K, const Vector& h,
                                       double omega) {
  const int n = static_cast<int>(h.size());
  std::vector<std::vector<QuadComplex>> z(to_size(n), std::vector<QuadComplex>(to_size(n) + 1));
  const auto at = [&](int i, int j) -> QuadComplex& { return z[i][j]; };
  const Quad w = omega;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) at(i, j) = {Quad(K(i, j)) - w * w * Quad(A(i, j)), w * Quad(B(i, j))};
    at(i, n) = {std::real(h(i)), std::imag(h(i))};
  }
  for (int j = 0; j < n; ++j) {
    int pivot = j;
    for (int i = j + 1; i < n; ++i)
      if (size(at(i, j)) > size(at(pivot, j))) pivot = i;
    std::swap(z[j], z[pivot]);
    const QuadComplex d = inverse(at(j, j));
    for (int i = j + 1; i < n; ++i) {
      const QuadComplex factor = at(i, j) * d;
      for (int k = j + 1; k <= n; ++k) at(i, k) = at(i, k) - factor * at(j, k);
    }
  }
  std::vector<QuadComplex> q(to_size(n));
  for (int i = n - 1; i >= 0; --i) {
    QuadComplex sum = at(i, n);
    for (int k = i + 1; k < n; ++k) sum = sum - at(i, k) * q[k];
    q[i] = sum * inverse(at(i, i));
  }
  return q;
}

/// Forward error max |x_i − q_i| s_i / max |q_i| s_i; s makes coordinates comparable.
template <typename Values, typename Scale>
double forward_error(const Values& x, const std::vector<QuadComplex>& q, const Scale& s) {
  double difference = 0, largest = 0;
  for (std::size_t i = 0; i < q.size(); ++i) {
    const auto k = to_index(i);
    const std::complex<double> value = x[k];
    const QuadComplex d = QuadComplex{value.real(), value.imag()} - q[i];
    const double scale = s[k];
    const double error = scale * std::hypot(double(d.re), double(d.im));
    difference = error <= difference ? difference : error;  // keeps NaN
    largest = std::max(largest, scale * std::hypot(double(q[i].re), double(q[i].im)));
  }
  return difference / largest;
}

/// Backward error ‖Zx − h‖ / (‖Z‖ ‖x‖ + ‖h‖) in maximum norms, coordinates scaled to x_i s_i; |re| + |im| replaces the
/// modulus.
template <typename Matrix, typename Vector, typename Values, typename Scale>
double backward_error(const Matrix& A, const Matrix& B, const Matrix& K, const Vector& h, double omega, const Values& x,
                      const Scale& s) {
  const int n = static_cast<int>(h.size());
  const Quad w = omega;
  Quad residual = 0, norm = 0, solution = 0, load = 0;
  for (int i = 0; i < n; ++i) {
    QuadComplex r{h(i), 0};
    Quad row = 0;
    for (int j = 0; j < n; ++j) {
      const QuadComplex z{Quad(K(i, j)) - w * w * Quad(A(i, j)), w * Quad(B(i, j))};
      const std::complex<double> value = x[j];
      r = r - z * QuadComplex{value.real(), value.imag()};
      row += size(z) / s[j];
    }
    const std::complex<double> value = x[i];
    residual = size(r) / s[i] <= residual ? residual : size(r) / s[i];  // keeps NaN
    norm = std::max(norm, row / s[i]);
    solution = std::max(solution, s[i] * size({value.real(), value.imag()}));
    load = std::max(load, size({h(i), 0}) / s[i]);
  }
  return static_cast<double>(residual / (norm * solution + load));
}

}  // namespace trivet::benchmarks
