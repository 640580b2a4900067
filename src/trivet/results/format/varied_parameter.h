// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/documents/shown_numbers.h"
#include "trivet/nonlinear/branch/steady_branch.h"
#include "trivet/results/format/in_documents.h"

/// Words and numbers of what is varied along steady motions: frequency of the excitation, speed of a shaft, or load.
namespace trivet::results {

/// "frequency", "speed", "load".
[[nodiscard]] const char* varied_word(const nonlinear::SteadyBranch& branch);
/// "Hz", "rpm", "times the load".
[[nodiscard]] std::string varied_unit(const nonlinear::SteadyBranch& branch, const project::ShownUnits& display);
/// "frequency [Hz]", "shaft speed [rpm]", "load factor".
[[nodiscard]] std::string varied_heading(const nonlinear::SteadyBranch& branch, const project::ShownUnits& display);
/// A value of the parameter, rad/s or a factor, in that unit.
[[nodiscard]] double shown_varied(const nonlinear::SteadyBranch& branch, double parameter,
                                  const project::ShownUnits& display);

/// "the one at the lower end of the band", or "the one at 3.2 Hz" where there is no motion at the lower end.
[[nodiscard]] std::string begun_words(const nonlinear::SteadyBranch& branch, const project::ShownUnits& display);

}  // namespace trivet::results
