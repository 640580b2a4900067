// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "trivet/study/analyses/case_context.h"
#include "trivet/study/family/design_neighbours.h"
#include "trivet/study/family/frequency_slopes.h"
#include "trivet/study/requirements/verdict.h"

namespace trivet::study {

/// Exact derivatives of ln(margin) with respect to the parameters, per unit of their axes. The models next to the
/// design are assembled, but only the design itself is solved: a gradient costs at most five solutions, whatever the
/// number of parameters. Formulas: docs/design.md.
class RequirementSlopes {
 public:
  RequirementSlopes(const CaseContext& context, const DesignNeighbours& neighbours);

  /// Candidates × parameters; 0 for a candidate without a slope, such as a defective pair of roots.
  [[nodiscard]] Eigen::MatrixXd of(const RequirementResult& result,
                                   const std::vector<RequirementResult::Candidate>& candidates) const;

  /// True if a requirement of this kind has none in a system: its values are differenced.
  [[nodiscard]] static bool are_missing(RequirementKind kind, const model::System& system);

 private:
  [[nodiscard]] Eigen::MatrixXd of_curve(const RequirementResult& result,
                                         const std::vector<RequirementResult::Candidate>& candidates) const;
  [[nodiscard]] Eigen::MatrixXd of_decoupling(const RequirementResult& result,
                                              const std::vector<RequirementResult::Candidate>& candidates) const;
  [[nodiscard]] Eigen::RowVectorXd of_one(const RequirementResult& result,
                                          const RequirementResult::Candidate& candidate) const;
  [[nodiscard]] Eigen::RowVectorXd of_mount(const RequirementResult& result) const;
  [[nodiscard]] Eigen::RowVectorXd of_rms(const RequirementResult& result) const;
  [[nodiscard]] const FrequencySlopes& frequencies() const;

  const CaseContext& c_;
  const DesignNeighbours& neighbours_;
  mutable std::unique_ptr<const FrequencySlopes> frequencies_;  ///< when they are first needed
};

}  // namespace trivet::study
