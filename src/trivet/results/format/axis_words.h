// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/project/analyses/analyses.h"

namespace trivet::results {

/// Name of an axis: as given, or the meaning of its path in the field's words ("stiffness scale of suspension").
[[nodiscard]] std::string axis_name(const project::DesignAxis& axis);

/// Unit of the numbers on an axis: that given with from and to, otherwise the SI unit of its quantity; empty if there
/// is none or it is not known.
[[nodiscard]] std::string axis_unit(const project::DesignAxis& axis);

/// Is it a dimensionless number?
[[nodiscard]] bool is_pure_number(const project::DesignAxis& axis);

/// "0.12 s", with enough digits to distinguish neighbouring designs.
[[nodiscard]] std::string axis_value(double value, const project::DesignAxis& axis);

}  // namespace trivet::results
