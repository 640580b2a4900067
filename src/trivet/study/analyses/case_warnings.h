// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/study/analyses/case_context.h"

namespace trivet::study {

/// Warnings about answers of a case that a user may misread: frequency-dependent elements in undamped modes, forces
/// of constraints, loads without effect, massless springs above their own first natural frequency.
/// @param search_to  upper end of the searched band [rad/s]; 0: the highest natural frequency
[[nodiscard]] foundation::Problems case_warnings(const CaseContext& context, const project::Analyses& analyses,
                                                 double search_to);

/// Warnings about static results that are asked for or judged, of machines with laws: they use one stiffness for rest
/// and vibration, and leave out what the weight takes of the tilting stiffness of a body.
[[nodiscard]] foundation::Problems rest_warnings(const CaseContext& context, const project::Analyses& analyses);

}  // namespace trivet::study
