// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/project/report_settings.h"
#include "trivet/study/whole_study.h"

namespace trivet::report {

struct WrittenStudy {
  std::vector<study::CaseResults> results;  ///< of every case
  study::Envelope envelope;                 ///< of the static results; without rows for a single case
  std::vector<std::string> notes;           ///< on what was in the folder before
};

/// Computes all analyses of a project in all its cases and writes tables, pictures, results.json and report.html. The
/// folder appears when it is complete (docs/decisions/result-folders.md).
[[nodiscard]] WrittenStudy write_study(const project::Project& project, const std::string& folder,
                                       project::ReportForm form, const foundation::Progress& progress = {});

}  // namespace trivet::report
