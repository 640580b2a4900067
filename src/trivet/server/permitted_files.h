// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "trivet/foundation/problems.h"
#include "trivet/project/unopened_text.h"

namespace trivet::server {

/// Which files a text from the page may name: those in the folder of the project, hidden ones excepted, and those that
/// the file on disk names. Links are resolved first.
class PermittedFiles {
 public:
  /// A page without a project: no file at all.
  PermittedFiles() = default;
  /// @param text  of the project file on disk
  PermittedFiles(const std::string& project_file, const std::string& text);

  /// Problems of every other name in the text, at its place. None of these files is read.
  [[nodiscard]] foundation::Problems refused_in_text(const std::string& text, const std::string& source) const;
  [[nodiscard]] foundation::Problems refused_in_settings(const std::vector<std::string>& settings) const;

  [[nodiscard]] bool permits(const std::filesystem::path& file) const;

 private:
  [[nodiscard]] foundation::Problems refused(const std::vector<project::FileName>& names) const;

  std::filesystem::path given_folder_, folder_;  ///< as given, and without links; empty: none
  std::set<std::filesystem::path> named_;
};

}  // namespace trivet::server
