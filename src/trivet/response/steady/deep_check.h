// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <complex>
#include <string>
#include <vector>

#include "trivet/assembly/loads.h"
#include "trivet/model/system.h"

namespace trivet::response {

/// Comparison of the fast solver with a second one: another assembly (also of the motion of the ground), another
/// factorisation, another precision. They share the element matrices, the system damping, and the rigid-motion matrices
/// of bodies.
struct DeepCheck {
  int frequencies = 0;   ///< compared
  int incomparable = 0;  ///< excluded: so near an undamped resonance that round-off × condition exceeds 0.1 %
  double worst_difference =
      0;  ///< ‖q − q'‖∞ / ‖q'‖∞ in coordinates of unit mass diagonal, where it is worst relative to `allowed`
  double allowed = 0;               ///< there: 16 ε × max(n, 12) × condition of Z × size of its terms / size of Z
  double at_angular_frequency = 0;  ///< [rad/s]
  bool passed = true;

  /// "agrees", "DISAGREES", or "undecided" if no frequency could be compared.
  [[nodiscard]] const char* verdict() const {
    return !passed ? "DISAGREES" : frequencies > 0 ? "agrees" : "undecided (no comparable frequency)";
  }
};

/// Solves at each ω with a dynamic stiffness summed element by element in extended precision, by a pivoted solver with
/// extended residuals, and compares with the sweep.
/// @param excitations  the harmonic excitations in `loading` (empty: all); the second solver takes the motion of the
/// ground from their description
[[nodiscard]] DeepCheck deep_check(const model::System& system, const assembly::Assembled& assembled,
                                   const assembly::Loading& loading, const std::vector<double>& angular_frequency,
                                   const std::vector<std::string>& excitations = {});

/// Frequencies for a check: the poles in the band and evenly spaced ones, at most `count`.
[[nodiscard]] std::vector<double> check_frequencies(const Eigen::VectorXcd& poles, double from, double to, int count);

/// Motion of both ends of each element that harmonic motion of the ground prescribes at ω, with all free coordinates at
/// rest: 12 per element (end N, end K), in the element's local axes. Taken from the description alone, without
/// `assembly::Ground`: an independent derivation for the second solver.
class PrescribedEnds {
 public:
  using Vector = Eigen::Matrix<std::complex<long double>, Eigen::Dynamic, 1>;

  /// @param excitations  names of the harmonic ones that act; empty: all
  PrescribedEnds(const model::System& system, const std::vector<std::string>& excitations);

  /// True if an excitation moves the ground and an end of this element is on it, directly or through a foundation.
  [[nodiscard]] bool can_move(std::size_t element) const;
  [[nodiscard]] Vector at(std::size_t element, double angular_frequency) const;

 private:
  using Motion = Eigen::Matrix<std::complex<long double>, 6, 1>;

  Motion ground_at(const Eigen::Vector3d& place, std::size_t element, long double omega) const;

  const model::Description& description_;
  std::vector<const model::Excitation*> moving_;
  std::vector<int> impedance_of_;  ///< element between each foundation and the rigid ground; −1 for modes
};

}  // namespace trivet::response
