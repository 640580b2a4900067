// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "trivet/documents/labelled_arrays.h"
#include "trivet/foundation/interruption.h"
#include "trivet/project/project.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/study/analyses/case_results.h"

namespace trivet::exports {

/// Arrays that belong together: "matrices", or the result of an analysis.
struct Group {
  std::string name;
  results::LabelledArrays arrays;
  std::shared_ptr<const study::CaseResults> results;  ///< empty for the matrices
  std::shared_ptr<const void> held;                   ///< what the arrays refer to
};

/// What files of other programs are written from: one case with its matrices and results. The project must outlive it.
struct Content {
  const project::Project& project;
  const project::Case& variant;
  std::vector<Group> groups;
  std::vector<std::string> notes;  ///< what the data do not say exactly

  [[nodiscard]] const Group* find(const std::string& name) const;
  /// "machine.toml, case soft": for headers.
  [[nodiscard]] std::string words() const;
};

/// @throws foundation::InvalidInput for a name that is neither "matrices" nor an analysis
void require_known(const std::vector<std::string>& what);

/// Computes the groups.
/// @param what        "matrices" and names of analyses
/// @param format_groups  what the format can hold; empty: anything. If `what` is empty, these or the matrices, the
/// modes
///   and every analysis of the file; one that does not suit the model, or that cannot be computed, is left out with a
///   note, unless nothing is left.
/// @throws foundation::InvalidInput if `what` names an analysis without its excitation, NotComputable if a result that
/// `what` names does not exist
[[nodiscard]] Content content(const project::Project& project, const project::Case& variant,
                              const std::vector<std::string>& what, const std::vector<std::string>& format_groups,
                              const foundation::Progress& progress = {});

}  // namespace trivet::exports
