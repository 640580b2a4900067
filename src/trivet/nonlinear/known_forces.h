// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "trivet/nonlinear/harmonic_balance.h"

namespace trivet::nonlinear {

/// The motions over which all forces are known.
class KnownForces {
 public:
  /// `deflections` must outlive it.
  explicit KnownForces(const std::vector<Deflection>& deflections) : deflections_(deflections) {}

  /// May friction without a spring rest?
  [[nodiscard]] bool may_rest() const;

  /// Why a motion is none of them; empty if it is.
  /// @param motion  unknowns of the balance
  /// @param omega   of the first harmonic [rad/s]
  [[nodiscard]] std::string left_by(const HarmonicBalance& balance, const Eigen::VectorXd& motion, double omega) const;

 private:
  [[nodiscard]] std::string out_of_curve(std::size_t deflection, const Eigen::VectorXd& motion) const;
  [[nodiscard]] std::string out_of_distances(std::size_t deflection, const Eigen::MatrixXd& motion) const;
  [[nodiscard]] std::string rests(std::size_t deflection, const LawHarmonics& law, const Eigen::VectorXd& motion,
                                  double omega) const;

  const std::vector<Deflection>& deflections_;
};

}  // namespace trivet::nonlinear
