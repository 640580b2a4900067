// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

#include "trivet/nonlinear/laws/deflections.h"
#include "trivet/numerics/periodic/branch.h"

namespace trivet::nonlinear {

/// The nonlinear deflections at rest over the share λ of the static load: δ + G f(δ) = δ_built_in + λ δ_load, with the
/// machine of positive references as the linear one. Forces that are there at δ = 0, of tensioned struts or of gas, are
/// built in.
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

  /// Deflections at the whole load, and the shares at which the load turns before. Built-in forces act from the start;
  /// where that does not lead to the whole load, as of a strut that has buckled without one, they grow with it. Without
  /// a stiffness against the load at first, as of a lamp on a straight wire, the deflections begin to grow alone.
  /// Where no path leads to the whole load, the machine is released under it and comes to rest.
  /// @throws foundation::NotComputable if it is not reached, and the machine does not come to rest
  [[nodiscard]] std::pair<Eigen::VectorXd, std::vector<double>> followed() const;

  /// All positions of rest at the whole load. Of one coordinate: the zeros of its force, between which it is scanned.
  /// Of several: those that Newton's method finds from many starts, combinations of the positions that each deflection
  /// has if the others move as in the linear machine, of two or three coordinates also a grid of places, and from
  /// places between those found. Only those at which all forces are known, in the order of the first deflection.
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
  /// @param missing  deflections of the linear machine that the whole load would add
  void evaluate(const Eigen::VectorXd& deflections, const Eigen::VectorXd& missing,
                numerics::Equations& equations) const;
  struct Followed {
    bool starts = false;
    double highest = 0;  ///< share of the load that is reached
    std::optional<Eigen::VectorXd> deflections;
    std::vector<double> turns;
  };
  /// @param growing     the part of linear_ that grows from zero
  /// @param other_side  at first the load falls
  [[nodiscard]] Followed followed(const Eigen::VectorXd& growing, bool other_side) const;
  /// Without the growing part, and the direction in which the path leaves; empty if there is no such position.
  [[nodiscard]] std::optional<numerics::BranchPoint> start(const Eigen::VectorXd& growing, bool other_side) const;
  [[nodiscard]] Eigen::VectorXd scale(const Eigen::VectorXd& deflections) const;
  /// Newton's method with a line search. @param held  share of the references that holds the machine in addition
  /// @param missing  as in `evaluate`
  [[nodiscard]] std::optional<Eigen::VectorXd> solved(Eigen::VectorXd now, double held,
                                                      const Eigen::VectorXd& missing) const;
  [[nodiscard]] std::optional<Eigen::VectorXd> solved(Eigen::VectorXd now, double held) const;
  /// Where the machine comes to rest if it is released under the whole load and all energy is dissipated: by Newton's
  /// method with positive curvatures, along each step to where the energy is first least.
  [[nodiscard]] std::optional<Eigen::VectorXd> released() const;
  [[nodiscard]] bool is_zero_change(const Eigen::VectorXd& change, const Eigen::VectorXd& of) const;
  /// Positions of rest of a machine whose deflections are all multiples of one number.
  [[nodiscard]] std::optional<std::vector<Eigen::VectorXd>> scanned() const;
  [[nodiscard]] bool is_among(const Eigen::VectorXd& one, const std::vector<Eigen::VectorXd>& found) const;
  void add_between(std::vector<Eigen::VectorXd>& found) const;
  void add_from_grid(std::vector<Eigen::VectorXd>& found) const;
  /// @param start  of Newton's method
  void add(const Eigen::VectorXd& start, std::vector<Eigen::VectorXd>& found) const;
  /// Deflections that the load and forces of the parts cause together.
  struct Forced {
    Eigen::VectorXd deflections, forces;
  };
  /// If no force falls, the position of rest has the least energy. Newton's method with an exact search along each step
  /// finds it across kinks of any stiffness. @param held  as above
  [[nodiscard]] std::optional<Forced> least_energy(Forced now, double held) const;
  [[nodiscard]] bool are_known(const Eigen::VectorXd& deflections) const;  ///< the forces
  /// Positions of one deflection that may begin a search.
  [[nodiscard]] std::vector<double> starts(Eigen::Index deflection) const;

  std::vector<Deflection> deflections_;
  Eigen::MatrixXd stiffness_;                      ///< of the machine of positive references
  Eigen::MatrixXd across_;                         ///< free coordinates × deflections
  Eigen::MatrixXd receptance_;                     ///< deflections × deflections
  Eigen::VectorXd load_;                           ///< on the free coordinates, with built-in forces
  Eigen::VectorXd linear_, of_load_, references_;  ///< of_load_: without built-in forces
  /// Of load and built-in forces, each as if it were alone: what linear_ may be a small difference of.
  Eigen::VectorXd typical_;
  std::optional<DeflectionScales> sizes_;
  bool loaded_ = false;
};

/// Has a stiffness no negative eigenvalue, scaled by the diagonal of a typical one?
[[nodiscard]] bool is_positive(const Eigen::MatrixXd& stiffness, const Eigen::MatrixXd& typical);

}  // namespace trivet::nonlinear
