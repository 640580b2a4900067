// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "trivet/elements/table_law.h"
#include "trivet/model/system.h"
#include "trivet/project/text/table_reader.h"

/// One stiffness over frequency from the columns of a file.
namespace trivet::project {

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
