// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "trivet/nonlinear/balance/harmonic_balance.h"

namespace trivet::nonlinear {

/// The motions over which all forces are known.
class ForceDomain {
 public:
  /// `deflections` must outlive it.
  explicit ForceDomain(const std::vector<Deflection>& deflections) : deflections_(deflections) {}

  [[nodiscard]] const std::vector<Deflection>& deflections() const { return deflections_; }

  /// Where no motion is found: "; friction …", or nothing.
  [[nodiscard]] std::string hint() const;

  /// Why not all forces are known over a motion; empty if they are.
  /// @param omega  of the first harmonic [rad/s]
  [[nodiscard]] std::string reason_unknown(const HarmonicBalance& balance, const Eigen::VectorXd& unknowns,
                                           double omega) const;

 private:
  [[nodiscard]] std::string out_of_curve(std::size_t deflection, const Eigen::VectorXd& motion) const;
  [[nodiscard]] std::string out_of_distances(std::size_t deflection, const Eigen::MatrixXd& motion) const;
  struct Turn;
  [[nodiscard]] std::string add_turns(std::size_t deflection, const LawSet& laws, const Eigen::MatrixXd& motions,
                                      double omega, std::vector<Turn>& turns) const;
  [[nodiscard]] std::string rests_at_turn(const std::vector<Turn>& turns, std::size_t at) const;

  const std::vector<Deflection>& deflections_;
};

}  // namespace trivet::nonlinear
