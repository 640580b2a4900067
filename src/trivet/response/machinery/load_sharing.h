// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "trivet/assembly/assembled.h"

namespace trivet::response {

/// Static load on one mount.
struct MountLoad {
  std::string element;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< on the ground, ground axes [N]
  double bearing = 0;  ///< component along gravity [N]; negative: the mount holds the machine down
  double share = 0;    ///< fraction of the sum over all mounts; the shares sum to 1
  /// Motion of end K relative to end N under the load, element axes at N [m, rad]; for a preloaded element from its
  /// preloaded state.
  Eigen::Matrix<double, 6, 1> deflection = Eigen::Matrix<double, 6, 1>::Zero();
};

struct LoadSharing {
  std::vector<MountLoad> mounts;  ///< elements with end N on the ground or on a foundation
  double bearing_in_total = 0;    ///< [N]
};

/// Distribution of the weight and the constant forces over the mounts.
/// @throws foundation::NotComputable without gravity, without load along it, or for the reasons of static_response
[[nodiscard]] LoadSharing load_sharing(const model::System& system, const assembly::Assembled& assembled);

// Static loads of catalogue mounts, for every comparison with the ranges of their makers.

/// Static load of one catalogue mount.
struct RatedLoad {
  std::size_t element = 0;
  Eigen::Vector3d load = Eigen::Vector3d::Zero();  ///< along its axes, signs as in `model::Rating::load` [N]
  double deflection = 0;                           ///< of end K relative to N along e3, after creep [m]
};

/// Loads of all elements with a rating under gravity and the constant forces.
/// @throws foundation::NotComputable for the reasons of `static_response`
[[nodiscard]] std::vector<RatedLoad> rated_loads(const model::System& system, const assembly::Assembled& assembled);

/// Axes of a mount at its end N as columns, ground frame.
[[nodiscard]] Eigen::Matrix3d mount_axes(const model::System& system, const model::Element& element);

/// A load within its range, or beyond it by at most 1e-9 of the end, because results have nine digits.
[[nodiscard]] bool is_within(double load, const Eigen::Vector2d& range);

/// Sets loads to 0 that are round-off of the largest one: an unloaded mount is not in tension.
void remove_round_off(std::vector<RatedLoad>& loads);

/// A load below this share of the whole load of its mount needs no range.
inline constexpr double noticeable_load = 0.01;

}  // namespace trivet::response
