// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/report/html_table.h"
#include "trivet/study/answers.h"

/// Tables of the modes, the roots and the answers to constant and harmonic excitations as HTML; empty if the case did
/// not request them.
namespace trivet::report {

/// Undamped modes with their energies, and their shapes.
[[nodiscard]] std::string modes_tables(const project::Case& variant, const study::Answers& answers);

[[nodiscard]] std::string roots_table(const project::Case& variant, const study::Answers& answers);

/// Resonance peaks, and the curves without one.
[[nodiscard]] std::string peaks_table(const project::Case& variant, const study::Answers& answers);

/// "✓ met", "✗ VIOLATED" or "? NOT JUDGED", and the style of its row.
[[nodiscard]] Cell requirement_cell(const study::RequirementResult& result);
[[nodiscard]] const char* requirement_style(const study::RequirementResult& result);

/// Every requirement with its margin, the least first.
[[nodiscard]] std::string requirements_table(const study::Answers& answers);

/// Least and largest static values over all cases.
[[nodiscard]] std::string envelope_table(const study::Envelope& envelope);

[[nodiscard]] std::string limits_table(const project::Case& variant, const study::Answers& answers);

/// A response at a few given frequencies; empty for longer ones, which are only drawn.
[[nodiscard]] std::string response_table(const project::Case& variant, const study::Answers& answers);

/// Static motions and forces, one row for each place.
[[nodiscard]] std::string static_tables(const project::Case& variant, const study::Answers& answers);

}  // namespace trivet::report
