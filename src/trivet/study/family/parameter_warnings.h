// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/foundation/problems.h"
#include "trivet/study/family/design_space.h"

namespace trivet::study {

/// Warnings of parameters whose value in the file lies outside their range, or whose places have different values
/// there: a search then cannot start at the design of the file.
[[nodiscard]] foundation::Problems parameter_warnings(const project::Project& project, const DesignSpace& space);

}  // namespace trivet::study
