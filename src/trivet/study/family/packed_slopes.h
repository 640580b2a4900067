// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <complex>

#include "trivet/study/family/case_vector.h"

namespace trivet::study {

/// Exact derivatives of the margins of a design in a family of packed designs: those of the list with respect to the
/// parameters are given, and the rest is linear algebra of n coordinates. At fixed ω, y = cᵀq with Zq = h gives
/// dy = λᵀ(dh − dZ q) + dcᵀq with Zλ = c (Z is symmetric), and at a maximum its shift does not count;
/// dω_k² = φᵀ(dK − ω_k² dA)φ with φᵀAφ = 1; mode shapes move by the other modes.
class PackedSlopes {
 public:
  /// @param entries  of the design  @param slopes  entries × parameters
  PackedSlopes(const CaseVector& of, const Eigen::VectorXd& entries, const Eigen::MatrixXd& slopes);

  /// d ln(margin) of candidates of a covered requirement: candidates × parameters.
  [[nodiscard]] Eigen::MatrixXd slopes(std::size_t result, const RequirementResult& found,
                                       const std::vector<RequirementResult::Candidate>& candidates) const;
  /// d ln ζ of a simple oscillating root λ, ζ = −Re λ/|λ|: dλ = −vᵀ dZ(λ) v / vᵀ (2λA + B) v with Zv = 0.
  [[nodiscard]] Eigen::RowVectorXd damping_ratio_slopes(std::complex<double> root) const;

 private:
  [[nodiscard]] Eigen::MatrixXd height_slopes(std::size_t result, const std::vector<double>& frequencies) const;
  /// A frequency that stands for 0, where a response to unbalance has no height [rad/s].
  [[nodiscard]] double almost_at_rest() const;
  [[nodiscard]] Eigen::RowVectorXd frequency_slopes(int mode) const;
  [[nodiscard]] Eigen::RowVectorXd rest_slopes(std::size_t result) const;
  [[nodiscard]] Eigen::RowVectorXd decoupling_slopes(std::size_t result, int mode) const;
  struct Modes {
    Eigen::VectorXd squares;  ///< ω²
    Eigen::MatrixXd shapes;
    std::vector<Eigen::MatrixXd> inertia, stiffness;  ///< φᵀ dA φ and φᵀ dK φ, per parameter
  };
  [[nodiscard]] Modes modes(const numerics::Designs& here, const numerics::Designs& change) const;

  const CaseVector& of_;
  CaseVector::Unpacked here_, change_;  ///< one design; one per parameter
  numerics::Designs here_free_, change_free_;
  Eigen::Index parameters_ = 0;
  mutable std::optional<Modes> all_;                        ///< of the whole system, when first needed
  mutable std::vector<std::optional<Modes>> of_decoupled_;  ///< of single bodies
};

}  // namespace trivet::study
