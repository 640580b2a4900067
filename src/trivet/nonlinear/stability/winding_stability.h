// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "trivet/nonlinear/laws/machine_laws.h"
#include "trivet/nonlinear/machine/condensed_machine.h"

namespace trivet::nonlinear {

/// Stability of periodic motions from the receptance alone, so also of machines that are not a set of states in time.
/// Floquet exponents s are zeros of D(s) = det(I + G(s + ikω) T), k = −K … K, in one strip |Im s| ≤ ω/2, where T is the
/// Toeplitz matrix of the tangents along the motion. By the argument principle the number of zeros with Re s > 0 is
/// that of the poles of G there less the turns of D(iν) about 0 for ν from −ω/2 to ω/2.
/// [Hill 1886; Lazarus, Thomas, C. R. Mécanique 338 (2010)]
class WindingStability {
 public:
  /// Both must outlive it. The machine has no loss factors, which are not analytic in s.
  WindingStability(const CondensedMachine& machine, const std::vector<Deflection>& deflections)
      : machine_(machine), deflections_(deflections) {}

  /// Number of Floquet exponents with Re s > 0; empty if an exponent lies on the axis, to
  /// round-off: D is then almost zero somewhere, and its turns cannot be told.
  /// @param motion  Fourier coefficients × all deflections
  /// @param omega   of the first harmonic [rad/s]
  [[nodiscard]] std::optional<int> unstable_exponents(const Eigen::MatrixXd& motion, double omega) const;

 private:
  const CondensedMachine& machine_;
  const std::vector<Deflection>& deflections_;
};

}  // namespace trivet::nonlinear
