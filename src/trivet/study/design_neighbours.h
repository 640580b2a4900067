// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "trivet/assembly/assembled.h"
#include "trivet/study/case_context.h"
#include "trivet/study/design_space.h"
#include "trivet/study/verdict.h"

namespace trivet::study {

/// Models next to a design, for the derivatives of its margins with respect to the parameters.
///
/// What is differenced is the assembled model, A, B, K, loads and rows of results, by five-point formulas inside the
/// range: exact for polynomials of the fourth degree, which factors, masses and places are. From there on derivatives
/// are exact: at fixed ω, y = cᵀq with Zq = h gives dy = λᵀ(dh − dZ q) + dcᵀq with Zᵀλ = c, and at a maximum its shift
/// does not count; dω_k² = φᵀ(dK − ω_k² dA)φ / φᵀAφ of a simple mode.
class DesignNeighbours {
 public:
  /// @param values  of the design
  /// @throws foundation::NotComputable if there is no valid model on any side of it
  DesignNeighbours(const DesignSpace& space, const project::Case& variant, const Eigen::VectorXd& values);

  struct Neighbour {
    double weight = 0;  ///< of the difference formula [1/unit of the parameter]
    std::unique_ptr<model::System> system;
    assembly::Assembled assembled;
  };
  /// Per parameter.
  [[nodiscard]] const std::vector<std::vector<Neighbour>>& all() const { return all_; }

  /// d ln(margin) of candidates of a requirement per parameter, in the unit of its axis: candidates × parameters.
  [[nodiscard]] Eigen::MatrixXd slopes(const CaseContext& context, const RequirementResult& result,
                                       const std::vector<RequirementResult::Candidate>& candidates) const;

 private:
  /// d ln|y| at fixed frequencies [rad/s]: frequencies × parameters.
  [[nodiscard]] Eigen::MatrixXd height_slopes(const CaseContext& context, const RequirementResult& result,
                                              const std::vector<double>& frequencies) const;
  [[nodiscard]] Eigen::RowVectorXd frequency_slopes(const CaseContext& context, int mode) const;

  std::vector<std::vector<Neighbour>> all_;
};

}  // namespace trivet::study
