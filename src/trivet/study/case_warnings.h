// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/study/case_context.h"

namespace trivet::study {

/// Warnings about answers of a case that a user may misread: frequency-dependent elements in undamped modes, forces
/// of constraints, loads without effect, massless springs above their own first natural frequency.
/// @param search_to  upper end of the searched band [rad/s]; 0: the highest natural frequency
[[nodiscard]] foundation::Problems case_warnings(const CaseContext& context, const project::Analyses& analyses,
                                                 double search_to);

/// A warning for each body of which the weight takes much of the tilting stiffness, if static results are asked for or
/// judged: these are of the first order and leave it out.
[[nodiscard]] foundation::Problems tilting_at_rest_warnings(const CaseContext& context,
                                                            const project::Analyses& analyses);

}  // namespace trivet::study
