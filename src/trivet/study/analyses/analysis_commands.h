// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "trivet/project/project.h"

namespace trivet::study {

/// An analysis that a command can request separately.
struct AnalysisCommand {
  const char* name;   ///< name of its table in [analyses]; `limit_lines` and `measurements` have tables of their own
  const char* about;  ///< one line of help
  std::vector<std::string> looks_at;  ///< tables of the file; errors in them stop the analysis
  /// The request: that of the file, otherwise one with defaults. @throws foundation::InvalidInput if the file must
  /// specify more, with what to add
  std::function<project::Analyses(const project::Case& variant)> request;
};

[[nodiscard]] const std::vector<AnalysisCommand>& analysis_commands();

/// The analysis of this name. @throws foundation::InvalidInput if there is none
[[nodiscard]] const AnalysisCommand& analysis_command(const std::string& name);

}  // namespace trivet::study
