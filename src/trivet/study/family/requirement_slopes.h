// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "trivet/study/family/design_neighbours.h"
#include "trivet/study/family/frequency_slopes.h"
#include "trivet/study/family/packed_rates.h"
#include "trivet/study/family/slopes.h"
#include "trivet/study/requirements/verdict.h"

namespace trivet::study {

/// Exact derivatives of ln(margin) with respect to the parameters, per unit of their axes. Only the design itself is
/// solved: a gradient costs at most five solutions, whatever the number of parameters. How its equations change follows
/// from the numbers of a batch, for requirements that it has no numbers of from models next to the design, which are
/// then assembled. Formulas: docs/design.md.
class RequirementSlopes {
 public:
  /// @param context  of the design  @param values  of its parameters  @param batch  of the case; nullptr: models alone
  RequirementSlopes(const CaseContext& context, const DesignSpace& space, const project::Case& variant,
                    const Eigen::VectorXd& values, const DesignBatch* batch = nullptr);

  /// Candidates × parameters; 0 for a candidate without a slope, such as a defective pair of roots.
  /// @param number  of the requirement among those of the batch
  [[nodiscard]] Eigen::MatrixXd of(std::size_t number, const RequirementResult& result,
                                   const std::vector<RequirementResult::Candidate>& candidates) const;

  /// True if a requirement of this kind has none in a system: its values are differenced.
  [[nodiscard]] static bool are_missing(RequirementKind kind, const model::System& system);

  /// The models next to the design. @throws foundation::NotComputable if there are none
  [[nodiscard]] const DesignNeighbours& neighbours() const;

 private:
  using Candidates = std::vector<RequirementResult::Candidate>;
  /// What the batch gives for a requirement; nullptr: models do.
  [[nodiscard]] const PackedRates* packed(std::size_t number) const;
  [[nodiscard]] Eigen::MatrixXd of_curve(std::size_t number, const RequirementResult& result,
                                         const Candidates& candidates) const;
  [[nodiscard]] Eigen::MatrixXd heights(std::size_t number, const RequirementResult& result,
                                        const std::vector<double>& frequencies) const;
  [[nodiscard]] Eigen::MatrixXd of_decoupling(std::size_t number, const RequirementResult& result,
                                              const Candidates& candidates) const;
  [[nodiscard]] Eigen::RowVectorXd of_one(std::size_t number, const RequirementResult& result,
                                          const RequirementResult::Candidate& candidate) const;
  [[nodiscard]] Eigen::RowVectorXd of_root(std::size_t number, std::size_t root) const;
  [[nodiscard]] Eigen::RowVectorXd of_rest(std::size_t number, const RequirementResult& result) const;
  [[nodiscard]] Eigen::RowVectorXd of_rms(const RequirementResult& result) const;
  [[nodiscard]] const FrequencySlopes& frequencies(std::size_t number) const;

  const CaseContext& c_;
  const DesignSpace& space_;
  const project::Case& case_;
  const Eigen::VectorXd values_, towards_;
  const DesignBatch* batch_;
  // When they are first needed:
  mutable std::optional<PackedRates> packed_;
  mutable std::unique_ptr<const DesignNeighbours> neighbours_;
  mutable std::unique_ptr<const FrequencySlopes> frequencies_;
};

}  // namespace trivet::study
