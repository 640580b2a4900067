// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/foundation/problems.h"
#include "trivet/project/project.h"

namespace trivet::judging {

/// Largest share of the numbers of a tolerance that may be impossible.
inline constexpr double most_impossible = 0.01;

/// Tolerances whose numbers change their sign where the model needs it: a mass ≤ 0, a stiffness < 0. Their share is
/// stated: a warning up to `most_impossible`, above it an error, at the place with the largest share. Each number is
/// tried alone, all others as in the file.
[[nodiscard]] foundation::Problems tolerance_reach(const project::Case& base);

}  // namespace trivet::judging
