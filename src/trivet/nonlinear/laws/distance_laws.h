// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "trivet/elements/distance_force.h"

namespace trivet::nonlinear {

/// A distance force over the deviation from rest and its rate, beyond the stiffness and damping that the linear machine
/// contains in its place: the tangents at rest, or another stiffness.
class DistanceAbout {
 public:
  explicit DistanceAbout(elements::DistanceForce law, const Eigen::Vector3d& at_rest = Eigen::Vector3d::Zero());
  DistanceAbout(elements::DistanceForce law, const Eigen::Vector3d& at_rest, const Eigen::Matrix3d& stiffness);

  [[nodiscard]] elements::SpatialForce at(const Eigen::Vector3d& deviation, const Eigen::Vector3d& rate) const;
  /// ∫ over the deviation from 0, with that stiffness [J].
  [[nodiscard]] double energy(const Eigen::Vector3d& deviation) const;
  [[nodiscard]] double distance(const Eigen::Vector3d& deviation) const { return law_.distance(at_rest_ + deviation); }
  /// Distances for which all forces are known [m].
  [[nodiscard]] std::pair<double, double> range() const;
  /// Distances at which it is not smooth.
  [[nodiscard]] const std::vector<double>& kinks() const { return kinks_; }
  /// The deviation to the same length on the other side, along one axis: where a strut has snapped through.
  [[nodiscard]] double mirrored(Eigen::Index axis) const { return -2 * (law_.offset(axis) + at_rest_(axis)); }
  /// A stop within a ring.
  [[nodiscard]] bool is_ring() const { return law_.across; }
  [[nodiscard]] bool has_dampers() const { return has_dampers_; }
  /// Deviation that brings the points to their farthest kink, or a tenth of their distance if that is more [m].
  [[nodiscard]] double extent() const;

 private:
  elements::DistanceForce law_;
  Eigen::Vector3d at_rest_;
  elements::SpatialForce there_;  ///< by_deflection: the stiffness in the linear machine
  std::vector<double> kinks_;
  bool has_dampers_ = false;
};

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
