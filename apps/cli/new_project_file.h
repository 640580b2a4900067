// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "cli/commands.h"
#include "trivet/results/whole_file.h"

namespace trivet::cli {

/// The project file that --write asks for: the given one with other numbers.
class NewProjectFile {
 public:
  /// Checks the target before a search starts; does nothing without --write.
  /// @param trial  changes of the numbers that the search will set
  /// @throws BadArgument if the file cannot be written there; problems of the numbers are in `problems`
  NewProjectFile(const Options& options, const project::Project& project, const std::vector<project::Node>& trial);

  [[nodiscard]] const foundation::Problems& problems() const { return problems_; }

  /// Writes the file; the line to show. @throws std::runtime_error with the reason; an earlier file stays unchanged
  [[nodiscard]] std::string write(const std::vector<project::Node>& changes) const;

 private:
  [[nodiscard]] foundation::Expected<std::string> text(const std::vector<project::Node>& changes) const;

  const Options& options_;
  const project::Project& project_;
  foundation::Problems problems_;
  std::unique_ptr<results::WholeFile> file_;
};

}  // namespace trivet::cli
