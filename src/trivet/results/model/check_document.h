// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/documents/document.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/study/whole_study.h"

namespace trivet::results {

/// For people: the checks of each case, the mounts at rest, notes, and the comparison of two solvers.
/// @param with_passed  each check that passed, too, not only their number
[[nodiscard]] Document check_document(const std::vector<study::CaseCheck>& cases, bool with_passed);

}  // namespace trivet::results
