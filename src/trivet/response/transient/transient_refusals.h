// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/assembly/assembled.h"
#include "trivet/assembly/channels.h"
#include "trivet/model/system.h"
#include "trivet/response/transient/transient.h"

namespace trivet::response {

/// Elements whose motion in time is that of a linear system with constant coefficients.
/// @throws foundation::NotComputable otherwise, naming the elements, the reason, and equivalents with their numbers
void require_constant_coefficients(const model::System& system, const assembly::Assembled& assembled, const std::vector<TimeInput>& inputs,
                                   bool nearest_linear_system);

/// Frequency-dependent elements as their nearest linear system, also where they stand on the ground and in the answers.
[[nodiscard]] assembly::Assembled nearest_linear(const assembly::Assembled& assembled);
[[nodiscard]] assembly::Channel nearest_linear(const assembly::Assembled& assembled, assembly::Channel channel);

}  // namespace trivet::response
