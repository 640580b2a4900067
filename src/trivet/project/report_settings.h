// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "trivet/project/project.h"
#include "trivet/project/text/table_reader.h"

namespace trivet::project {

/// How much a report contains: everything, or only verdict, requirements, machine, mounts, modes and main curves.
enum class ReportForm { full, brief };

/// The title block and the form of a report; a text that the file does not give is empty.
struct ReportSettings {
  std::string project, client, machine, revision, author;
  std::string date;  ///< as written; empty: the day of the run
  ReportForm form = ReportForm::full;
};

/// Reads [report].
[[nodiscard]] ReportSettings read_report(TableReader& root);

/// [report] of a project, whose cases cannot change it.
[[nodiscard]] ReportSettings report_settings(const Project& project);

}  // namespace trivet::project
