// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/nonlinear/balance/force_domain.h"
#include "trivet/nonlinear/balance/steady_equations.h"
#include "trivet/nonlinear/branch/followed_motions.h"
#include "trivet/numerics/periodic/branch.h"

namespace trivet::nonlinear {

/// The motions of harmonic balance with a fixed number of harmonics, from the lower end of the band through all folds.
class SteadyPath {
 public:
  /// All but the excitation must outlive it.
  /// @throws foundation::NotComputable if no excitation moves a nonlinear part
  SteadyPath(const CondensedMachine& machine, const std::vector<Deflection>& deflections,
             const PeriodicExcitation& excitation, const SteadyOptions& options, Eigen::Index harmonics);
  SteadyPath(const SteadyPath&) = delete;  // its motions refer to its branch
  SteadyPath& operator=(const SteadyPath&) = delete;
  ~SteadyPath() = default;

  struct Known {
    Eigen::MatrixXd motion;  ///< Fourier coefficients × deflections
    double parameter = 0;
  };
  /// Follows them; if there is none at the lower end, through the first one that is found above it, to both sides.
  /// @param known  a motion of fewer harmonics, sought before the longer ways to one; null: none
  /// @return false, and an unfinished path, as soon as a motion leaves out more than the share given
  /// @throws foundation::NotComputable if there is no motion at the lower end, nor at several places above it
  [[nodiscard]] bool follow(double most_left_out, const Known* known, const foundation::Progress& progress);
  /// Its first motion: for more harmonics.
  [[nodiscard]] Known known() const;

  /// Did the curve from the lower end of the band return there, so that motions above it lie on another one?
  [[nodiscard]] bool returned() const { return returned_; }
  /// Then: the curve through the first motion above the lower end that is not on that path; no points if there is none.
  /// @return as follow()
  [[nodiscard]] bool follow_above(const SteadyPath& returned, double most_left_out,
                                  const foundation::Progress& progress);
  static constexpr int places_above = 24;  ///< where motions are sought

  /// Instead: a curve of motions through one that is not on another path, until it closes or leaves the band.
  void follow_detached(const numerics::BranchPoint& start, const foundation::Progress& progress);
  [[nodiscard]] bool closed() const { return closed_; }

  /// Or: the curve that crosses another one at such a place, until it comes to one of the ends or leaves the band.
  /// @param along  direction of the other curve (BranchPoint::tangent), if that lies in the same unknowns
  /// @return false if none was found
  [[nodiscard]] bool follow_branched(const SteadyEquations::Place& start, const Eigen::VectorXd& along,
                                     const std::vector<SteadyEquations::Place>& ends,
                                     const foundation::Progress& progress);
  /// Adds the motion in the middle of the step after a point, in which the parameter must not turn.
  /// @return false if it is not found
  [[nodiscard]] bool split_step(std::size_t after) { return motions_.split_step(after); }

  /// The end that it came to.
  [[nodiscard]] std::optional<std::size_t> stopped_at() const { return stopped_at_; }

  /// The motion that Newton's method finds from a guess; empty if it does not converge, or if not all forces are known.
  [[nodiscard]] std::optional<numerics::BranchPoint> motion_near(const Eigen::VectorXd& guess, double parameter) const {
    std::optional<numerics::BranchPoint> found = branch_.start(guess, parameter);
    return found && unknown_forces(*found).empty() ? found : std::nullopt;
  }
  /// Those with known forces.
  [[nodiscard]] std::vector<numerics::BranchPoint> motions_over_load(double parameter, double most_load) const;

  [[nodiscard]] const FollowedMotions& motions() const { return motions_; }
  [[nodiscard]] const std::string& ended() const { return ended_; }
  /// Where it was begun, if not at the lower end.
  [[nodiscard]] std::optional<double> begun_at() const { return begun_at_; }
  [[nodiscard]] double left_out() const { return left_out_; }
  [[nodiscard]] double held_share() const { return held_share_; }

  [[nodiscard]] const SteadyEquations& equations() const { return equations_; }
  [[nodiscard]] const HarmonicBalance& balance() const { return equations_.balance(); }
  [[nodiscard]] Driving driving(double parameter) const { return equations_.driving(parameter); }

 private:
  [[nodiscard]] std::string task() const;  ///< as progress names it
  /// How much has been found.
  struct Extent {
    FollowedMotions::Extent motions;
    double left_out, held_share;  ///< largest so far
  };
  [[nodiscard]] const std::vector<numerics::BranchPoint>& points() const { return motions_.points(); }
  void limit_points_of_further_curve();
  [[nodiscard]] bool grows_without_limit(const numerics::BranchPoint& next) const;
  /// @param except  motions on this path do not count; null: all count
  [[nodiscard]] std::optional<numerics::BranchPoint> motion_at_lower_end(const Known* known) const;
  [[nodiscard]] std::optional<numerics::BranchPoint> near(const Known& known) const;
  [[nodiscard]] std::optional<numerics::BranchPoint> lowest_motion(const SteadyPath* except) const;
  [[nodiscard]] bool follow_through(const numerics::BranchPoint& start, double most_left_out,
                                    const foundation::Progress& progress);
  /// @param ends  places to stop at
  [[nodiscard]] bool walk(double most_left_out, const std::vector<SteadyEquations::Place>& ends,
                          const foundation::Progress& progress);
  [[nodiscard]] std::optional<std::size_t> passed(const std::vector<SteadyEquations::Place>& ends,
                                                  const numerics::BranchPoint& next, double length) const;
  [[nodiscard]] std::optional<double> returns_to_one_period(const numerics::BranchPoint& next) const;
  [[nodiscard]] std::optional<std::vector<numerics::BranchPoint>> between(const numerics::BranchPoint& now,
                                                                          const numerics::BranchPoint& next) const;
  [[nodiscard]] bool add_step(const numerics::BranchPoint& next, double length, double most_left_out);
  [[nodiscard]] bool begin(const numerics::BranchPoint& first, double most_left_out);
  [[nodiscard]] bool note_left_out(const numerics::BranchPoint& point, double most);
  [[nodiscard]] Extent extent() const { return {motions_.extent(), left_out_, held_share_}; }
  void cut_to(const Extent& end);
  [[nodiscard]] std::string no_further(const numerics::BranchPoint& point) const;
  [[nodiscard]] std::string unknown_forces(const numerics::BranchPoint& point) const;

  const SteadyOptions& options_;
  std::vector<double> resonances_;  ///< of the machine of references, ascending [rad/s]
  SteadyEquations equations_;
  ForceDomain known_;
  numerics::Branch branch_;
  FollowedMotions motions_;
  double left_out_ = 0, held_share_ = 0;
  std::string ended_;
  bool leaves_downwards_ = false;  ///< is the lower end of the band an end of the curve, not its start?
  bool returned_ = false;
  bool closed_ = false;
  std::optional<double> begun_at_;
  std::optional<Known> first_;
  Eigen::Index most_points_;
  std::optional<std::size_t> stopped_at_;
};

}  // namespace trivet::nonlinear
