// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <vector>

#include "trivet/assembly/assembled.h"
#include "trivet/model/system.h"
#include "trivet/nonlinear/laws/deflections.h"
#include "trivet/nonlinear/laws/law_set.h"
#include "trivet/numerics/periodic/branch.h"

namespace trivet::nonlinear {

/// A motion of vanishing amplitude about rest from which a nonlinear mode begins.
struct ModeAtRest {
  double angular_frequency = 0;  ///< [rad/s]
  Eigen::VectorXd shape;         ///< free coordinates, φᵀAφ = 1
};

/// Ascending. Directions without a stiffness at rest that deflect nonlinear parts come first: they have a frequency as
/// soon as they move. They are in the order of their stiffnesses over a small deflection.
/// @param system   about rest, with tangents
/// @param holding  a stiffness of the machine that holds all that nonlinear parts hold somewhere
[[nodiscard]] std::vector<ModeAtRest> modes_at_rest(const model::System& system, const assembly::Assembled& assembled,
                                                    const Eigen::MatrixXd& holding);

/// Periodic motions without excitation, in all coordinates:
/// (K − k²ω²A) q_k + i (k ω (B − 2 ζ ω A) + K_loss) q_k + W f_k = 0 for k = 0 … H (losses for k > 0). Damped, a
/// negative damping −2 ζ ω A keeps them periodic. Undamped motions that begin at rest have cosines only. Unknowns: the
/// cosines of all harmonics, harmonic by harmonic; damped, the sines from the first harmonic on as well, and a multiple
/// of ζ. Parameter: ω. [Krack, Nonlinear modal analysis of nonconservative systems, 2015]
class FreeMotion {
 public:
  /// @param holding  a stiffness of the machine, regular, with which deflections of unlike kinds are compared
  FreeMotion(const assembly::Assembled& assembled, const std::vector<Deflection>& deflections, bool damped,
             Eigen::Index harmonics, const Eigen::MatrixXd& holding);

  /// The mode whose rate at phase 0 is zero, and the value of its unknown for ζ = 1: of the size of the motion.
  void set_mode(const Eigen::VectorXd& shape, double ratio_scale);

  void evaluate(const Eigen::VectorXd& unknowns, double omega, numerics::Equations& equations) const;

  [[nodiscard]] Eigen::Index coordinates() const { return A_.rows(); }
  [[nodiscard]] Eigen::Index size() const {
    return damped_ ? coordinates() * (2 * harmonics_ + 1) + 1 : coordinates() * (harmonics_ + 1);
  }
  [[nodiscard]] const Eigen::MatrixXd& across() const { return across_; }  ///< coordinates × deflections
  [[nodiscard]] const LawSet& laws() const { return laws_; }

  /// Row of the Fourier coefficient c (numerics/periodic/fourier_basis.h) of the first coordinate among the unknowns;
  /// negative if it is not one of them.
  [[nodiscard]] Eigen::Index place(Eigen::Index coefficient) const;

  /// Fourier coefficients × coordinates.
  [[nodiscard]] Eigen::MatrixXd motion(const Eigen::VectorXd& unknowns) const;
  /// Fourier coefficients × deflections, and the forces at them.
  [[nodiscard]] Eigen::MatrixXd deflections(const Eigen::VectorXd& unknowns) const {
    return motion(unknowns) * across_;
  }
  [[nodiscard]] Eigen::MatrixXd forces(const Eigen::VectorXd& unknowns, double omega) const {
    return laws_.forces(deflections(unknowns), omega);
  }
  [[nodiscard]] double damping_ratio(const Eigen::VectorXd& unknowns) const {
    return damped_ ? unknowns(size() - 1) / ratio_scale_ : 0;
  }

  /// Largest amplitude that the harmonics from H + 1 to 3H add, as a share of the largest of its kind.
  [[nodiscard]] double left_out(const Eigen::VectorXd& unknowns, double omega) const;

 private:
  void add_forces(const Eigen::VectorXd& unknowns, double omega, numerics::Equations& equations) const;

  Eigen::MatrixXd A_, B_, K_, K_loss_;
  bool damped_;
  Eigen::Index harmonics_;
  Eigen::MatrixXd across_;
  DeflectionScales sizes_;
  LawSet laws_, wider_;
  Eigen::VectorXd phase_;
  double ratio_scale_ = 1;
};

}  // namespace trivet::nonlinear
