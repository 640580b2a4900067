// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/assembly/loads.h"
#include "trivet/numerics/linalg/dynamic_matrices.h"

namespace trivet::assembly {

// Chooses the coordinates in which a result is computed: q, or r = q − R g relative to the ground (Ground). Far below
// the lowest natural frequency everything moves with a rigid foundation: there a relative motion is a small difference
// of q and g, but r itself. Far above, where machines do not move in space, an absolute motion is q, but a small
// difference in r. Both are valid at all frequencies: docs/decisions/ground-as-driven-coordinates.md.

/// The same loading for coordinates relative to the parts that move together (Ground::together): the rigid foundation,
/// or supports.
[[nodiscard]] Loading following(const Ground& ground, const Loading& loading);

/// Channels that are computed in the same coordinates, with the loading for these.
struct ChannelGroup {
  std::vector<std::size_t> which;  ///< indices in the list of all channels, ascending
  std::vector<Channel> channels;
  Loading loading;
};

/// Groups the channels if the ground is given by its velocity or acceleration, so that its displacement is unbounded at
/// rest: relative motions, deflections and forces in coordinates relative to the ground, the others in space. At most
/// two groups; one if this makes no difference.
[[nodiscard]] std::vector<ChannelGroup> by_coordinates(const Ground& ground, const std::vector<Channel>& channels,
                                                       const Loading& loading);

/// Curves of channels and the given ground motion, without ground motions that no curve uses, so that the curves stay
/// finite at ω = 0.
struct GivenCurves {
  numerics::Load given;
  std::vector<numerics::ObservedCurve> curves;
};
[[nodiscard]] GivenCurves given_curves(const std::vector<Channel>& channels, const numerics::Load& motion);

/// Does K hold every coordinate?
[[nodiscard]] bool holds_all(const numerics::DynamicMatrices& m);

/// Coordinates of K q = Q; if K is singular, the smallest ones that balance what K can balance of Q.
[[nodiscard]] Eigen::VectorXd coordinates_at_rest(const numerics::DynamicMatrices& m, const Eigen::VectorXd& load);

}  // namespace trivet::assembly
