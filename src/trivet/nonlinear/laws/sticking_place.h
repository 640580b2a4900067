// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace trivet::nonlinear {

struct Disc {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double radius = 0;
  double hoop = 1;  ///< of an ellipse: its first axis is the radius over this
};

/// The place that lies deepest within all discs, and its derivatives by the one to three discs that hold it. Within
/// ellipses the discs through it: as deep as within each of them, but another place may be a little deeper.
struct DeepestPlace {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  double beyond = 0;  ///< the edge of the discs that hold it; > 0: they have no common point, or none was found
  struct Held {
    std::size_t disc = 0;
    Eigen::Matrix2d by_center = Eigen::Matrix2d::Identity();
    Eigen::Vector2d by_radius = Eigen::Vector2d::Zero(), by_hoop = Eigen::Vector2d::Zero();
  };
  std::vector<Held> held;
};
/// @param discs  at least one
[[nodiscard]] DeepestPlace deepest_place(const std::vector<Disc>& discs);

}  // namespace trivet::nonlinear
