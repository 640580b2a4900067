// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/design/design_evaluation.h"
#include "trivet/project/project.h"
#include "trivet/study/requirements/verdict.h"

namespace trivet::study {

/// The requirements of a map that its fast rules do not cover, in one case.
class MapRequirements {
 public:
  /// @param by_matrices  natural frequencies come from interpolated matrices, see `frequency_margins`
  MapRequirements(const project::Case& variant, const project::MapRequest& request, bool by_matrices);

  [[nodiscard]] bool is_empty() const { return rules_.empty(); }
  /// Those of natural frequencies by interpolated matrices come last.
  [[nodiscard]] const std::vector<design::MapRule>& rules() const { return rules_; }
  /// Rules from here on are judged by `frequency_margins`.
  [[nodiscard]] std::size_t first_by_matrices() const { return first_by_matrices_; }

  /// All of them for one model, in the order of the rules. @throws foundation::NotComputable, InvalidInput
  [[nodiscard]] std::vector<RequirementResult> results(const model::System& system) const;

  /// The same without those of natural frequencies by interpolated matrices.
  [[nodiscard]] std::vector<RequirementResult> separate_results(const model::System& system) const;

  /// Only those of natural frequencies by interpolated matrices, for one model.
  [[nodiscard]] std::vector<RequirementResult> frequency_results(const model::System& system) const;

  /// Margins of the rules on natural frequencies; none if a motion may be free, which `frequency_results` decides.
  /// @param squared_frequencies  ω² of one design, ascending
  [[nodiscard]] std::optional<std::vector<double>> frequency_margins(const Eigen::ArrayXd& squared_frequencies) const;

  /// What the judgement of the model itself warns of.
  [[nodiscard]] const foundation::Problems& warnings() const { return warnings_; }

 private:
  void add_rules(const std::vector<RequirementResult>& results);

  project::Analyses separate_;         // judged design by design
  project::Requirements frequencies_;  // by interpolated matrices
  std::vector<design::MapRule> rules_;
  std::size_t first_by_matrices_ = 0;
  foundation::Problems warnings_;
};

}  // namespace trivet::study
