// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/project/project.h"

namespace trivet::report {

/// Bodies, elements with their matrices and what their laws assume, excitations, foundations, gravity and system
/// damping of a case.
/// @param file_text  of the project file, if it states this case as it is; else empty. Tables that repeat it are marked
///                   with the attribute data-in-file.
[[nodiscard]] std::string input_tables(const project::Case& variant, const std::string& file_text);

/// Relative motions, sections and clearances.
[[nodiscard]] std::string observations_table(const model::Description& description);

}  // namespace trivet::report
