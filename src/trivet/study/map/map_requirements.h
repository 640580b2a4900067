// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/design/design_outcome.h"
#include "trivet/project/project.h"
#include "trivet/study/requirements/verdict.h"

namespace trivet::study {

/// The requirements of a map that its fast rules do not cover, in one case.
class MapRequirements {
 public:
  /// @param by_matrices  natural frequencies are judged for many designs at once
  MapRequirements(const project::Case& variant, const project::MapRequest& request, bool by_matrices);

  /// Requirements of a map on natural frequencies, for one model.
  [[nodiscard]] static std::vector<RequirementResult> frequencies(const project::MapRequest& request,
                                                                  const model::System& system);

  [[nodiscard]] bool is_empty() const { return rules_.empty(); }
  /// Those of natural frequencies that are judged for many designs at once come last.
  [[nodiscard]] const std::vector<design::MapRule>& rules() const { return rules_; }
  /// Rules from here on are judged by DesignEvaluation::frequency_margins.
  [[nodiscard]] std::size_t first_by_matrices() const { return first_by_matrices_; }

  /// All of them for one model, in the order of the rules. @throws foundation::NotComputable, InvalidInput
  [[nodiscard]] std::vector<RequirementResult> results(const model::System& system) const;

  /// The same without those of natural frequencies for many designs at once.
  [[nodiscard]] std::vector<RequirementResult> separate_results(const model::System& system) const;

  /// Only those of natural frequencies for many designs at once, for one model.
  [[nodiscard]] std::vector<RequirementResult> frequency_results(const model::System& system) const;

  /// What the judgement of the model itself warns of.
  [[nodiscard]] const foundation::Problems& warnings() const { return warnings_; }

 private:
  void add_rules(const std::vector<RequirementResult>& results);

  project::Analyses separate_;         // judged design by design
  project::Requirements frequencies_;  // for many designs at once
  std::vector<design::MapRule> rules_;
  std::size_t first_by_matrices_ = 0;
  foundation::Problems warnings_;
};

}  // namespace trivet::study
