// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/foundation/problems.h"
#include "trivet/project/project.h"
#include "trivet/project/text/document.h"

namespace trivet::project {

/// One variant of a project before it is read: its document, with the changes of the case and of the command line.
struct WrittenCase {
  std::string name;
  Node document;
  std::vector<std::string> changes;  ///< "elements.suspension.scale = 1.5"
  foundation::Problems problems;     ///< of applying them
  bool is_readable = true;           ///< false for a case that is no table, and for too many cases: only `problems`
};

/// The text of a project with the settings of the command line, before its cases are read.
struct WrittenProject {
  Project project;  ///< without cases
  WrittenCase base;
  std::vector<WrittenCase> cases;    ///< the others
  foundation::Problems problems;     ///< of text and settings
  foundation::Problems of_settings;  ///< those of them that each case has, too
  foundation::Problems over_cases;   ///< warnings of settings that replace a change of a case
};

/// @param folder  to which names of files are relative; empty: that of `source`
[[nodiscard]] foundation::Expected<WrittenProject> written_project(const std::string& text, const std::string& source,
                                                                   const std::vector<std::string>& settings,
                                                                   const std::string& folder = "");

/// The text of an earlier project with other settings; it is not parsed again.
[[nodiscard]] WrittenProject written_project(const Project& earlier, const std::vector<std::string>& settings);

}  // namespace trivet::project
