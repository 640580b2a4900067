// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>

#include "trivet/documents/document.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/study/explain/explanation.h"

namespace trivet::results {

/// For each explained peak its sentence, the shares of modes and elements, and the parameters that change it most;
/// "explain.csv" has one row per peak and parameter.
/// @param with_tables  number of peaks with tables; of the others people get the sentence alone
[[nodiscard]] Document explanation_document(const project::Case& variant, const study::Explanation& explanation,
                                            std::size_t with_tables = std::numeric_limits<std::size_t>::max());

}  // namespace trivet::results
