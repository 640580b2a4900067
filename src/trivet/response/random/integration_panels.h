// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace trivet::response {

/// Nodes [rad/s] and weights of an integral over frequency.
struct IntegrationNodes {
  Eigen::VectorXd omega, weight;
};

/// Ends of panels from one frequency to another, ascending. Every panel of half width h keeps all poles outside the
/// ellipse about its ends on which a Gauss rule of n points converges like 2.8⁻²ⁿ (Bernstein ellipse), and h ·
/// `longest_delay` below 6. Poles on the axis inside the band must not be among them.
[[nodiscard]] std::vector<double> graded_panels(const Eigen::VectorXcd& poles, double from, double to,
                                                double longest_delay);

/// Gauss–Legendre rule with 16 points on every panel between neighbouring ends: 3e-15 for one pole on its ellipse.
[[nodiscard]] IntegrationNodes gauss_nodes(const std::vector<double>& ends);

/// 15 nodes of Gauss and Kronrod on [−1, 1], ascending, with the weights of both rules; the Gauss rule has 7 points.
/// [QUADPACK, 1983]
struct KronrodRule {
  Eigen::Array<double, 15, 1> node, kronrod, gauss;
};
[[nodiscard]] KronrodRule kronrod_rule();

}  // namespace trivet::response
