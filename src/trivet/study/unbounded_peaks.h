// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/project.h"

namespace trivet::study {

/// A no-peak rule can never be kept by an answer that vanishes both at rest and towards ω = ∞, in the base model of the
/// map and in its middle.
/// @throws foundation::NotComputable with these answers, the reason and what to do
void refuse_unbounded_peaks(const project::Case& variant, const project::MapRequest& request);

}  // namespace trivet::study
