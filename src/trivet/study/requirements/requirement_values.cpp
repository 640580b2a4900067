// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/requirements/requirement_values.h"

#include "trivet/study/requirements/mount_loads.h"
#include "trivet/study/requirements/requirement_list.h"

namespace trivet::study {

std::vector<RequirementResult> requirement_values(const CaseContext& context, const project::Analyses& analyses,
                                                  foundation::Problems& warnings) {
  const project::Requirements none;
  const project::Requirements& required = analyses.requirements ? *analyses.requirements : none;
  RequirementList list;
  add_operation_requirements(context, analyses, list);
  add_operating_line_requirements(context, analyses, list);
  add_curve_requirements(context, analyses, list);
  add_frequency_requirements(context, required, list);
  add_isolation_requirements(context, required, list);
  add_motion_requirements(context, analyses, warnings, list);
  add_steady_requirements(context, analyses, list);
  if (required.mount_load) add_mount_requirements(context, analyses, warnings, list);
  list.append(mount_sums(context.system, required));
  list.append(clearance_results(context, analyses, warnings));
  return list.release();
}

}  // namespace trivet::study
