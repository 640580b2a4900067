// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "trivet/nonlinear/law_about.h"

namespace trivet::nonlinear {

/// Fourier coefficients of the force of a law over a periodic deflection, and their derivatives by the coefficients of
/// the deflection (numerics/periodic/fourier_basis.h).
struct ForceHarmonics {
  Eigen::VectorXd force;    ///< coefficients × 1
  Eigen::MatrixXd tangent;  ///< coefficients × coefficients
};

/// Computes them. Smooth forces are sampled evenly, which is exact for polynomials with enough samples. Where the
/// deflection passes a kink of the force, the instants are found, and the smooth pieces between them integrated by
/// Gauss's rule: the error then falls exponentially too, and not like that of samples across the kink.
class LawHarmonics {
 public:
  LawHarmonics(LawAbout law, Eigen::Index harmonics);

  [[nodiscard]] ForceHarmonics at(const Eigen::VectorXd& deflection) const;
  /// The force alone.
  [[nodiscard]] Eigen::VectorXd force_at(const Eigen::VectorXd& deflection) const;

  /// Phases at which the deflection passes a kink of the law, ascending in [0, 2π).
  [[nodiscard]] std::vector<double> kink_phases(const Eigen::VectorXd& deflection) const;

  [[nodiscard]] const LawAbout& law() const { return law_; }

 private:
  /// Fourier integrals of force and tangent over a period, the tangent to twice the harmonics.
  struct Spectra {
    Eigen::VectorXd force;    ///< coefficients
    Eigen::VectorXd tangent;  ///< coefficients; the first one is twice the mean
  };
  [[nodiscard]] Spectra spectra(const Eigen::VectorXd& deflection, bool with_tangent) const;
  void add_sampled(const Eigen::VectorXd& deflection, bool with_tangent, Spectra& sum) const;
  void add_between(const std::vector<double>& phases, const Eigen::VectorXd& deflection, bool with_tangent,
                   Spectra& sum) const;

  LawAbout law_;
  std::vector<double> kinks_;
  Eigen::Index harmonics_;
  Eigen::MatrixXd values_;  ///< samples × coefficients, to twice the harmonics
};

}  // namespace trivet::nonlinear
