// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/assembly/loads.h"

/// Which coordinates an answer is computed in: q, or r = q − R g, which follow the ground (Ground). Far below the
/// lowest natural frequency everything moves with a rigid foundation: there a relative motion is a small difference of
/// q and g, but r itself. Far above, where machines stand still in space, an absolute motion is q, but a small
/// difference in r. Both hold everywhere: docs/decisions/ground-as-driven-coordinates.md.
namespace trivet::assembly {

/// The same loading for coordinates that follow what moves together (Ground::together): the rigid foundation, or
/// supports.
[[nodiscard]] Loading following(const Ground& ground, const Loading& loading);

/// Channels that are answered in the same coordinates, with the loading for these.
struct AnsweredTogether {
  std::vector<std::size_t> which;  ///< places in the list of all channels, ascending
  std::vector<Channel> channels;
  Loading loading;
};

/// Under a ground given by its velocity or acceleration, whose displacement has no bound at rest: relative motions,
/// deflections and forces in coordinates that follow it, the others in space. At most two groups; one where this makes
/// no difference.
[[nodiscard]] std::vector<AnsweredTogether> by_coordinates(const Ground& ground, const std::vector<Channel>& channels,
                                                           const Loading& loading);

/// Curves of channels and what is given to them, without motions of the ground that no curve holds: bounded at rest
/// where these are all that is not.
struct GivenCurves {
  numerics::Load given;
  std::vector<numerics::ObservedCurve> curves;
};
[[nodiscard]] GivenCurves given_curves(const std::vector<Channel>& channels, const numerics::Load& motion);

}  // namespace trivet::assembly
