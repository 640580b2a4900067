// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "trivet/foundation/problems.h"
#include "trivet/model/system.h"
#include "trivet/project/analyses/analyses.h"
#include "trivet/project/text/document.h"
#include "trivet/project/text/shown_units.h"

namespace trivet::project {

/// One variant of the model: the base ("" as its name) or a case.
struct Case {
  std::string name;
  std::vector<std::string> changes;  ///< "elements.suspension.scale = 1.5"
  model::System system;
  Analyses analyses;
  foundation::Problems warnings;  ///< of reading and checking, with their places
  Node written;                   ///< the file with the changes applied
  Node document;                  ///< `written` with the element types merged in: the input of the model
  ShownUnits display;             ///< of its tables and pictures
};

/// A project file that passed every check, in all its cases.
struct Project {
  std::string title;
  std::string source;                 ///< file name as given
  std::string folder;                 ///< to which names of files are relative; empty: that of `source`
  std::string sha256;                 ///< of the text of the file and of the settings
  std::vector<Case> cases;            ///< the base model first
  foundation::Problems unused_parts;  ///< those warnings of the base model that are about the analyses of the file

  [[nodiscard]] const Case& base() const { return cases.front(); }
  [[nodiscard]] const Case* find(const std::string& name) const;
};

/// The folder to which names of files in the project are relative.
[[nodiscard]] std::filesystem::path folder_of_files(const Project& project);

/// Reads and checks a project file with the given `--set` changes; all problems of all cases at once.
[[nodiscard]] foundation::Expected<Project> read_project(const std::filesystem::path& path,
                                                         const std::vector<std::string>& settings = {});

/// As `read_project`, from text. @param folder  to which names of files are relative; empty: that of `source`
[[nodiscard]] foundation::Expected<Project> project_from_text(const std::string& text, const std::string& source,
                                                              const std::vector<std::string>& settings = {},
                                                              const std::string& folder = "");

}  // namespace trivet::project
