// SPDX-License-Identifier: BSD-3-Clause
// True natural frequencies: K φ = λ A φ of six coordinates by Cholesky and cyclic Jacobi in quadruple precision.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "paper_machine.h"
#include "quad.h"

namespace trivet::benchmarks {

inline Quad square_root(Quad x) {
  Quad r = std::sqrt(static_cast<double>(x));
  for (int i = 0; i < 2; ++i) r = (r + x / r) / 2;
  return r;
}

/// λ, ascending.
inline std::array<Quad, 6> quad_modes(const Matrix6& K, const Matrix6& A) {
  Quad l[6][6] = {}, c[6][6], half[6][6];
  for (int j = 0; j < 6; ++j)
    for (int i = j; i < 6; ++i) {
      Quad sum = A(i, j);
      for (int k = 0; k < j; ++k) sum -= l[i][k] * l[j][k];
      l[i][j] = i == j ? square_root(sum) : sum / l[j][j];
    }
  const auto divided = [&](const auto& from, Quad(&to)[6][6]) {  // L⁻¹ from
    for (int j = 0; j < 6; ++j)
      for (int i = 0; i < 6; ++i) {
        Quad sum = from(i, j);
        for (int k = 0; k < i; ++k) sum -= l[i][k] * to[k][j];
        to[i][j] = sum / l[i][i];
      }
  };
  divided([&](int i, int j) { return Quad(K(i, j)); }, half);
  divided([&](int i, int j) { return half[j][i]; }, c);
  for (int round = 0; round < 12; ++round)
    for (int p = 0; p < 5; ++p)
      for (int q = p + 1; q < 6; ++q) {
        if (c[p][q] == 0) continue;
        const Quad theta = (c[q][q] - c[p][p]) / (2 * c[p][q]), magnitude = theta < 0 ? -theta : theta;
        const Quad t = (theta < 0 ? -1 : 1) / (magnitude + square_root(theta * theta + 1)),
                   cosine = 1 / square_root(t * t + 1), sine = t * cosine;
        for (int k = 0; k < 6; ++k) {
          const Quad a = c[k][p], b = c[k][q];
          c[k][p] = cosine * a - sine * b, c[k][q] = sine * a + cosine * b;
        }
        for (int k = 0; k < 6; ++k) {
          const Quad a = c[p][k], b = c[q][k];
          c[p][k] = cosine * a - sine * b, c[q][k] = sine * a + cosine * b;
        }
      }
  std::array<Quad, 6> lambda;
  for (std::size_t i = 0; i < 6; ++i) lambda[i] = c[i][i];
  std::ranges::sort(lambda);
  return lambda;
}

}  // namespace trivet::benchmarks
