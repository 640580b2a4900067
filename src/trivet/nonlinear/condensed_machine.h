// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "trivet/assembly/loads.h"
#include "trivet/numerics/linalg/pole_residue.h"

namespace trivet::nonlinear {

/// One deflection with a nonlinear force.
struct Deflection {
  std::string name;                ///< "mount.deflection.z"
  Eigen::VectorXd on_coordinates;  ///< free coordinates: the deflection, and by virtual work the force on them
  Eigen::VectorXd on_ground;       ///< ground coordinates
  elements::ScalarLaw law;
};

/// All nonlinear parts of a system, in the order of its elements.
[[nodiscard]] std::vector<Deflection> nonlinear_deflections(const model::System& system,
                                                            const assembly::Assembled& assembled);

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
  /// @param omega  [rad/s], > 0
  [[nodiscard]] Receptance receptance(double omega) const;
  [[nodiscard]] LinearMotion linear_motion(double omega) const;
  /// At ω = 0, without losses.
  [[nodiscard]] const Eigen::MatrixXd& static_receptance() const { return static_receptance_; }

 private:
  /// A term s^power e^{−s delay} of the excitation: its column among the right sides of the poles.
  struct Term {
    int power;
    double delay;
    Eigen::Index column;
  };
  [[nodiscard]] Eigen::MatrixXcd at(std::complex<double> s, Eigen::Index first, Eigen::Index columns,
                                    Eigen::MatrixXcd& slope) const;

  Eigen::VectorXcd poles_;
  Eigen::MatrixXcd shapes_;         ///< deflections × poles
  Eigen::MatrixXcd participation_;  ///< poles × right sides
  Eigen::MatrixXcd static_part_;    ///< deflections × right sides
  std::vector<Term> terms_;
  numerics::Load ground_;  ///< deflections by the motion of the ground alone
  Eigen::MatrixXd static_receptance_;
};

}  // namespace trivet::nonlinear
