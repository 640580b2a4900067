// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace trivet::response {

/// Nodes [rad/s] and weights of an integral over frequency.
struct IntegrationNodes {
  Eigen::VectorXd omega, weight;
};

/// Boundaries of panels between two frequencies, ascending. All poles are outside the Bernstein ellipse of each panel
/// (foci at its ends) for which a Gauss rule of n points converges like 2.8⁻²ⁿ, and half width · `longest_delay` is
/// below 6. Poles on the axis inside the band are not allowed.
[[nodiscard]] std::vector<double> graded_panels(const Eigen::VectorXcd& poles, double from, double to,
                                                double longest_delay);

/// Gauss–Legendre rule with 16 points on every panel between neighbouring ends: error 3e-15 for one pole on its
/// ellipse.
[[nodiscard]] IntegrationNodes gauss_nodes(const std::vector<double>& ends);

/// 15 Gauss–Kronrod nodes on [−1, 1], ascending, with the weights of both rules; the Gauss rule uses 7 of them.
/// [QUADPACK, 1983]
struct KronrodRule {
  Eigen::Array<double, 15, 1> node, kronrod, gauss;
};
[[nodiscard]] KronrodRule kronrod_rule();

}  // namespace trivet::response
