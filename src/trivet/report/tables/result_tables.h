// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/documents/html_table.h"
#include "trivet/report/drawing/in_documents.h"
#include "trivet/study/analyses/case_results.h"

/// Tables of the results to constant and harmonic excitations as HTML; empty if the case did
/// not request them.
namespace trivet::report {

/// "✓ met", "✗ VIOLATED" or "? NOT JUDGED", and the style of its row.
[[nodiscard]] Cell requirement_cell(const study::RequirementResult& result);
[[nodiscard]] const char* requirement_style(const study::RequirementResult& result);

}  // namespace trivet::report
