// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace trivet::numerics {

/// Collocation of ẏ = f at the 8 Radau nodes of a panel [0, 1], the last one at its end: L-stable, of order 15 (Radau
/// IIA). [Hairer, Wanner, Solving Ordinary Differential Equations II, IV.5]
struct RadauPanel {
  static constexpr int nodes = 8;
  using Vector = Eigen::Matrix<double, nodes, 1>;
  using Matrix = Eigen::Matrix<double, nodes, nodes>;

  Vector places;     ///< ascending, the last one is 1
  Vector weights;    ///< of an integral over the panel
  Matrix integrals;  ///< row i: weights of the integral from 0 to place i

  /// Weights of the value at 0 and those at the nodes in the value at a place in the panel.
  [[nodiscard]] Eigen::Matrix<double, 1, nodes + 1> interpolation(double place) const;
};
[[nodiscard]] const RadauPanel& radau_panel();

/// The panel of ẏ = r − a y over a length h: y at the nodes = `of_start` y(0) + `of_source` r at the nodes.
/// @param decay  a at the nodes
struct DecayingPanel {
  DecayingPanel(double length, const RadauPanel::Vector& decay);

  RadauPanel::Vector of_start;
  RadauPanel::Matrix of_source;
};

}  // namespace trivet::numerics
