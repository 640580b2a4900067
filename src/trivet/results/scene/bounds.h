// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace trivet::results {

/// Lowest and highest coordinates of some places [m].
struct Bounds {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e300), high = Eigen::Vector3d::Constant(-1e300);

  void include(const Eigen::Vector3d& place) {
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
  [[nodiscard]] Eigen::Vector3d centre() const { return (low + high) / 2; }
  /// Length of the diagonal.
  [[nodiscard]] double size() const { return (high - low).norm(); }
};

}  // namespace trivet::results
