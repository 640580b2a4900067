// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace trivet::numerics {

/// A periodic motion of three coordinates, with its derivatives by the phase.
class SpatialMotion {
 public:
  /// @param coefficients  Fourier coefficients (fourier_basis.h) × coordinates
  explicit SpatialMotion(const Eigen::MatrixXd& coefficients) {
    Eigen::Index count = coefficients.rows();
    while (count > 2 && coefficients.middleRows(count - 2, 2).isZero(0)) count -= 2;  // harmonics that are zero
    coefficients_ = coefficients.topRows(count).transpose();
  }

  struct Place {
    Eigen::Vector3d value, slope, bend;
  };
  [[nodiscard]] Place at(double phase) const {
    Place found{coefficients_.col(0), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    const double c = std::cos(phase), s = std::sin(phase);
    double ck = 1, sk = 0;
    for (Eigen::Index k = 1; 2 * k < coefficients_.cols(); ++k) {
      const double next = ck * c - sk * s, order = static_cast<double>(k);
      sk = sk * c + ck * s;
      ck = next;
      const Eigen::Vector3d harmonic = ck * coefficients_.col(2 * k - 1) + sk * coefficients_.col(2 * k);
      found.value += harmonic;
      found.slope += order * (ck * coefficients_.col(2 * k) - sk * coefficients_.col(2 * k - 1));
      found.bend -= order * order * harmonic;
    }
    return found;
  }

 private:
  Eigen::Matrix3Xd coefficients_;
};

}  // namespace trivet::numerics
