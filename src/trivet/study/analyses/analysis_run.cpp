// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/analyses/analysis_run.h"

namespace trivet::study {

const std::vector<AnalysisRun>& analysis_runs() {
#define TRIVET_RUN(name) project::named(#name, name##_run),
  static const std::vector<AnalysisRun> list = {TRIVET_ANALYSES(TRIVET_RUN)};
#undef TRIVET_RUN
  return list;
}

}  // namespace trivet::study
