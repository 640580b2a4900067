// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/study/explain/explanation.h"

namespace trivet::results {

/// For each explained peak: its sentence, the shares of modes and elements, and the parameters that change it most.
[[nodiscard]] std::string explain_text(const project::Case& variant, const study::Explanation& explanation);

}  // namespace trivet::results
