// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <complex>
#include <string>
#include <utility>
#include <vector>

#include "trivet/assembly/assembled.h"
#include "trivet/model/system.h"
#include "trivet/numerics/linalg/load.h"

namespace trivet::assembly {

/// Excitation of the system: generalized forces on its free coordinates, and the motion of the ground coordinates.
struct Loading {
  numerics::Load force;
  numerics::Load motion;

  template <typename Vector>
  Loading(const Eigen::MatrixBase<Vector>& constant_force)
      : force(constant_force), motion(Eigen::Index{0}) {}  // NOLINT: a vector is a load
  Loading(numerics::Load forces, numerics::Load motions) : force(std::move(forces)), motion(std::move(motions)) {}

  [[nodiscard]] bool vanishes() const { return force.vanishes() && motion.vanishes(); }
  [[nodiscard]] double longest_delay() const { return std::max(force.longest_delay(), motion.longest_delay()); }
  /// Negative if a motion is given by its velocity or acceleration; it then has no limit at rest.
  [[nodiscard]] int lowest_power() const { return std::min(force.lowest_power(), motion.lowest_power()); }
};

/// Loading of one action with a course of unit amplitude: forces, or motions of the ground by powers of s = iω.
[[nodiscard]] Loading loading(const Assembled& assembled, const model::Action& action);

/// Sum of all harmonic excitations, or of those named.
/// @throws foundation::InvalidInput for a name that is not a harmonic excitation
[[nodiscard]] Loading harmonic_loading(const model::System& system, const Assembled& assembled,
                                       const std::vector<std::string>& selected = {});

/// Right side of Z q = h for constant matrices: forces minus the contribution of the ground motion.
[[nodiscard]] numerics::Load right_side(const Assembled& assembled, const Loading& loading);

/// Adds to h, at one ω, the contribution of the ground motion through frequency-dependent elements, first rows of the
/// layout.
void add_frequency_dependent(const Assembled& assembled, const Loading& loading, std::complex<double> omega,
                             double near, Eigen::VectorXcd& h);

/// Right side at one ω with frequency-dependent elements, first rows of the layout.
[[nodiscard]] Eigen::VectorXcd exact_right_side(const Assembled& assembled, const Loading& loading,
                                                std::complex<double> omega, double near);

/// Gravity on every body and on the mass of the elements, the preloads that balance it, the offsets of nonlinear parts,
/// and the constant forces.
[[nodiscard]] Eigen::VectorXd static_load(const model::System& system, const Assembled& assembled);
/// The constant forces alone: loads on a machine that its weight has brought to rest.
[[nodiscard]] Eigen::VectorXd constant_load(const model::System& system, const Assembled& assembled);

}  // namespace trivet::assembly
