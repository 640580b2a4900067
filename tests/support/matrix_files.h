// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>

#include "trivet/exchange/named_matrix.h"

namespace trivet::test {

/// A straight bar along z, Bernoulli bending, order (u_N, θ_N, u_K, θ_K), in any consistent units.
struct Bar {
  double length = 120, axial = 210e3 * 200, torsion = 80e3 * 4577, bending_about_x = 210e3 * 1666.6666666666667,
         bending_about_y = 210e3 * 6666.6666666666667;
};
/// The bar of tests/data/matrices/make_numpy_files.py, in mm and N.
[[nodiscard]] inline Eigen::Matrix<double, 12, 12> bernoulli(const Bar& bar = {}) {
  Eigen::Matrix<double, 12, 12> k = Eigen::Matrix<double, 12, 12>::Zero();
  const auto two = [&](int i, double value) {
    k(i, i) = k(i + 6, i + 6) = value;
    k(i, i + 6) = k(i + 6, i) = -value;
  };
  const double l = bar.length;
  two(2, bar.axial / l);
  two(5, bar.torsion / l);
  const auto bend = [&](int u, int turn, double stiffness, double sign) {
    two(u, 12 * stiffness / (l * l * l));
    for (const int end : {0, 6}) {
      k(turn + end, turn + end) = 4 * stiffness / l;
      for (const int other : {0, 6})
        k(u + other, turn + end) = k(turn + end, u + other) = (other == 0 ? 1 : -1) * sign * 6 * stiffness / (l * l);
    }
    k(turn, turn + 6) = k(turn + 6, turn) = 2 * stiffness / l;
  };
  bend(0, 4, bar.bending_about_y, 1);
  bend(1, 3, bar.bending_about_x, -1);
  return k;
}

/// √K_ii: scales for comparing entries of mixed units.
[[nodiscard]] inline Eigen::VectorXd entry_scale(const Eigen::MatrixXd& matrix) {
  return matrix.diagonal().cwiseAbs().cwiseSqrt();
}

/// The text of all problems, or "none".
template <typename T>
std::string complaint(const foundation::Expected<T>& result) {
  if (result) return "none";
  std::string text;
  for (const auto& problem : result.error().list()) text += message(problem) + "\n";
  return text;
}

}  // namespace trivet::test
