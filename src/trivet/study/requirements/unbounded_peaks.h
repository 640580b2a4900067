// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/project/project.h"

namespace trivet::study {

/// Rejects no-peak rules of channels that vanish both at ω = 0 and towards ω = ∞, in the base model of the map and in
/// the middle of the map: such a rule can never be met.
/// @throws foundation::NotComputable with these channels, the reason and what to do
void refuse_unbounded_peaks(const project::Case& variant, const project::MapRequest& request);

/// The same of the requirements of a case, over all designs of these parameters.
void refuse_unbounded_peaks(const project::Case& variant, const std::vector<project::DesignAxis>& parameters);

}  // namespace trivet::study
