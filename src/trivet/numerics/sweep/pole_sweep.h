// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "trivet/numerics/linalg/dynamic_matrices.h"

namespace trivet::numerics {

/// q(iω) of one system under a constant load from its poles: Σ over pairs (c0 + iω c1)/((ω_k² − ω²) − 2iωσ_k). Each ω_k
/// is two numbers, the differences of frequencies so formed are exact where it counts, and Re λ has all its digits:
/// near a lightly damped resonance this is several digits better than any solution of Z(ω) q = h can be, in half the
/// time of the quickest (benchmarks/README.md).
class PoleSweep {
 public:
  /// Nothing unless A is positive definite, K too, all is symmetric without loss factor, n ≤ 12, and poles and residues
  /// have been proven: each pole found once, none near another one with which it merges (|2λ| |v|²/|vᵀ(2λ + B̃)v| ≤ 1e4;
  /// 1 where modes are apart), and at every pole's own frequency and between them a backward error ≤ 3e-15.
  [[nodiscard]] static std::optional<PoleSweep> of(const DynamicMatrices& matrices, const Eigen::VectorXcd& load);

  /// q at these ω, count × n by real and imaginary parts, which the caller keeps from sweep to sweep. One in 64
  /// frequencies is put into Z q = h; false if a backward error exceeds 1e-14: then all of it must be solved directly.
  [[nodiscard]] bool response(const Eigen::Ref<const Eigen::ArrayXd>& omega, Eigen::Ref<Eigen::ArrayXXd> re,
                              Eigen::Ref<Eigen::ArrayXXd> im) const;

 private:
  void evaluate(const Eigen::Ref<const Eigen::ArrayXd>& omega, Eigen::Ref<Eigen::ArrayXXd> re,
                Eigen::Ref<Eigen::ArrayXXd> im) const;
  [[nodiscard]] double backward_error(const Eigen::Ref<const Eigen::ArrayXd>& omega, Eigen::Index first,
                                      Eigen::Index count, const Eigen::Ref<const Eigen::ArrayXXd>& re,
                                      const Eigen::Ref<const Eigen::ArrayXXd>& im) const;

  DynamicMatrices matrices_;  ///< scaled to a unit mass diagonal
  Eigen::VectorXcd load_;
  Eigen::VectorXd scale_;
  Eigen::ArrayXXd
      pairs_;  ///< by pair: ω and its small rest, −2σ, then c0 and c1 of the real load and of the imaginary one, n each
  bool complex_load_ = false;
};

}  // namespace trivet::numerics
