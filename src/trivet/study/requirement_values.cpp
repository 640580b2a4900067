// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/requirement_values.h"

#include "trivet/study/clearance_results.h"
#include "trivet/study/curve_requirements.h"
#include "trivet/study/frequency_requirements.h"
#include "trivet/study/isolation_requirements.h"
#include "trivet/study/motion_requirements.h"
#include "trivet/study/mount_requirements.h"
#include "trivet/study/mount_sums.h"
#include "trivet/study/requirement_list.h"
#include "trivet/study/steady_requirements.h"

namespace trivet::study {

std::vector<RequirementResult> requirement_values(const CaseContext& context, const project::Analyses& analyses,
                                                  foundation::Problems& warnings) {
  const project::Requirements none;
  const project::Requirements& required = analyses.requirements ? *analyses.requirements : none;
  RequirementList list;
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
