// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/assembly/assembled_once.h"
#include "trivet/foundation/problems.h"
#include "trivet/project/project.h"

namespace trivet::judging {

/// Does the machine stand? An error if its weight makes it fall over; of a nonlinear machine, whose forces may hold it
/// farther away, a warning. @param assembled  the system of the case
[[nodiscard]] foundation::Problems standing_problems(const project::Case& variant,
                                                     const assembly::AssembledOnce& assembled);

/// The error of a case that has clearances and no static result: without one, how far they close at rest is not known.
[[nodiscard]] foundation::Problems without_rest(const project::Case& variant, const assembly::AssembledOnce& assembled);

}  // namespace trivet::judging
