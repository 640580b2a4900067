// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <vector>

#include "trivet/nonlinear/laws/distance_about.h"

namespace trivet::nonlinear {

/// Fourier coefficients of a distance force over three periodic deflections, and their derivatives, as LawHarmonics has
/// them of a force over one.
class DistanceHarmonics {
 public:
  DistanceHarmonics(DistanceAbout law, Eigen::Index harmonics);

  template <typename Entry>
  using Square = std::array<std::array<Entry, 3>, 3>;  ///< forces × deflections
  struct Found {
    Eigen::MatrixXd force, by_omega;  ///< coefficients × 3
    Square<Eigen::MatrixXd> tangent;  ///< by the coefficients of each deflection
  };
  /// @param course  coefficients × 3
  /// @param omega   of the first harmonic [rad/s]
  [[nodiscard]] Found at(const Eigen::MatrixXd& course, double omega) const;
  [[nodiscard]] Eigen::MatrixXd force_at(const Eigen::MatrixXd& course, double omega) const;

  /// Coefficients of the tangents, to twice the harmonics, with doubled means.
  struct Spectra {
    Square<Eigen::VectorXd> by_deflection, by_rate;
  };
  [[nodiscard]] Spectra tangents_at(const Eigen::MatrixXd& course, double omega) const;

  /// Phases at which it is not smooth, ascending in [0, 2π).
  [[nodiscard]] std::vector<double> corners(const Eigen::MatrixXd& course) const;
  [[nodiscard]] elements::SpatialForce at_phase(const Eigen::MatrixXd& course, double omega, double phase) const;
  /// @param row  of the basis at the phase (numerics/periodic/fourier_basis.h)
  [[nodiscard]] elements::SpatialForce at_row(const Eigen::MatrixXd& course, double omega,
                                              const Eigen::RowVectorXd& row) const;
  [[nodiscard]] const DistanceAbout& law() const { return law_; }

 private:
  struct Nodes {
    Eigen::MatrixXd between_corners;  ///< rows of the basis; empty: the even samples
    Eigen::VectorXd weights;
  };
  [[nodiscard]] Nodes nodes(const Eigen::MatrixXd& course) const;
  /// Fourier coefficients, those of the tangents as in Spectra, entries by columns.
  struct Sums {
    Eigen::MatrixXd force, by_deflection, by_rate;
  };
  [[nodiscard]] Sums sums(const Eigen::MatrixXd& course, double omega, bool with_tangents) const;
  [[nodiscard]] static Spectra spectra_of(const Sums& sums);

  DistanceAbout law_;
  Eigen::Index harmonics_;
  Eigen::MatrixXd values_;  ///< samples × coefficients, to twice the harmonics
};

}  // namespace trivet::nonlinear
