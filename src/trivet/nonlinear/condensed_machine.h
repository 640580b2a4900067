// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/assembly/loads.h"
#include "trivet/nonlinear/deflections.h"
#include "trivet/numerics/linalg/pole_residue.h"

namespace trivet::nonlinear {

/// The linear machine as its nonlinear deflections see it: at the angular frequency ω of one harmonic,
/// δ = motion − receptance · f, with the forces f of the nonlinear parts.
struct Receptance {
  Eigen::MatrixXcd receptance;  ///< deflections × deflections [m/N, …]
  Eigen::MatrixXcd slope;       ///< its derivative by ω
};
struct LinearMotion {
  Eigen::VectorXcd motion;  ///< deflections of the linear machine under its excitation
  Eigen::VectorXcd slope;   ///< derivative by ω
};

/// Poles and residues of the receptance at all deflections, so that one frequency costs (poles × deflections²).
class CondensedMachine {
 public:
  /// @throws foundation::NotComputable if elements depend on frequency beyond constant matrices, or if the machine
  /// is free to move when its nonlinear parts are removed
  CondensedMachine(const assembly::Assembled& assembled, const std::vector<Deflection>& deflections,
                   const assembly::Loading& loading);

  [[nodiscard]] Eigen::Index size() const { return static_receptance_.rows(); }
  [[nodiscard]] const Eigen::VectorXcd& poles() const { return poles_; }
  /// @param omega  [rad/s], > 0
  void set_receptance(double omega, Receptance& found) const;
  /// Without the slope.
  void set_receptance(double omega, Eigen::MatrixXcd& found) const;
  [[nodiscard]] LinearMotion linear_motion(double omega) const;
  /// At ω = 0, without losses.
  [[nodiscard]] const Eigen::MatrixXd& static_receptance() const { return static_receptance_; }

  /// All coordinates at each harmonic, under the forces of the nonlinear parts and the excitation.
  /// @param forces  Fourier coefficients × deflections
  /// @param omega   of the first harmonic [rad/s]
  /// @param factor  on the excitation
  /// @return coordinates × harmonics 0, 1, …
  [[nodiscard]] Eigen::MatrixXcd coordinates(const Eigen::MatrixXd& forces, double omega, double factor) const;

 private:
  /// @param omega   of the harmonic [rad/s]; 0: the mean
  /// @param factor  on the excitation; 0: it does not act at this harmonic
  [[nodiscard]] Eigen::VectorXcd coordinates_at(double omega, double factor, const Eigen::VectorXcd& force) const;
  /// A term s^power e^{−s delay} of the excitation: its column among the right sides of the poles.
  struct Term {
    int power;
    double delay;
    Eigen::Index column;
  };
  [[nodiscard]] Eigen::MatrixXcd at(std::complex<double> s, Eigen::Index first, Eigen::Index columns,
                                    Eigen::MatrixXcd& slope) const;

  Eigen::MatrixXcd all_shapes_;     ///< coordinates × poles
  Eigen::MatrixXcd all_static_;     ///< coordinates × right sides
  Eigen::MatrixXd all_receptance_;  ///< coordinates × deflections, at ω = 0
  Eigen::VectorXcd poles_;
  Eigen::MatrixXcd shapes_;         ///< deflections × poles
  Eigen::MatrixXcd participation_;  ///< poles × right sides
  Eigen::MatrixXcd static_part_;    ///< deflections × right sides
  Eigen::MatrixXcd residues_;       ///< entries of the receptance × poles
  std::vector<Term> terms_;
  numerics::Load ground_;  ///< deflections by the motion of the ground alone
  Eigen::MatrixXd static_receptance_;
};

}  // namespace trivet::nonlinear
