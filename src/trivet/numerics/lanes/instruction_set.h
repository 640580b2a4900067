// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace trivet::numerics {

/// The instruction set whose kernels run on this processor: "AVX3" (AVX-512), "AVX2", "NEON", or "SCALAR" …
[[nodiscard]] std::string instruction_set();

/// All that were compiled and that this processor has, best first.
[[nodiscard]] std::vector<std::string> instruction_sets();

/// Runs all kernels with this one of `instruction_sets()` from now on; empty: with the best again. For tests and
/// measurements.
/// @throws foundation::InvalidInput if this processor has no such thing
void use_instruction_set(const std::string& name);

}  // namespace trivet::numerics
