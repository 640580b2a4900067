// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/documents/document.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/study/analyses/case_results.h"

namespace trivet::results {

/// Characteristics as rational models with their exact extrema, natural frequencies and limits: docs/json.md, "curves".
/// @param results  with a modelled response and peaks of the same curves, see study::curve_results
[[nodiscard]] Document curves_document(const project::Case& variant, const study::CaseResults& results);

}  // namespace trivet::results
