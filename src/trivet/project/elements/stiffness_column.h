// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "trivet/elements/table_law.h"
#include "trivet/model/system.h"
#include "trivet/project/text/table_reader.h"

/// One stiffness over frequency out of the columns of a file.
namespace trivet::project {

/// Columns frequency [Hz], storage, loss. What is wrong with them goes to the key `file`; a negative loss is only that
/// of a coupling.
[[nodiscard]] std::optional<elements::StiffnessTable> checked_table(TableReader& reader, const std::string& name,
                                                                    const Eigen::MatrixXd& values,
                                                                    elements::Interpolation interpolation,
                                                                    bool coupling = false);

/// Do storage and loss belong together? The verdict becomes a fact of the element, a doubtful one a warning too.
void judge_causality(TableReader& reader, const std::string& name, const elements::StiffnessTable& table,
                     model::Element& element);

/// [rad/s] in words.
[[nodiscard]] model::Fact defined_range(double from, double to);

}  // namespace trivet::project
