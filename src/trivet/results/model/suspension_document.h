// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/documents/document.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/study/explain/suspension.h"

namespace trivet::results {

/// Elastic centre, roll axes and decoupling of every body, and the separation of the natural frequencies
/// (docs/json.md). "suspension.csv" has one row per body and mode.
[[nodiscard]] Document suspension_document(const project::Case& variant, const study::SuspensionResult& found);

}  // namespace trivet::results
