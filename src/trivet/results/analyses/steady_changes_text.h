// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "trivet/documents/document.h"
#include "trivet/nonlinear/branch/steady_branch.h"
#include "trivet/project/text/display_units.h"
#include "trivet/results/format/in_documents.h"

/// Where curves of steady motion turn, change their stability and are left: words and tables.
namespace trivet::results {

/// "rising frequency"
[[nodiscard]] std::string jump_of(const nonlinear::SteadyBranch& branch, const nonlinear::Fold& fold);
/// Where a motion is on a curve, in the shown unit.
[[nodiscard]] std::string place_text(const nonlinear::SteadyBranch& branch, const nonlinear::SteadyPoint& point,
                                     const project::DisplayUnits& display, int digits);
[[nodiscard]] std::ptrdiff_t unstable_points(const nonlinear::SteadyBranch& curve);
/// ", 3 of uncertain stability", or nothing.
[[nodiscard]] std::string uncertain_words(const nonlinear::SteadyBranch& curve);
/// Is it stable: "yes", "no" or "uncertain".
[[nodiscard]] const char* stability_word(const nonlinear::SteadyPoint& point);

/// Largest values of the stable motions, a row for each result.
[[nodiscard]] Table stable_table(const nonlinear::SteadyBranch& branch);
/// Folds of all curves, and what jumps there.
[[nodiscard]] std::string folds_text(const nonlinear::SteadyBranch& branch, const project::DisplayUnits& display);
/// Curves that were sought.
[[nodiscard]] std::string detached_text(const nonlinear::SteadyBranch& branch, const project::DisplayUnits& display);
/// Changes of stability, and the curves that begin there.
[[nodiscard]] std::string changes_text(const nonlinear::SteadyBranch& branch, const project::DisplayUnits& display);

}  // namespace trivet::results
