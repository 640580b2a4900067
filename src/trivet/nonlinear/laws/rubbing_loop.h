// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <array>
#include <complex>
#include <optional>
#include <vector>

#include "trivet/nonlinear/laws/contact_friction.h"
#include "trivet/numerics/periodic/spatial_motion.h"

namespace trivet::nonlinear {

struct Disc {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double radius = 0;
  double hoop = 1;  ///< of an ellipse: its first axis is the radius over this
};

/// The place that lies deepest within all discs, and its derivatives by the one to three discs that hold it. For
/// ellipses approximate: uses the circles through the point.
struct DeepestPlace {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  double beyond = 0;  ///< the edge of the discs that hold it; > 0: they have no common point, or none was found
  struct Held {
    std::size_t disc = 0;
    Eigen::Matrix2d by_center = Eigen::Matrix2d::Identity();
    Eigen::Vector2d by_radius = Eigen::Vector2d::Zero(), by_hoop = Eigen::Vector2d::Zero();
  };
  std::vector<Held> held;
};
/// @param discs  at least one
[[nodiscard]] DeepestPlace deepest_place(const std::vector<Disc>& discs);

/// The friction across a contact over a periodic motion: after one period it is that before it. Instants at which the
/// contact opens, sticks and slips are found; between them the force is stepped from node to node.
class RubbingLoop {
 public:
  /// @param course   Fourier coefficients × three deflections as ContactFriction has them, deviations from rest
  /// @param corners  phases at which the force along the contact is not smooth, ascending in [0, 2π)
  /// @param omega    of the first harmonic [rad/s]
  /// @param longest  steps of nodes reach over at most this phase
  /// @param rough    every step is twice as long
  RubbingLoop(const ContactFriction& law, const Eigen::MatrixXd& course, const std::vector<double>& corners,
              double omega, double longest, bool rough = false);

  enum class State { open, sticks, slips };
  struct Step : elements::Slip {
    Eigen::Vector2d by_hoop_before = Eigen::Vector2d::Zero();
    /// From a point at which the contact closed and stuck: the travel on the wall over the limit, with which it closes
    /// earlier.
    Eigen::Vector2d travel_by_limit = Eigen::Vector2d::Zero();
  };
  /// Nodes of integrals over a period, and with no weight its start and the ends of the states.
  struct Point {
    double phase = 0, weight = 0;
    Eigen::Vector2d force = Eigen::Vector2d::Zero();  ///< over the travel on the wall
    State state = State::open;                        ///< since the point before
    ContactFriction::Limit limit = {};
    ContactFrame frame = {};
    Eigen::RowVector3d normal_slope = Eigen::RowVector3d::Zero();  ///< of the frame, by the phase
    Step step = {};                                                ///< from the point before
  };
  /// Empty if the contact never closes.
  [[nodiscard]] const std::vector<Point>& points() const { return points_; }
  [[nodiscard]] const ContactFriction& law() const { return law_; }
  /// Does it stick all the time? Its mean is then undetermined; we choose the one with the largest reserve against
  /// slip, so that slip begins without a jump.
  [[nodiscard]] bool always_sticks() const { return always_sticks_; }

  /// At a phase. A variation of the friction f is that of sticking; or under slip `direction` times that of the limit L
  /// and, square to it, y with y' = aside · (k δ(speed of the travel) − δ(ρ'/ρ) (f_t, 0)) − fading y − turning δL.
  struct Moment {
    State state = State::open;
    ContactFriction::Limit limit = {};
    ContactFrame frame = {};
    FrameRates rates = {};
    Eigen::Vector2d friction = Eigen::Vector2d::Zero();
    Eigen::Vector2d direction = Eigen::Vector2d::Zero();  ///< of the friction under slip
    double fading = 0, turning = 0;                       ///< by the phase; turning: of the direction, to the left
  };
  [[nodiscard]] Moment moment(double phase) const;
  /// Where its state changes; the direction of the friction is the same on both sides.
  struct Change {
    double phase = 0;  ///< in [0, 2π)
    State before = State::open, after = State::open;
    ContactFriction::Limit limit = {};
    ContactFrame frame = {};
    FrameRates rates = {};
    Eigen::Vector2d friction = Eigen::Vector2d::Zero();
    Eigen::Vector2d travel_by_limit = Eigen::Vector2d::Zero();  ///< as of the next step
  };
  [[nodiscard]] std::vector<Change> changes() const;
  [[nodiscard]] Eigen::Vector3d force(double phase) const;  ///< on the three deflections
  [[nodiscard]] State state_at(double phase) const { return moment(phase).state; }

