// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/nonlinear/branch/steady_branch.h"
#include "trivet/project/text/display_units.h"
#include "trivet/results/format/json_parts.h"

/// Harmonics of all motions found at the parameters that were requested (`trivet steady --at`).
namespace trivet::results {

/// Amplitude and phase of each harmonic and result. Phases are those of cos, at the instant t = 0 of the excitation.
[[nodiscard]] std::string harmonics_text(const nonlinear::SteadyBranch& branch, const project::DisplayUnits& display);
/// One line per motion and harmonic, SI and rad.
[[nodiscard]] std::string harmonics_csv(const nonlinear::SteadyBranch& branch);
namespace json {
/// A list of the parameters with their motions.
[[nodiscard]] Json harmonics(const nonlinear::SteadyBranch& branch);
}  // namespace json

}  // namespace trivet::results
