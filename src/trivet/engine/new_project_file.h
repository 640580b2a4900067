// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "trivet/engine/command.h"
#include "trivet/results/files/whole_file.h"

namespace trivet::engine {

/// The project file of the key `write`: the given one with other numbers.
class NewProjectFile {
 public:
  /// Checks the target before a search starts; does nothing without the key.
  /// @param trial  changes of the numbers that the search will set
  /// @throws foundation::InvalidInput if the file cannot be written there; problems of the numbers are in `problems`
  NewProjectFile(const Task& task, const std::vector<project::Node>& trial);

  [[nodiscard]] const foundation::Problems& problems() const { return problems_; }

  /// Writes the file; the line to show. @throws std::runtime_error with the reason; an earlier file stays unchanged
  [[nodiscard]] std::string write(const std::vector<project::Node>& changes, Result& result) const;

 private:
  [[nodiscard]] foundation::Expected<std::string> text(const std::vector<project::Node>& changes) const;

  const project::Project& project_;
  const std::vector<std::string>& settings_;
  std::string target_;
  foundation::Problems problems_;
  std::unique_ptr<results::WholeFile> file_;
};

}  // namespace trivet::engine
