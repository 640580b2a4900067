// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "trivet/numerics/linalg/dynamic_matrices.h"

namespace trivet::numerics {

/// q(iω) of one system under a constant load from its poles: Σ over pairs (c0 + iω c1)/((ω_k² − ω²) − 2iωσ_k). Each ω_k
/// is stored as two numbers, so that differences of frequencies are exact near a resonance, and Re λ has all its
/// digits: near a lightly damped resonance this is several digits better than any solution of Z(ω) q = h, in half the
/// time of the fastest (benchmarks/README.md).
class PoleSweep {
 public:
  /// Empty unless A and K are positive definite, all matrices are symmetric without loss factor, n ≤ 12, and poles and
  /// residues are proven: each pole found once, none merging with another (|2λ| |v|²/|vᵀ(2λ + B̃)v| ≤ 1e4; 1 for
  /// well-separated modes), and a backward error ≤ 3e-15 at the frequencies of all poles and between them.
  [[nodiscard]] static std::optional<PoleSweep> try_build(const DynamicMatrices& matrices,
                                                          const Eigen::VectorXcd& load);

  /// q at these ω, count × n as real and imaginary parts, in memory that the caller keeps for further sweeps. One in 64
  /// frequencies is checked in Z q = h; returns false if a backward error exceeds 1e-14: then all must be solved
  /// directly.
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
  Eigen::ArrayXXd pairs_;  ///< per pair: ω and its small remainder, −2σ, then c0 and c1 of the real load and of the
                           ///< imaginary one, n each
  bool complex_load_ = false;
};

}  // namespace trivet::numerics
