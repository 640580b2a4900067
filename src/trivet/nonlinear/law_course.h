// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/nonlinear/hysteretic_loop.h"
#include "trivet/nonlinear/law_about.h"

namespace trivet::nonlinear {

/// One law along one periodic deflection: where it is not smooth, and its closed loops.
class LawCourse {
 public:
  /// The law must outlive it.
  /// @param deflection  Fourier coefficients of the deviation from the state (numerics/periodic/fourier_basis.h)
  /// @param omega       of the first harmonic [rad/s]
  /// @param samples     evenly spaced phases × coefficients: rows of the basis
  LawCourse(const LawAbout& law, const Eigen::VectorXd& deflection, double omega,
            const Eigen::Ref<const Eigen::MatrixXd>& samples);

  /// Phases at which the parts without memory are not smooth, ascending in [0, 2π).
  [[nodiscard]] const std::vector<double>& corners() const { return corners_; }
  /// One per hysteretic part that moves.
  [[nodiscard]] const std::vector<HystereticLoop>& loops() const { return loops_; }
  /// `corners`, and the turning points and kinks of the loops, in no order.
  [[nodiscard]] std::vector<double> all_corners() const;

  [[nodiscard]] bool is_damped() const { return law_.has_dampers(); }
  [[nodiscard]] double deflection_at(double phase) const;
  [[nodiscard]] double rate_at(double phase) const;  ///< by time
  /// Of the parts without memory.
  [[nodiscard]] LawAbout::Force at(double phase) const;
  /// The same, with the row of the basis at a phase (set_fourier_row).
  [[nodiscard]] LawAbout::Force at(const Eigen::RowVectorXd& row) const {
    return law_.without_memory(row.dot(deflection_), is_damped() ? row.dot(rate_) : 0);
  }

 private:
  const LawAbout& law_;
  Eigen::VectorXd deflection_, rate_;
  std::vector<double> corners_;
  std::vector<HystereticLoop> loops_;
};

}  // namespace trivet::nonlinear
