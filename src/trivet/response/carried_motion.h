// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/assembly/loads.h"

namespace trivet::response {

/// Matrices and answers in other coordinates; the loading stays.
struct BeyondCarried {
  assembly::Assembled assembled;
  std::vector<assembly::Channel> channels;
};

/// The same system in r = q − q_g, the motion beyond that which the ground carries along without inertia: q_g = −K⁻¹K_g g.
/// Z r = Q − (sB' + s²A') g with B' = B_g − BK⁻¹K_g, A' = A_g − AK⁻¹K_g, and an answer cᵀq + dᵀg is cᵀr + (d − cᵀK⁻¹K_g)g. A ground given by its velocity or
/// acceleration moves without bound towards rest: there a relative motion is a small difference of q and g, but r itself. What is left of a
/// difference of equal terms (a rigid ground carries all elements along) is set to zero.
/// None where nothing is gained: a ground at rest or given by its displacement, elements that depend on frequency in their own way, a singular K.
[[nodiscard]] std::optional<BeyondCarried> beyond_carried(const assembly::Assembled& assembled, const std::vector<assembly::Channel>& channels,
                                                          const assembly::Loading& loading);

}  // namespace trivet::response
