// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <memory>
#include <vector>

#include "trivet/assembly/assembled.h"
#include "trivet/nonlinear/laws/deflections.h"
#include "trivet/nonlinear/machine/linear_machine.h"
#include "trivet/nonlinear/machine/periodic_excitation.h"

namespace trivet::nonlinear {

/// Nonlinear deflections of which all others are sums: the six of two struts on one coordinate are multiples of one.
/// Motions have only the independent ones as unknowns.
struct DeflectionBasis {
  std::vector<Eigen::Index> independent;  ///< ascending
  Eigen::MatrixXd spread;                 ///< independent × all: motions of all = motions of the independent · spread

  [[nodiscard]] Eigen::Index size() const { return spread.rows(); }
  [[nodiscard]] bool has_all() const { return spread.rows() == spread.cols(); }
  /// Place among the independent ones of a deflection that is one of them.
  [[nodiscard]] Eigen::Index place(Eigen::Index deflection) const;
};

/// @param ground_moves  are the ground coordinates moved, so that they are a part of the deflections?
[[nodiscard]] DeflectionBasis deflection_basis(const assembly::Assembled& assembled,
                                               const std::vector<Deflection>& deflections, bool ground_moves);

/// The linear machine in periodic motion, as its independent nonlinear deflections see it: its receptance at every
/// frequency, and the harmonics at which it is excited.
class CondensedMachine {
 public:
  /// `assembled` must outlive it.
  /// @throws foundation::NotComputable if the machine is free to move when its nonlinear parts are removed, or if the
  /// data of an element begin above ω = 0
  CondensedMachine(const assembly::Assembled& assembled, const std::vector<Deflection>& deflections,
                   const PeriodicExcitation& excitation);

  [[nodiscard]] const DeflectionBasis& basis() const { return basis_; }
  /// Number of independent deflections, to which all of the following belongs.
  [[nodiscard]] Eigen::Index size() const { return static_receptance_.rows(); }
  /// Of the machine, or of the nearest one with constant matrices.
  [[nodiscard]] const Eigen::VectorXcd& poles() const { return machine_->poles(); }
  /// @param omega  [rad/s], > 0
  void set_receptance(double omega, Receptance& found) const { machine_->set_receptance(omega, found); }
  void set_receptance(double omega, Eigen::MatrixXcd& found) const { machine_->set_receptance(omega, found); }
  /// At ω = 0, without losses.
  [[nodiscard]] const Eigen::MatrixXd& static_receptance() const { return static_receptance_; }
  /// Frequency beyond which the data of an element end and are held constant [rad/s].
  [[nodiscard]] double known_to() const { return machine_->known_to(); }

  /// Harmonics that are excited, ascending.
  [[nodiscard]] const std::vector<Eigen::Index>& excited() const { return excited_; }
  /// Of one of them, at its own frequency ω > 0.
  [[nodiscard]] LinearMotion linear_motion(std::size_t excited, double omega) const {
    return machine_->motion(excited, omega);
  }

  /// All coordinates at each harmonic, under the forces of the nonlinear parts and the excitation.
  /// @param forces  Fourier coefficients × all deflections
  /// @param omega   of the first harmonic [rad/s]
  /// @param factor  on the excitation
  /// @return coordinates × harmonics 0, 1, …
  [[nodiscard]] Eigen::MatrixXcd coordinates(const Eigen::MatrixXd& forces, double omega, double factor) const;

 private:
  DeflectionBasis basis_;
  std::vector<Eigen::Index> excited_;
  std::unique_ptr<LinearMachine> machine_;
  Eigen::MatrixXd all_receptance_;  ///< coordinates × deflections, at ω = 0
  Eigen::MatrixXd static_receptance_;
};

}  // namespace trivet::nonlinear
