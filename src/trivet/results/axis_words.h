// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/project/analyses/analyses.h"

namespace trivet::results {

/// What an axis is called: its name, or what its path means in the field's words ("stiffness scale of suspension").
[[nodiscard]] std::string axis_name(const project::MapAxis& axis);

/// The unit of the numbers on an axis: that written beside from and to, else the SI unit that a bare number of this key
/// has; empty if it has none or that is not known.
[[nodiscard]] std::string axis_unit(const project::MapAxis& axis);

/// A number that no unit belongs to.
[[nodiscard]] bool is_pure_number(const project::MapAxis& axis);

/// "0.12 s", with the digits that tell neighbouring designs apart.
[[nodiscard]] std::string axis_value(double value, const project::MapAxis& axis);

}  // namespace trivet::results
