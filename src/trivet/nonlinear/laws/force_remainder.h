// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "trivet/nonlinear/laws/machine_laws.h"

namespace trivet::nonlinear {

/// What the harmonics of the forces of nonlinear parts leave out over a period: the laws themselves along the
/// deflections, less their harmonics. A stop that is touched briefly has most of its force there.
class ForceRemainder {
 public:
  /// `laws` must outlive it.
  /// @param course     Fourier coefficients × deflections
  /// @param harmonics  of the forces, coefficients × deflections
  /// @param omega      of the first harmonic [rad/s]
  ForceRemainder(const MachineLaws& laws, const Eigen::MatrixXd& course, const Eigen::MatrixXd& harmonics,
                 double omega);

  /// Ascending in [0, 2π): evenly spaced, more of them between the instants at which a force is not smooth, and both
  /// sides of these.
  [[nodiscard]] const std::vector<double>& phases() const { return phases_; }
  /// One number per deflection.
  [[nodiscard]] Eigen::RowVectorXd at(double phase) const;

 private:
  void add_phases(std::vector<double> corners);

  Eigen::MatrixXd course_, harmonics_;
  double omega_;
  struct Single {
    Eigen::Index deflection;
    LawCourse course;
  };
  std::vector<Single> singles_;
  std::vector<const MachineLaws::Distance*> distances_;
  struct Rubbing {
    std::array<Eigen::Index, 3> on;
    RubbingLoop loop;
  };
  std::vector<Rubbing> rubbings_;
  std::vector<bool> known_;  ///< deflections whose remainder is computed; that of the others is zero
  std::vector<double> phases_;
};

}  // namespace trivet::nonlinear
