// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/documents/document.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/study/explain/explanation.h"

namespace trivet::results {

/// For each explained peak its sentence, the shares of modes and elements, and the parameters that change it most;
/// "explain.csv" has one row per peak and parameter.
[[nodiscard]] Document explanation_document(const project::Case& variant, const study::Explanation& explanation);

}  // namespace trivet::results
