// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <vector>

#include "trivet/nonlinear/laws/deviation_law.h"
#include "trivet/numerics/periodic/radau_panel.h"

namespace trivet::nonlinear {

/// The bristles of LuGre friction over a periodic deflection. Their deflection z obeys dz/dφ = (1 − p z) dδ/dφ, which
/// is linear in z, so that the closed loop and all its derivatives are found without iteration: by collocation on
/// panels that resolve the layers after turning points and the change of friction with the rate.
class BristleLoop {
 public:
  /// @param deflection  Fourier coefficients of the deviation from the state
  /// @param omega       of the first harmonic [rad/s]; 0: slow motion
  /// @param turns       phases of its turning points, ascending in [0, 2π)
  /// @param longest     panel
  BristleLoop(const DeviationLaw::Bristles& part, const Eigen::VectorXd& deflection, double omega,
              const std::vector<double>& turns, double longest);

  /// False if the deflection does not move, but for round-off: the bristles then bear no more force than at the state.
  [[nodiscard]] bool moves() const { return !panels_.empty(); }

  /// At a phase, if it moves, with derivatives by time: dz/dt = v (1 − p z) has the variation `gain` δ̇ − `decay` ζ.
  struct Here {
    double force = 0;                    ///< beyond that at the state
    double by_rate = 0, by_bristle = 0;  ///< of the variation of the force
    double gain = 0, decay = 0;
  };
  [[nodiscard]] Here at(double phase) const;

  [[nodiscard]] const Eigen::VectorXd& phases() const { return phases_; }      ///< of the nodes
  [[nodiscard]] const Eigen::VectorXd& weights() const { return weights_; }    ///< of integrals over a period
  [[nodiscard]] const Eigen::VectorXd& bristles() const { return bristles_; }  ///< z at the nodes
  [[nodiscard]] const elements::LuGreFriction& law() const { return part_.law; }
  [[nodiscard]] double at_state() const { return part_.at_state; }
  /// Phases between which z is smooth, in [0, 2π): of the panels.
  [[nodiscard]] std::vector<double> corners() const;

  /// Closed variations of z at the nodes, nodes × columns, for variations of dδ/dφ there.
  [[nodiscard]] Eigen::MatrixXd variation(const Eigen::MatrixXd& slopes) const;
  /// The same of bristles whose variation is zero at the first turning point. The last row is also that one period
  /// later. The initial value decays as `fading` times the variation at the first turning point.
  [[nodiscard]] Eigen::MatrixXcd variation_from_zero(const Eigen::MatrixXcd& slopes) const;
  /// A variation of 1 at the first turning point, as it fades; and after a period.
  [[nodiscard]] const Eigen::VectorXd& fading() const { return fading_; }
  [[nodiscard]] double faded() const;
  [[nodiscard]] double first_turn() const { return ends_.front(); }  ///< phase
  /// Derivative with respect to ω at the same coefficients.
  [[nodiscard]] Eigen::VectorXd variation_by_omega() const;

 private:
  class Grading;
  [[nodiscard]] bool is_above_round_off(const std::vector<double>& turns) const;
  void add_branch(double from, double to, double longest);
  /// dz/dφ + p dδ/dφ z = source, from 0 at the first turning point on.
  template <typename Matrix>
  [[nodiscard]] Matrix from_zero(const Matrix& source) const;
  /// With the same z after each period.
  [[nodiscard]] Eigen::MatrixXd closed(const Eigen::MatrixXd& source) const;

  DeviationLaw::Bristles part_;
  Eigen::VectorXd deflection_, slope_;  ///< coefficients, of δ and dδ/dφ
  double omega_;
  std::vector<numerics::DecayingPanel> panels_;
  std::vector<double> ends_;    ///< of the panels, from the first turning point on
  std::vector<double> senses_;  ///< of the panels
  // At the nodes:
  Eigen::VectorXd phases_, weights_, slopes_, by_rate_, gains_, bristles_;
  Eigen::VectorXd fading_;
  double decayed_ = 0;  ///< ∫ p dδ over a period
};

/// Fourier coefficients of the force of bristles beyond that at the state, and their derivatives; first coefficients
/// are doubled.
struct BristleHarmonics {
  Eigen::VectorXd force;
  Eigen::MatrixXd tangent;   ///< by the coefficients of the deflection; empty if not requested
  Eigen::VectorXd by_omega;  ///< the same
};
/// @param deflection  that of the loop
[[nodiscard]] BristleHarmonics bristle_harmonics(const BristleLoop& loop, const Eigen::VectorXd& deflection,
                                                 double omega, bool with_tangent);

/// The force at the frequencies μ + k, k = −K … K, by a variation e^{i(μ + l)φ} of the deflection.
class BristleVariation {
 public:
  BristleVariation(const BristleLoop& loop, double omega, Eigen::Index harmonics);

  /// @param mu  0 … 1/2
  [[nodiscard]] Eigen::MatrixXcd at(double mu) const;

 private:
  /// Of bristles from 0 on, which is a smooth function of μ, and what closes them.
  struct Open {
    Eigen::MatrixXcd from_zero;  ///< their amplitudes
    Eigen::VectorXcd fading;     ///< amplitudes of the fading
    Eigen::RowVectorXcd ends;    ///< after a period
  };
  [[nodiscard]] Open open(const BristleLoop& loop, double mu) const;

  elements::LuGreFriction law_;
  bool moves_;
  double omega_, faded_;
  Eigen::Index harmonics_;
  std::vector<Open> at_places_;  ///< of Chebyshev's polynomials
};

}  // namespace trivet::nonlinear
