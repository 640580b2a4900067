// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/foundation/problems.h"
#include "trivet/project/project.h"

namespace trivet::study {

/// A case that sets a number which a command moves: every design of the command would undo the case.
struct OverruledCase {
  std::string finding;  ///< which case sets which number
  std::string remedy;

  /// For an error. @param command  that moves the number
  [[nodiscard]] std::string refusal(const std::string& command) const;
};

/// The numbers of these axes that a case sets to another value than the base model.
[[nodiscard]] std::vector<OverruledCase> overruled_in(const project::Case& variant, const project::Case& base,
                                                      const std::vector<project::DesignAxis>& axes);

/// Warnings that `optimize` and `map` of the file will refuse a case in which the design has to hold, because they
/// would undo it.
[[nodiscard]] foundation::Problems overruled_by_search(const project::Project& project);
[[nodiscard]] foundation::Problems overruled_by_map(const project::Project& project);

}  // namespace trivet::study
