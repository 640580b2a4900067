// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/assembly/loads.h"
#include "trivet/modal/roots.h"

namespace trivet::response {

/// Does each curve vanish at rest and towards ω = ∞, and not between? Then its highest peak stands over two minima of
/// 0, whatever the damping. Seen where a curve goes on like a power of ω: below the lowest root and above the highest.
/// Where elements follow a law of their own over ω, or the load is delayed, curves are searched up to a last ω and have
/// no end at infinity; beside a free motion, which grows towards rest, what others do there is not seen: none is told
/// to vanish then.
[[nodiscard]] std::vector<bool> vanish_at_both_ends(const assembly::Assembled& assembled,
                                                    const std::vector<assembly::Channel>& channels,
                                                    const assembly::Loading& loading, const modal::Roots& roots);

}  // namespace trivet::response
