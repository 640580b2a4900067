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

/// Cases in which a design has to hold and which set a number that a parameter moves: the parameter would undo the
/// case, so that `optimize` refuses them. @param parameters  names of those that take part; empty: all
[[nodiscard]] foundation::Problems overruled_cases(const project::Project& project,
                                                   const std::vector<std::string>& parameters);

/// The same of the parameters that the file's own search takes.
[[nodiscard]] foundation::Problems overruled_cases(const project::Project& project);

}  // namespace trivet::study
