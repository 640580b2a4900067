// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "trivet/foundation/problems.h"
#include "trivet/model/system.h"
#include "trivet/project/analyses/analyses.h"
#include "trivet/project/text/display_units.h"
#include "trivet/project/text/document.h"

namespace trivet::project {

/// One variant of the model: the base ("" as its name) or a case, as the layer judging completes it.
struct Case {
  std::string name;
  std::vector<std::string> changes;  ///< "elements.suspension.scale = 1.5"
  model::System system;              ///< a nonlinear machine is in its position of rest
  Analyses analyses;
  foundation::Problems warnings;  ///< of reading and checking, with their places
  Node written;                   ///< the file with the changes applied
  Node document;                  ///< `written` with the element types merged in: the input of the model
  DisplayUnits display;           ///< of its tables and pictures
  foundation::Problems of_text;   ///< warnings of reading alone
};

/// The text of a project file, parsed, before settings and cases.
struct ParsedText {
  std::string text;
  Node document;                  ///< with its tables in place
  foundation::Problems problems;  ///< of these tables
};

/// A project file that passed every check, in all its cases.
struct Project {
  std::string title;
  std::string source;                 ///< file name as given
  std::string folder;                 ///< to which names of files are relative; empty: that of `source`
  std::string sha256;                 ///< of the text of the file and of the settings
  std::vector<Case> cases;            ///< the base model first
  foundation::Problems unused_parts;  ///< those warnings of the base model that are about the analyses of the file
  std::vector<std::string> settings;  ///< with which it was read
  std::shared_ptr<const ParsedText> parsed;

  [[nodiscard]] const Case& base() const { return cases.front(); }
  [[nodiscard]] const Case* find(const std::string& name) const;
};

/// The folder to which names of files in the project are relative.
[[nodiscard]] std::filesystem::path folder_of_files(const Project& project);

}  // namespace trivet::project
