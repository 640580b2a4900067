// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "trivet/project/project.h"

/// The analyses of a file, in addition to its model: keys of `analyses`, and `limits`, `limit_lines`.
namespace trivet::project {

/// Analyses that must have no errors. An error in another analysis does not stop the command.
struct AnalysisFilter {
  std::optional<std::vector<std::string>> requested = {};  ///< none: all
  std::optional<std::string> of_case = {};  ///< only those of this case ("" the base model); none: of all
  std::string command = {};  ///< that computes one analysis, "modes" for example; empty: all are computed
  int lowest_modes = 0;      ///< of the command `modes`; 0: what the file says
};

/// True if errors of this analysis in this case concern the command.
[[nodiscard]] bool is_requested(const std::string& analysis, const AnalysisFilter& filter, const std::string& of_case);

/// True if the command does not compute this analysis itself, but judges requirements with its settings.
[[nodiscard]] bool is_only_setting(const std::string& analysis, const AnalysisFilter& filter,
                                   const std::string& of_case);

/// The part of the analyses of a file that a command for these analyses takes, where the size of a model depends on
/// it: `modes` takes only these, `response` only the response with its limits.
[[nodiscard]] Analyses counted_part(const AnalysisFilter& filter, const Analyses& analyses);

/// Reports analyses and requirements that do not suit the model. An analysis of which requirements only take the
/// settings is not judged: one that has no result has its reason beside all others.
/// @param system  a nonlinear one at rest
void check_analyses(const model::System& system, const Analyses& request, const AnalysisFilter& filter,
                    const std::string& of_case, foundation::Problems& problems);

/// Bands of the analyses of analysis_table.h that have one, by their names, in the order of the table.
[[nodiscard]] std::vector<std::pair<std::string, assembly::Band>> requested_bands(const Analyses& request);

/// True if the file requests a response or peaks that were removed from a case because of errors.
[[nodiscard]] bool has_broken_curves(const Case& variant);

/// Problems of the model and of the requested analyses. Removes analyses with errors that were not requested from
/// `analyses`.
[[nodiscard]] foundation::Problems without_unrequested(const foundation::Problems& found, const AnalysisFilter& filter,
                                                       const std::string& of_case, Analyses& analyses);

/// Warnings of excitations that no analysis of the file uses in any case. None if no analysis takes excitations (modes
/// only, for example), because then the commands add the analyses.
[[nodiscard]] foundation::Problems unused_parts(const std::vector<Case>& cases);

}  // namespace trivet::project
