// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/documents/shown_numbers.h"
#include "trivet/nonlinear/branch/steady_branch.h"
#include "trivet/project/analyses/analyses.h"
#include "trivet/results/format/in_documents.h"

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

// Words and numbers of what is varied along steady motions: frequency of the excitation, speed of a shaft, or load.

/// "frequency", "speed", "load".
[[nodiscard]] const char* varied_word(const nonlinear::SteadyBranch& branch);
/// "Hz", "rpm", "times the load".
[[nodiscard]] std::string varied_unit(const nonlinear::SteadyBranch& branch, const project::DisplayUnits& display);
/// "frequency [Hz]", "shaft speed [rpm]", "load factor".
[[nodiscard]] std::string varied_heading(const nonlinear::SteadyBranch& branch, const project::DisplayUnits& display);
/// A value of the parameter, rad/s or a factor, in that unit.
[[nodiscard]] double shown_varied(const nonlinear::SteadyBranch& branch, double parameter,
                                  const project::DisplayUnits& display);

}  // namespace trivet::results
