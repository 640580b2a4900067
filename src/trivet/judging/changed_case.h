// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/foundation/problems.h"
#include "trivet/model/system.h"
#include "trivet/project/model_number.h"
#include "trivet/project/project.h"

/// One case with other numbers. Only the changed parts are read again.
namespace trivet::judging {

/// Model of a case with these values, without analyses; or all problems at once. May run on any number of threads at
/// once.
[[nodiscard]] foundation::Expected<model::System> changed_system(const project::Case& variant,
                                                                 const project::Design& design);

/// The same with changes of the file.
/// @param may_fall  also of a machine that its weight makes fall over, which is no valid model otherwise
[[nodiscard]] foundation::Expected<model::System> changed_system(const project::Case& variant,
                                                                 const std::vector<project::Node>& changes,
                                                                 bool may_fall = false);

/// The case with changes of its model: its analyses and warnings are those of `variant`.
[[nodiscard]] foundation::Expected<project::Case> changed_case(const project::Case& variant,
                                                               const std::vector<project::Node>& changes);

}  // namespace trivet::judging
