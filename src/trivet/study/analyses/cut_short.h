// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/study/analyses/answers.h"

namespace trivet::study {

/// Does a connected curve of motions, or a nonlinear mode, end before the end that was asked for? Its warning states
/// where and why.
[[nodiscard]] bool is_cut_short(const Answers& answers);

}  // namespace trivet::study
