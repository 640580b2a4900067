// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace trivet::numerics {

/// Instruction set of the kernels in use: "AVX3" (AVX-512), "AVX2", "NEON", or "SCALAR" …
[[nodiscard]] std::string instruction_set();

/// All instruction sets that are compiled and that this processor supports, best first.
[[nodiscard]] std::vector<std::string> instruction_sets();

/// Makes all kernels use this one of `instruction_sets()` from now on; empty: the best one again. For tests and
/// measurements.
/// @throws foundation::InvalidInput if it is not one of them
void use_instruction_set(const std::string& name);

}  // namespace trivet::numerics
