// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

#include "trivet/nonlinear/laws/deflections.h"
#include "trivet/nonlinear/laws/distance_laws.h"
#include "trivet/nonlinear/laws/law_harmonics.h"
#include "trivet/nonlinear/laws/rubbing_loop.h"

namespace trivet::nonlinear {

/// Forces of all nonlinear parts over a periodic motion.
struct CoupledForces {
  Eigen::MatrixXd force, by_omega;  ///< coefficients × deflections
  struct Tangent {
    Eigen::Index of, by;     ///< force and deflection
    Eigen::MatrixXd matrix;  ///< coefficients × coefficients
  };
  std::vector<Tangent> tangents;
};

/// The laws of all nonlinear parts: over one deflection each, over the three of a distance, and of friction across
/// contacts.
class LawSet {
 public:
  /// @param sizes      what motions of deflections are compared with: smaller ones are round-off (`round_off`)
  /// @param of_motion  harmonics of the motions, which are padded with zeros
  LawSet(const std::vector<Deflection>& deflections, DeflectionScales sizes, Eigen::Index harmonics,
         Eigen::Index of_motion);

  /// @param course  Fourier coefficients × deflections
  /// @param omega   of the first harmonic [rad/s]
  [[nodiscard]] CoupledForces at(const Eigen::MatrixXd& course, double omega) const;
  [[nodiscard]] Eigen::MatrixXd forces(const Eigen::MatrixXd& course, double omega) const;

  [[nodiscard]] const std::vector<LawHarmonics>& single() const { return single_; }
  [[nodiscard]] const DeflectionScales& sizes() const { return sizes_; }
  /// Amplitudes below which deflections rest: those of round-off beside the motions of the others. In a symmetric
  /// machine forces on opposite sides cancel, and what is left of them must not move friction.
  /// @param course  Fourier coefficients × deflections
  [[nodiscard]] Eigen::VectorXd round_off(const Eigen::MatrixXd& course) const;
  /// Of the laws over one deflection in the motion of all.
  [[nodiscard]] LawOverPeriod course(Eigen::Index deflection, const Eigen::MatrixXd& course, double omega) const;
  struct Distance {
    Eigen::Index first;  ///< of its three deflections
    DistanceHarmonics law;
  };
  [[nodiscard]] const std::vector<Distance>& distances() const { return distances_; }
  struct Rubbing {
    std::array<Eigen::Index, 3> on;  ///< its three deflections (ContactFriction)
    ContactFriction law;
  };
  [[nodiscard]] const std::vector<Rubbing>& rubbings() const { return rubbings_; }
  /// @param course  Fourier coefficients × deflections
  [[nodiscard]] RubbingLoop loop(const Rubbing& one, const Eigen::MatrixXd& course, double omega) const {
    return loop(one, course, omega, {});
  }

 private:
  struct Steps {
    double fewest = 64;  ///< in a period
    bool rough = false;
  };
  [[nodiscard]] RubbingLoop loop(const Rubbing& one, const Eigen::MatrixXd& course, double omega,
                                 const Steps& steps) const;
  [[nodiscard]] RubbingHarmonics friction(const Rubbing& one, const Eigen::MatrixXd& course, double omega,
                                          bool with_tangent) const;

  DeflectionScales sizes_;
  std::vector<LawHarmonics> single_;  ///< one per deflection, some without any law
  std::vector<Distance> distances_;
  std::vector<Rubbing> rubbings_;
};

/// What the harmonics of the forces of nonlinear parts leave out over a period: the laws themselves along the
/// deflections, less their harmonics. A stop that is touched briefly has most of its force there.
class ForceRemainder {
 public:
  /// `laws` must outlive it.
  /// @param course     Fourier coefficients × deflections
  /// @param harmonics  of the forces, coefficients × deflections
  /// @param omega      of the first harmonic [rad/s]
  ForceRemainder(const LawSet& laws, const Eigen::MatrixXd& course, const Eigen::MatrixXd& harmonics, double omega);

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
    LawOverPeriod course;
  };
  std::vector<Single> singles_;
  std::vector<const LawSet::Distance*> distances_;
  struct Rubbing {
    std::array<Eigen::Index, 3> on;
    RubbingLoop loop;
  };
  std::vector<Rubbing> rubbings_;
  std::vector<bool> known_;  ///< deflections whose remainder is computed; that of the others is zero
  std::vector<double> phases_;
};

}  // namespace trivet::nonlinear
