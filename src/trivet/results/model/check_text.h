// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/study/whole_study.h"

namespace trivet::results {

/// The checks of one case, the mounts at rest, notes, and the comparison of two solvers.
[[nodiscard]] std::string case_check_text(const study::CaseCheck& found);

}  // namespace trivet::results
