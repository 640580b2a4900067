// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "trivet/foundation/problems.h"
#include "trivet/project/analysis_filter.h"
#include "trivet/project/project.h"

/// Opens a project: reads its file, puts nonlinear machines into their positions of rest and judges all cases.
namespace trivet::judging {

/// Reads and checks a project file with the given `--set` changes; all problems of all cases at once.
[[nodiscard]] foundation::Expected<project::Project> read_project(const std::filesystem::path& path,
                                                                  const std::vector<std::string>& settings = {});

/// As `read_project`, from text. @param folder  to which names of files are relative; empty: that of `source`
[[nodiscard]] foundation::Expected<project::Project> project_from_text(const std::string& text,
                                                                       const std::string& source,
                                                                       const std::vector<std::string>& settings = {},
                                                                       const std::string& folder = "");

/// As `project_from_text`, but analyses with errors that were not requested are removed from the analyses of their
/// case.
[[nodiscard]] foundation::Expected<project::Project> project_from_text_for(const project::AnalysisFilter& filter,
                                                                           const std::string& text,
                                                                           const std::string& source,
                                                                           const std::vector<std::string>& settings,
                                                                           const std::string& folder);

/// The project that its text gives with these settings instead of its own: the same cases, problems and places as
/// `project_from_text`. Bodies and elements that stay the same are not read again, nor are the files that they name.
/// @param settings  all of them, as `path = value`; a later one of the same number is an error
[[nodiscard]] foundation::Expected<project::Project> changed_project(const project::Project& project,
                                                                     const std::vector<std::string>& settings);

}  // namespace trivet::judging
