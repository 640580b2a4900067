// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/study/analyses/case_context.h"
#include "trivet/study/requirements/requirement_list.h"

namespace trivet::study {

/// Adds what limits curves over frequency, with values and margins: [limits], limits, no_peak, limit lines.
void add_curve_requirements(const CaseContext& context, const project::Analyses& analyses, RequirementList& list);

/// Sets the largest amplitudes over the band of the requirements, from result `first` of the list on.
void set_amplitudes(const CaseContext& context, const project::Analyses& analyses, std::size_t first,
                    const std::vector<project::AmplitudeLimit>& limits, RequirementList& list);

}  // namespace trivet::study
