// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/assembly/loads.h"

namespace trivet::response {

/// The fast solver against a second one: another assembly (of the motion of the ground too), another factorisation,
/// another precision. They share the element matrices, the damping of the system as a whole, and the rigid-motion
/// matrices of bodies.
struct DeepCheck {
  int frequencies = 0;   ///< compared
  int incomparable = 0;  ///< left out: so near an undamped resonance that round-off × condition exceeds 0.1 %
  double worst_difference =
      0;               ///< ‖q − q'‖∞ / ‖q'‖∞ in coordinates of unit mass diagonal, at its worst relative to `allowed`
  double allowed = 0;  ///< there: 16 ε × the larger of n and 12 × condition of Z × size of its terms over size of Z
  double at_angular_frequency = 0;  ///< [rad/s]
  bool passed = true;

  /// "agrees", "DISAGREES", or that nothing could be compared.
  [[nodiscard]] const char* verdict() const {
    return !passed ? "DISAGREES" : frequencies > 0 ? "agrees" : "undecided (nothing comparable)";
  }
};

/// Solves at each ω with a dynamic stiffness summed element by element in extended precision, by a pivoted solver with
/// extended residuals, and compares with the sweep.
/// @param excitations  the harmonic excitations that `loading` consists of (empty: all); the second solver takes the
/// motion of the ground from their
///                     description
[[nodiscard]] DeepCheck deep_check(const model::System& system, const assembly::Assembled& assembled,
                                   const assembly::Loading& loading, const std::vector<double>& angular_frequency,
                                   const std::vector<std::string>& excitations = {});

/// Frequencies worth a check: the poles in the band and an even spread, at most `count`.
[[nodiscard]] std::vector<double> check_frequencies(const Eigen::VectorXcd& poles, double from, double to, int count);

}  // namespace trivet::response
