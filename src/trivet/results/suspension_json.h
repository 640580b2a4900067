// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/study/suspension.h"

namespace trivet::study {

/// JSON (docs/json.md), and one CSV row per body and mode.
[[nodiscard]] std::string suspension_json(const Case& variant, const SuspensionAnswer& answer);
[[nodiscard]] std::string suspension_csv(const Case& variant, const SuspensionAnswer& answer);

}  // namespace trivet::study
