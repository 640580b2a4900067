// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "trivet/elements/table_law.h"
#include "trivet/model/system.h"
#include "trivet/project/text/column_units.h"
#include "trivet/project/text/table_reader.h"

/// One stiffness over frequency from the columns of a file.
namespace trivet::project {

/// What a column of a table over frequency measures: frequency_hz, k_x … k_rz and the entries k_I_J of a matrix, each
/// with its loss; none for other names.
[[nodiscard]] std::optional<ColumnQuantity> stiffness_column_quantity(const std::string& name);

/// (I, J) of "k_I_J" or "k_I_J_loss", from 1.
[[nodiscard]] std::optional<std::pair<int, int>> matrix_entry_of(std::string_view column);

/// Table of the columns frequency [Hz], storage, loss. Problems are reported at the key `file`; only a coupling may
/// have a negative loss.
[[nodiscard]] std::optional<elements::StiffnessTable> checked_table(TableReader& reader, const std::string& name,
                                                                    const Eigen::MatrixXd& values,
                                                                    elements::Interpolation interpolation,
                                                                    bool coupling = false);

/// Checks if storage and loss are causal. The verdict becomes a fact of the element, a doubtful one also a warning.
void judge_causality(TableReader& reader, const std::string& name, const elements::StiffnessTable& table,
                     model::Element& element);

/// The range [rad/s] as a fact in Hz.
[[nodiscard]] model::Fact defined_range(double from, double to);

}  // namespace trivet::project
