// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "trivet/model/system.h"
#include "trivet/project/text/table_reader.h"

namespace trivet::project {

/// Compliant directions of a ground point with measured mobility, v = Y F in ground axes. `file` has the columns
/// frequency_hz and, per entry, y_I_J and y_I_J_im with I, J out of x, y, z, rx, ry, rz [(m/s)/N, (rad/s)/(N m) …], of
/// the upper triangle of the symmetric Y. `to_ground` gets the dynamic stiffness iωY⁻¹ of the directions in the table;
/// the others are rigid. Rejects rows that feed energy (Re Y must be positive semidefinite) and diagonal entries that
/// no passive, causal ground has.
[[nodiscard]] std::optional<std::vector<int>> read_mobility_table(TableReader& reader, model::Element& to_ground);

}  // namespace trivet::project
