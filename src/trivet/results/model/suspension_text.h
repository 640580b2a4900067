// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/study/explain/suspension.h"

namespace trivet::results {

/// Elastic centre, roll axes and decoupling of every body, and the separation of the natural frequencies.
[[nodiscard]] std::string suspension_text(const project::Case& variant, const study::SuspensionAnswer& answer);

}  // namespace trivet::results
