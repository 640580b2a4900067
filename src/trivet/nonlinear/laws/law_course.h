// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/nonlinear/laws/bristle_loop.h"
#include "trivet/nonlinear/laws/hysteretic_loop.h"
#include "trivet/nonlinear/laws/law_about.h"

namespace trivet::nonlinear {

/// One law along one periodic deflection: where it is not smooth, and its closed loops.
class LawCourse {
 public:
  /// The law must outlive it.
  /// @param deflection  Fourier coefficients of the deviation from the state (numerics/periodic/fourier_basis.h)
  /// @param harmonics   of the motion; the others are zero
  /// @param omega       of the first harmonic [rad/s]
  /// @param samples     evenly spaced phases × coefficients to those harmonics: rows of the basis; of laws that have
  ///                    neither corners nor memory they are not needed
  /// @param round_off   a smaller amplitude is none: the turning points of noise would decide on the memory of friction
  LawCourse(const LawAbout& law, const Eigen::VectorXd& deflection, Eigen::Index harmonics, double omega,
            const Eigen::Ref<const Eigen::MatrixXd>& samples, double round_off = 0);

  /// Phases at which the parts without memory are not smooth, ascending in [0, 2π).
  [[nodiscard]] const std::vector<double>& corners() const { return corners_; }
  /// One per hysteretic part that moves.
  [[nodiscard]] const std::vector<HystereticLoop>& loops() const { return loops_; }
  /// Of those that do not, which stick.
  [[nodiscard]] double resting_stiffness() const { return resting_stiffness_; }
  /// One per law of bristles.
  [[nodiscard]] const std::vector<BristleLoop>& bristles() const { return bristles_; }
  /// `corners`, the turning points and kinks of the loops, and the panels of bristles, in no order.
  [[nodiscard]] std::vector<double> all_corners() const;

  [[nodiscard]] bool has_no_law() const { return law_.is_empty(); }
  [[nodiscard]] bool is_damped() const { return law_.has_dampers(); }
  [[nodiscard]] double deflection_at(double phase) const;
  [[nodiscard]] double rate_at(double phase) const;  ///< by time
  /// With the row of the basis at a phase, which may go on beyond the motion.
  [[nodiscard]] double deflection_at(const Eigen::RowVectorXd& row) const {
    return row.head(deflection_.size()).dot(deflection_);
  }
  [[nodiscard]] double rate_at(const Eigen::RowVectorXd& row) const { return row.head(rate_.size()).dot(rate_); }
  /// Of the parts without memory, of those that rest, and of those that depend on the amplitude: k' over the
  /// deflection, k''/ω over the rate of the first harmonic, at the amplitude of the motion.
  [[nodiscard]] LawAbout::Force at(double phase) const;
  /// The tangents alone at many phases, rows of the basis, if no part depends on the rate.
  [[nodiscard]] Eigen::VectorXd elastic_tangents(const Eigen::MatrixXd& rows) const;
  /// The force, with the row of the basis at a phase (set_fourier_row).
  [[nodiscard]] LawAbout::Force at(const Eigen::RowVectorXd& row) const;

  /// Of the motion about its mean: that of a harmonic motion of the same root mean square.
  [[nodiscard]] double amplitude() const;
  /// k' and k'' there.
  [[nodiscard]] const elements::StiffnessOfAmplitude& of_amplitude() const { return of_amplitude_; }
  /// Coefficients of the motion, each harmonic a quarter of its period ahead: k'' times it is the force of the losses.
  [[nodiscard]] const Eigen::VectorXd& ahead() const { return ahead_; }

 private:
  [[nodiscard]] double turning_slope(Eigen::Index harmonics) const;

  const LawAbout& law_;
  double omega_;
  Eigen::VectorXd deflection_, rate_, ahead_;
  elements::StiffnessOfAmplitude of_amplitude_;
  std::vector<double> corners_;
  std::vector<HystereticLoop> loops_;
  double resting_stiffness_ = 0;
  std::vector<BristleLoop> bristles_;
};

}  // namespace trivet::nonlinear
