// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/modal/modes.h"

namespace trivet::modal {

/// Descriptions of the motions that no element restrains: "the system is free to slide along y", "… to turn about z
/// through (…) m", and for relative motions of parts the bodies that move. Empty if every motion is restrained.
[[nodiscard]] std::vector<std::string> free_motions(const model::System& system, const assembly::Assembled& assembled,
                                                    const Modes& modes);

}  // namespace trivet::modal
