// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/study/explain/explanation.h"

namespace trivet::results {

/// JSON (docs/json.md), and one CSV row per peak and parameter.
[[nodiscard]] std::string explain_json(const project::Case& variant, const study::Explanation& explanation);
[[nodiscard]] std::string explain_csv(const study::Explanation& explanation);

/// For each explained peak: its sentence, the shares of modes and elements, and the parameters that change it most.
[[nodiscard]] std::string explain_text(const project::Case& variant, const study::Explanation& explanation);

}  // namespace trivet::results
