// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

#include "trivet/nonlinear/deflections.h"
#include "trivet/numerics/periodic/branch.h"

namespace trivet::nonlinear {

/// The nonlinear deflections at rest over the share λ of the static load: δ + G f(δ) = λ δ_linear, with the machine of
/// positive references as the linear one.
class LoadPath {
 public:
  /// @throws foundation::NotComputable if the load moves a machine that nothing holds
  explicit LoadPath(const model::System& undeformed);

  /// Does the load deflect the nonlinear parts?
  [[nodiscard]] bool loaded() const { return loaded_; }

  /// The only position of rest of a machine whose forces never fall. A body that is free within a gap falls until it
  /// bears: a share of the references holds it at first, and is then taken away. Empty if forces may fall, or if
  /// Newton's method does not converge.
  [[nodiscard]] std::optional<Eigen::VectorXd> only_one() const;

  /// Deflections at the whole load, and the shares at which the load turns before.
  /// @throws foundation::NotComputable if the whole load is not reached
  [[nodiscard]] std::pair<Eigen::VectorXd, std::vector<double>> followed() const;

  /// All positions of rest at the whole load that Newton's method finds from many starts: combinations of the positions
  /// that each deflection has if the others move as in the linear machine. In the order of the first deflection.
  [[nodiscard]] std::vector<Eigen::VectorXd> all() const;

  /// Is the energy least there? For slow motions; dampers do not matter.
  [[nodiscard]] bool is_stable(const Eigen::VectorXd& deflections) const;

  [[nodiscard]] const std::vector<Deflection>& deflections() const { return deflections_; }

 private:
  struct Forces {
    Eigen::VectorXd force;
    Eigen::MatrixXd tangent;
  };
  /// Of all parts at rest, beyond those of the machine.
  [[nodiscard]] Forces forces(const Eigen::VectorXd& deflections) const;
  void evaluate(const Eigen::VectorXd& deflections, double share, numerics::Equations& equations) const;
  /// Newton's method with a line search. @param held  share of the references that holds the machine in addition
  [[nodiscard]] std::optional<Eigen::VectorXd> solved(Eigen::VectorXd now, double held) const;
  /// Deflections that the load and forces of the parts cause together.
  struct Forced {
    Eigen::VectorXd deflections, forces;
  };
  /// If no force falls, the position of rest has the least energy. Newton's method with an exact search along each step
  /// finds it across kinks of any stiffness. @param held  as above
  [[nodiscard]] std::optional<Forced> least_energy(Forced now, double held) const;
  /// Positions of one deflection that may begin a search.
  [[nodiscard]] std::vector<double> starts(Eigen::Index deflection) const;

  std::vector<Deflection> deflections_;
  Eigen::MatrixXd stiffness_;   ///< of the machine of positive references
  Eigen::MatrixXd across_;      ///< free coordinates × deflections
  Eigen::MatrixXd receptance_;  ///< deflections × deflections
  Eigen::VectorXd linear_, references_;
  bool loaded_ = false;
};

}  // namespace trivet::nonlinear
