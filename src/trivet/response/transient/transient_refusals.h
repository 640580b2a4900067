// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/assembly/assembled.h"
#include "trivet/assembly/channels.h"
#include "trivet/model/system.h"
#include "trivet/response/transient/transient.h"

namespace trivet::response {

/// Inputs from the time histories of these names (all, if none is named).
[[nodiscard]] std::vector<TimeInput> time_inputs(const model::System& system, const assembly::Assembled& assembled,
                                                 const std::vector<std::string>& names);

/// Why the model has no constant coefficients in time: the elements, the reason, and equivalents with their numbers.
/// Empty if it has.
[[nodiscard]] std::optional<foundation::Problem> without_motion_in_time(const model::System& system,
                                                                        const assembly::Assembled& assembled,
                                                                        const std::vector<TimeInput>& inputs,
                                                                        bool nearest_linear_system);

/// @throws foundation::NotComputable with the message of without_motion_in_time
void require_constant_coefficients(const model::System& system, const assembly::Assembled& assembled,
                                   const std::vector<TimeInput>& inputs, bool nearest_linear_system);

/// Replaces frequency-dependent elements by their nearest linear system, also in ground couplings and channels.
[[nodiscard]] assembly::Assembled nearest_linear(const assembly::Assembled& assembled);
[[nodiscard]] assembly::Channel nearest_linear(const assembly::Assembled& assembled, assembly::Channel channel);

}  // namespace trivet::response