  /// Variations at the points, points × columns each; without any entry: none.
  template <typename Scalar>
  struct Variation {
    using Columns = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
    Columns limit;                  ///< largest friction
    std::array<Columns, 2> across;  ///< places on the wall
    Columns hoop;                   ///< friction around a ring over the force over the travel
  };
  /// Variations of the two forces over the travel on the wall by those that are periodic, or of which each period is
  /// `turned` times the one before. The latter leave the place where it sticks all the time as it is.
  template <typename Scalar>
  using Forces = std::array<Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>, 2>;
  template <typename Scalar>
  [[nodiscard]] Forces<Scalar> variation(const Variation<Scalar>& by,
                                         std::optional<Scalar> turned = std::nullopt) const;

 private:
  struct Here {
    ContactFrame frame;
    FrameRates rates;
    ContactFriction::Limit limit;
    double limit_slope;  ///< by the phase
  };
  [[nodiscard]] Here at(double phase) const;
  [[nodiscard]] Eigen::Vector2d travel(const Point& from, const Here& to) const {
    return law_.travel(from.frame.across, to.frame.across);
  }
  /// Of the friction while the contact sticks, by the phase.
  [[nodiscard]] Eigen::Vector2d pull(const Here& here, const Eigen::Vector2d& friction) const;
  /// From a point under slip.
  [[nodiscard]] Step slip(const Point& from, const Here& to) const;
  /// Index of the first point after a phase, which is brought between the first and the last point.
  [[nodiscard]] std::size_t point_after(double& phase) const;
  [[nodiscard]] bool goes_round() const;
  [[nodiscard]] std::vector<double> with_losses_of_pressure(const std::vector<double>& ends) const;
  [[nodiscard]] double step_of_stiffness(const std::vector<double>& ends) const;
  [[nodiscard]] bool settles(double start, const std::vector<double>& ends, double longest);
  void close(double start, const std::vector<double>& ends, double longest);
  void begin(double start, const Eigen::Vector2d& force);
  void march(const std::vector<double>& ends, double longest);
  void rub(double from, double to, double longest);
  [[nodiscard]] bool slips_from(double from, double to) const;
  [[nodiscard]] bool has_changed(double phase, bool slips) const;
  [[nodiscard]] double first_change(double from, double to, bool slips) const;
  void append_nodes(double from, double to, double longest, bool slips);
  void append(double phase, double weight, bool slips);
  [[nodiscard]] Eigen::Matrix2d kept() const;  ///< force after a period by that before it

  ContactFriction law_;
  numerics::SpatialMotion motion_;
  double omega_;
  int parts_;  ///< of each long step
  std::vector<Point> points_;
  bool always_sticks_ = false, opens_ = false;
  DeepestPlace place_;  ///< of the springs, if it always sticks; held by points
};

extern template RubbingLoop::Forces<double> RubbingLoop::variation(const Variation<double>&,
                                                                   std::optional<double>) const;
extern template RubbingLoop::Forces<std::complex<double>> RubbingLoop::variation(
    const Variation<std::complex<double>>&, std::optional<std::complex<double>>) const;

/// Forces × the three deflections of a contact (ContactFriction); without any entry: none.
template <typename Entry>
using OfContact = std::array<std::array<Entry, 3>, 3>;

/// Fourier coefficients of the friction on the three deflections of a contact, beyond the stiffness of the linear
/// machine, and their derivatives.
struct RubbingHarmonics {
  Eigen::MatrixXd force, by_omega;  ///< coefficients × 3
  OfContact<Eigen::MatrixXd> tangent = {};
};
/// @param course  that of the loop
[[nodiscard]] RubbingHarmonics rubbing_harmonics(const RubbingLoop& loop, const Eigen::MatrixXd& course, double omega,
                                                 bool with_tangent);

/// The forces at the frequencies μ + k, k = −K … K, by variations e^{i(μ + l)φ} of the deflections.
using RubbingVariation = OfContact<Eigen::MatrixXcd>;
[[nodiscard]] RubbingVariation rubbing_variation(const RubbingLoop& loop, double omega, double mu,
                                                 Eigen::Index harmonics);

}  // namespace trivet::nonlinear
