// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

#include "trivet/model/system.h"
#include "trivet/nonlinear/laws/law_over_period.h"

namespace trivet::nonlinear {

/// Fourier coefficients of the force of a law over a periodic deflection, and their derivatives
/// (numerics/periodic/fourier_basis.h).
struct ForceHarmonics {
  Eigen::VectorXd force;     ///< coefficients × 1
  Eigen::MatrixXd tangent;   ///< by the coefficients of the deflection
  Eigen::VectorXd by_omega;  ///< by the frequency of the motion, at the same coefficients
};

/// Computes them. Smooth forces are sampled evenly, which is exact for polynomials with enough samples. Where a force
/// is not smooth, the instants are found. Between them, forces of second degree are integrated in closed form, others
/// by Gauss's rule: the error then falls exponentially too, and not like that of samples across a kink. Hysteretic
/// forces are those of closed loops.
class LawHarmonics {
 public:
  /// @param of_motion  harmonics of the motions, if these are fewer and padded with zeros
  LawHarmonics(DeviationLaw law, Eigen::Index harmonics, std::optional<Eigen::Index> of_motion = std::nullopt);

  /// @param omega  of the first harmonic [rad/s]
  /// @param round_off  as of LawOverPeriod
  [[nodiscard]] ForceHarmonics at(const Eigen::VectorXd& deflection, double omega, double round_off = 0) const;
  /// The force alone.
  [[nodiscard]] Eigen::VectorXd force_at(const Eigen::VectorXd& deflection, double omega, double round_off = 0) const;

  /// Coefficients of the tangents, to twice the harmonics, with doubled means: of elastic forces and of loops since
  /// their last turning points by the deflection, of dampers by the rate. Without parts that depend on the amplitude.
  struct TangentHarmonics {
    Eigen::VectorXd by_deflection, by_rate;
  };
  [[nodiscard]] TangentHarmonics tangents_at(const Eigen::VectorXd& deflection, double omega,
                                             double round_off = 0) const;

  [[nodiscard]] LawOverPeriod course(const Eigen::VectorXd& deflection, double omega, double round_off = 0) const;
  [[nodiscard]] const DeviationLaw& law() const { return law_; }

 private:
  /// Fourier integrals over a period; those of the tangents to twice the harmonics.
  struct Spectra {
    bool with_tangent = false;
    Eigen::VectorXd force;  ///< coefficients; the first one is twice the mean
    Eigen::VectorXd by_deflection, by_rate;
    Eigen::VectorXd by_omega;  ///< of the instants at which forces jump
    /// What the force owes to past turning points, bristles and the amplitude, by the coefficients.
    Eigen::MatrixXd by_memory;
  };
  [[nodiscard]] Spectra spectra(const Eigen::VectorXd& deflection, double omega, double round_off,
                                bool with_tangent) const;
  void add_line(const LawOverPeriod& course, const Eigen::VectorXd& deflection, double omega, Spectra& sum) const;
  void add_sampled(const DeviationLaw::Parts& parts, const Eigen::VectorXd& deflection, double omega,
                   Spectra& sum) const;
  void add_quadratic(const LawOverPeriod& course, const Eigen::VectorXd& deflection, double omega, Spectra& sum) const;
  void add_between_corners(const LawOverPeriod& course, Spectra& sum) const;
  void add_bristles(const LawOverPeriod& course, const Eigen::VectorXd& deflection, double omega, Spectra& sum) const;
  void add_of_amplitude(const LawOverPeriod& course, const Eigen::VectorXd& deflection, Spectra& sum) const;
  void add_jumps(const Eigen::VectorXd& deflection, double omega, const HystereticLoop& loop, Spectra& sum) const;
  void add_loop(const LawOverPeriod& course, const HystereticLoop& loop, Spectra& sum) const;
  [[nodiscard]] double longest_piece() const;

  DeviationLaw law_;
  Eigen::Index harmonics_, of_motion_;
  Eigen::MatrixXd values_;     ///< samples × coefficients, to twice the harmonics; empty if no part is sampled
  Eigen::MatrixXd of_course_;  ///< the same of the motion, by which corners are sought; empty if there are none
};

/// The force of the laws of one nonlinear part under a slow sine of the deflection about rest, after the loop has
/// closed: in addition to the linear element, without its dampers; bristles at rates far below their Stribeck velocity.
struct LawLoop {
  double amplitude = 0;                     ///< of the deflection [m, rad]
  std::vector<double> deflections, forces;  ///< of one period from the largest deflection, whole ones [m, N; rad, N m]
  double storage = 0, loss = 0;             ///< stiffness of the first harmonic in phase and in quadrature
  double energy = 0;                        ///< lost per period [J]
};

/// Loops from a twentieth of the deflection at which the laws show themselves up to it.
/// @param own_stiffness  of the linear element along the part
[[nodiscard]] std::vector<LawLoop> law_loops(const model::NonlinearPart& part, double own_stiffness);

}  // namespace trivet::nonlinear
