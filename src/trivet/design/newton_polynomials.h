// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

/// Newton's interpolation of a function of one number over 0 … 1.
namespace trivet::design {

inline constexpr int most_degree = 16;

/// Nodes of one number, as shares of its range: a share at which no factor of a model is likely to vanish, both ends,
/// and then each as far as possible from all before it (Leja's nodes).
[[nodiscard]] const std::vector<double>& newton_nodes();

/// Newton's polynomials 0 … degree at t.
template <typename Number>
[[nodiscard]] std::vector<Number> newton_polynomials(const Number& t, int degree, const Number& one) {
  const std::vector<double>& nodes = newton_nodes();
  std::vector<Number> values = {one};
  for (int k = 1; k <= degree; ++k) {
    Number product = one;
    for (int l = 0; l < k; ++l) product *= (t - nodes[l]) / (nodes[k] - nodes[l]);
    values.push_back(product);
  }
  return values;
}

/// Their derivatives.
[[nodiscard]] std::vector<double> newton_slopes(double t, int degree);

}  // namespace trivet::design
