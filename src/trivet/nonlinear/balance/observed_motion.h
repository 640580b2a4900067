// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "trivet/assembly/channels.h"
#include "trivet/nonlinear/laws/law_set.h"
#include "trivet/nonlinear/machine/periodic_excitation.h"

namespace trivet::nonlinear {

/// One result of a periodic motion, as a deviation from rest.
struct ObservedMotion {
  double mean = 0;
  Eigen::VectorXcd harmonics;        ///< complex amplitudes of harmonic 1, 2, …
  double largest = 0, smallest = 0;  ///< over a period
  double rms = 0;                    ///< of the deviation from the mean

  [[nodiscard]] double half_of_range() const { return (largest - smallest) / 2; }
  /// By the harmonics, at a phase of the first one.
  [[nodiscard]] double value_at(double phase) const;
  [[nodiscard]] double slope_at(double phase) const;  ///< d/d(phase)
};

/// Results of periodic motions: channels of the machine, with the forces of its nonlinear parts.
class Observer {
 public:
  /// `assembled` must outlive it.
  /// @param quantities  one per name; empty: `quantity` of all
  /// @throws foundation::InvalidInput for an unknown name
  Observer(const model::System& system, const assembly::Assembled& assembled, PeriodicExcitation excitation,
           const std::vector<Deflection>& deflections, const std::vector<std::string>& of,
           assembly::MotionQuantity quantity, const std::vector<assembly::MotionQuantity>& quantities = {});

  [[nodiscard]] const std::vector<assembly::Channel>& channels() const { return channels_; }

  /// @param coordinates  free coordinates × harmonics 0, 1, …: complex amplitudes
  /// @param forces       Fourier coefficients × nonlinear deflections, beyond the tangents of the machine
  /// @param omega        of the first harmonic [rad/s]
  /// @param factor       on the motion of the ground
  /// @param remainder    what the harmonics of the forces leave out, which the extremes and root mean squares of
  ///                     forces and accelerations contain; null: nothing
  [[nodiscard]] std::vector<ObservedMotion> at(const Eigen::MatrixXcd& coordinates, const Eigen::MatrixXd& forces,
                                               double omega, double factor,
                                               const ForceRemainder* remainder = nullptr) const;
  /// Does any result follow the forces of nonlinear parts at once: forces and accelerations?
  [[nodiscard]] bool follows_forces() const { return !direct_.isZero(0) || !feedthrough_.isZero(0); }

 private:
  [[nodiscard]] std::complex<double> value(std::size_t channel, std::complex<double> s,
                                           const Eigen::VectorXcd& coordinates, const Eigen::VectorXcd& ground) const;

  const assembly::Assembled& assembled_;
  PeriodicExcitation excitation_;
  std::vector<assembly::Channel> channels_;
  Eigen::MatrixXd direct_;       ///< channels × nonlinear deflections: their forces in results that are forces
  Eigen::MatrixXd feedthrough_;  ///< accelerations per such force that is quick: by the masses alone
};

}  // namespace trivet::nonlinear
