// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/study/optimize/optimization.h"

namespace trivet::study {

/// Warnings of parameters on which nothing depends where the search ended, of requirements on results that are zero,
/// and of a given design that is better than the optimum.
/// @throws foundation::NotComputable if all requirements are on zero results, so that no design is better than another
[[nodiscard]] foundation::Problems optimum_warnings(const project::Project& project, const Optimization& found);

}  // namespace trivet::study
