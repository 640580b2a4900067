// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/project/project.h"

namespace trivet::report {

/// Bodies, elements with their matrices, excitations, foundations, gravity and system damping of a case.
[[nodiscard]] std::string input_tables(const project::Case& variant);

/// Relative motions, sections and clearances.
[[nodiscard]] std::string observations_table(const model::Description& description);

}  // namespace trivet::report
