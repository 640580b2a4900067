// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/study/explain/explanation.h"

namespace trivet::study {

/// "machine.x: 8.4 mm at 2.77 rad/s (0.441 Hz). Mode 2, rotation about x, contributes 93 % of it. …"
[[nodiscard]] std::string sentence(const project::Case& variant, const Explanation& explanation,
                                   const ExplainedPeak& peak);

}  // namespace trivet::study
