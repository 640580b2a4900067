// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace trivet::numerics {

/// Interpolation by rational functions whose poles are known: with weights w_j = Q(x_j) / Π_{i≠j} (x_j − x_i), Q(x) =
/// Π (x − p_k), the barycentric form Σ w_j v_j/(x − x_j) / Σ w_j/(x − x_j) has the poles p_k. It is then exact for
/// every function with these poles whose numerator has a degree below the number of nodes, and needs no fit. [Berrut,
/// Trefethen 2004, SIAM Rev. 46(3), 501; Schneider, Werner 1986, Math. Comp. 47(175), 285]

/// Places of nodes among candidates, each where Π |x − x_i| / |Q(x)| over the earlier ones is largest (Leja points):
/// near each pole close to the axis first, then between them. Errors of interpolation at the first ones are largest
/// at the next one.
/// @param candidates  distinct  @param poles  none is a candidate
/// @return `count` of the candidates, or all of them, in the order of choice
[[nodiscard]] std::vector<double> leja_nodes(const std::vector<double>& candidates, const Eigen::VectorXcd& poles,
                                             std::size_t count);

/// Weights at distinct nodes, the largest of magnitude about 1. @param poles  fewer than the nodes
[[nodiscard]] Eigen::VectorXcd weights_for_poles(const Eigen::VectorXd& nodes, const Eigen::VectorXcd& poles);

}  // namespace trivet::numerics
