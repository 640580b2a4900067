// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "trivet/study/analyses/case_results.h"
#include "trivet/study/sample/sample.h"

namespace trivet::study {

/// Computes all analyses of a project in all its cases; maps of the base model and of cases with a map of their own.
/// @param progress  "CASE: task" and the share of the whole
/// @param done  receives each case when it is complete
[[nodiscard]] std::vector<CaseResults> run(const project::Project& project, const foundation::Progress& progress = {},
                                           const std::function<void(std::size_t index, const CaseResults&)>& done = {});

/// The designs within the tolerances as a run judges them: the first ones, if all would take more than some seconds.
/// @param shares  also those of the variance
/// @throws as `sample`
[[nodiscard]] Sample sample_in_a_run(const project::Project& project, bool shares,
                                     const foundation::Progress& progress = {});

/// The envelope of the static results of a run over all its cases.
[[nodiscard]] Envelope envelope_of(const std::vector<CaseResults>& results);

/// One check that the data passed or failed, as text.
struct CheckLine {
  std::string subject;
  std::string what;
  std::string value;
  bool passed = true;
  bool operator==(const CheckLine&) const = default;
};

/// Checks of every body and element of a case, with their values.
[[nodiscard]] std::vector<CheckLine> check_lines(const project::Case& variant);

/// Checks of a case without its analyses.
struct CaseCheck {
  std::string case_name;
  project::DisplayUnits display;  ///< of its tables
  foundation::Problems warnings;  ///< of the data, the modes and the roots
  std::vector<CheckLine> lines;   ///< for cases other than the base model: only those that differ from it
  std::vector<MountAtRest>
      mounts;  ///< empty without a static result; for other cases only if they differ from the base
  std::vector<std::string> free_motions;
  std::vector<std::string> notes;  ///< left-out directions of nodes; for the base model: bodies that gravity tilts
  std::optional<response::DeepCheck> deep;  ///< comparison of two solvers, if requested
};

/// Mounts at rest, if they can be computed in no time; else none.
[[nodiscard]] std::vector<MountAtRest> quick_mounts(const model::System& system, const assembly::Assembled& assembled);

/// Checks of all cases of a project. @param deep  compare the solver with a second, independent one
[[nodiscard]] std::vector<CaseCheck> check(const project::Project& project, bool deep = false);

}  // namespace trivet::study
