// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/study/explain/suspension.h"

namespace trivet::results {

/// JSON (docs/json.md), and one CSV row per body and mode.
[[nodiscard]] std::string suspension_json(const project::Case& variant, const study::SuspensionResult& result);
[[nodiscard]] std::string suspension_csv(const project::Case& variant, const study::SuspensionResult& result);

/// Elastic centre, roll axes and decoupling of every body, and the separation of the natural frequencies.
[[nodiscard]] std::string suspension_text(const project::Case& variant, const study::SuspensionResult& result);

}  // namespace trivet::results
