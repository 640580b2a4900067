// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/nonlinear/laws/law_set.h"
#include "trivet/nonlinear/machine/condensed_machine.h"
#include "trivet/numerics/periodic/branch.h"

namespace trivet::nonlinear {

struct Driving {
  double omega = 0;   ///< [rad/s]
  double factor = 1;  ///< on the excitation
};
enum class Parameter { frequency, load_factor };

/// Harmonic balance in the nonlinear deflections alone: δ_k − motion_k + G(kω) f_k(δ) = 0 for k = 0 … H. The linear
/// machine enters by its receptance G only. Unknowns: the Fourier coefficients of one independent deflection after
/// another (DeflectionBasis, numerics/periodic/fourier_basis.h); parameter: ω of the first harmonic [rad/s], or a
/// factor on it at fixed ω.
class HarmonicBalance {
 public:
  /// The machine must outlive the balance.
  HarmonicBalance(const CondensedMachine& machine, const std::vector<Deflection>& deflections, Eigen::Index harmonics);

  [[nodiscard]] Eigen::Index harmonics() const { return harmonics_; }
  [[nodiscard]] Eigen::Index coefficients() const;  ///< of one deflection
  [[nodiscard]] Eigen::Index size() const { return coefficients() * machine_.size(); }
  void evaluate(const Eigen::VectorXd& unknowns, const Driving& driving, Parameter parameter,
                numerics::Equations& equations) const;
  /// Harmonics that are excited, ascending.
  [[nodiscard]] const std::vector<Eigen::Index>& excited() const { return machine_.excited(); }
  /// Coefficients of the linear motion, without the nonlinear forces.
  [[nodiscard]] Eigen::VectorXd linear_motion(const Driving& driving) const;
  [[nodiscard]] const LawSet& laws() const { return laws_; }
  /// Coefficients × all deflections: a motion, and the unknowns of one.
  [[nodiscard]] Eigen::MatrixXd motion(const Eigen::VectorXd& unknowns) const;
  [[nodiscard]] Eigen::VectorXd unknowns_of(const Eigen::MatrixXd& motion) const;
  /// Coefficients × all deflections: the forces over a motion.
  [[nodiscard]] Eigen::MatrixXd forces(const Eigen::VectorXd& unknowns, double omega) const;
  /// Largest coefficient of the kind of each independent deflection (DeflectionScales): of all, of the means, or
  /// without them.
  [[nodiscard]] Eigen::VectorXd largest(const Eigen::VectorXd& unknowns) const;
  [[nodiscard]] Eigen::VectorXd largest_means(const Eigen::VectorXd& unknowns) const;
  [[nodiscard]] Eigen::VectorXd largest_harmonics(const Eigen::VectorXd& unknowns) const;
  /// Is one motion another, but for a share of its largest deflections?
  [[nodiscard]] bool are_same(const Eigen::VectorXd& one, const Eigen::VectorXd& other, double share) const;
  /// Largest deflection that the harmonics from H + 1 to 3H add, as a share of the largest coefficient of its kind:
  /// what the truncation leaves out, to first order.
  [[nodiscard]] double left_out(const Eigen::VectorXd& unknowns, double omega) const;
  /// The same of harmonics beyond the end of the data of an element.
  [[nodiscard]] double held_share(const Eigen::VectorXd& unknowns, double omega) const;

 private:
  /// @param amplitudes  of all deflections
  [[nodiscard]] Eigen::VectorXd of_independent(const Eigen::VectorXd& amplitudes) const;
  [[nodiscard]] double added(const Eigen::MatrixXd& forces, Eigen::Index above, const Eigen::VectorXd& unknowns,
                             double omega) const;

  const CondensedMachine& machine_;
  Eigen::Index harmonics_;
  LawSet laws_;
  LawSet wider_;  ///< the same laws with 3H harmonics: those of a cube
};

}  // namespace trivet::nonlinear
