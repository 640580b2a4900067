// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "trivet/project/project.h"

namespace trivet::report {

/// One element as a static SVG: its 12×12 as a heat map; below it the residuals of the readings from which it was
/// identified, and |D(ω)| of its end K if it has mass, relaxes or is a table.
[[nodiscard]] std::string element_picture(const project::Case& variant, std::size_t element);

}  // namespace trivet::report
