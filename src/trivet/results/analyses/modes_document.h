// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/documents/document.h"
#include "trivet/study/analyses/case_results.h"

namespace trivet::results {

/// Undamped modes. @param shapes_of  for programs, the shape, screws and elements of the mode of this number alone; 0:
/// of all modes
[[nodiscard]] Document modes_document(const project::Case& variant, const study::CaseResults& results, int shapes_of);

}  // namespace trivet::results
