// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

#include "trivet/elements/distance_force.h"
#include "trivet/elements/friction.h"
#include "trivet/nonlinear/laws/deviation_law.h"

namespace trivet::nonlinear {

/// How three deflections press a contact and rub it, at one instant: in a plane the deflection that presses it and the
/// two across; within a ring its own three, of which the third is along its axis.
struct ContactFrame {
  using Rows = Eigen::Matrix<double, 2, 3>;

  double along = 0;                                         ///< deviation from rest that presses it
  Eigen::RowVector3d normal = Eigen::RowVector3d::UnitX();  ///< it by the deflections
  Eigen::Vector2d across = Eigen::Vector2d::Zero();         ///< place on the wall; around a ring on the radius at rest
  Rows on_wall = across_plane();                            ///< it by the deflections
  Rows tangents = across_plane();                           ///< unit directions of the friction
  double hoop = 1;       ///< the friction around a ring over the force that belongs to the travel on its wall
  double curvature = 0;  ///< of the way around a ring [1/m]

  /// The friction of a force over the travel on the wall.
  [[nodiscard]] Eigen::Vector2d friction(const Eigen::Vector2d& on_the_wall) const {
    return {hoop * on_the_wall.x(), on_the_wall.y()};
  }
  [[nodiscard]] double hoop_by_along() const { return -hoop * curvature; }
  /// Forces on the deflections by the deflections, as their direction turns with the contact.
  [[nodiscard]] Eigen::Matrix3d turned(const Eigen::Vector2d& friction) const {
    return -friction.x() * curvature * normal.transpose() * tangents.row(0);
  }

 private:
  static Rows across_plane() {
    Rows rows = Rows::Zero();
    rows.rightCols<2>().setIdentity();
    return rows;
  }
};

/// Of a frame by the phase.
struct FrameRates {
  double along = 0;
  Eigen::RowVector3d normal = Eigen::RowVector3d::Zero();
  Eigen::Vector2d across = Eigen::Vector2d::Zero();
  ContactFrame::Rows on_wall = ContactFrame::Rows::Zero();
};
/// @param slope  of the deflections
[[nodiscard]] FrameRates rates_of(const ContactFrame& frame, const Eigen::Vector3d& slope);

/// Friction across a contact over deviations from rest, where it bears no force: beyond the stiffness with which the
/// linear machine sticks there if the contact is pressed at rest.
class ContactFriction {
 public:
  /// Across an axis.
  /// @param contact  forces along the contact, which press it by their size
  /// @param at_rest  deflection along it
  ContactFriction(elements::RubbingFriction law, const std::vector<elements::ElasticForce>& contact, double at_rest);
  /// Around and along the wall of a ring.
  ContactFriction(elements::RubbingFriction law, const elements::DistanceForce& ring, const Eigen::Vector3d& at_rest);

  /// @param deviations  of the three deflections from rest
  [[nodiscard]] ContactFrame frame(const Eigen::Vector3d& deviations) const;
  /// From one place on the wall to another nearby: around a ring the shorter way.
  [[nodiscard]] Eigen::Vector2d travel(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;

  /// The largest friction, μ P.
  struct Limit {
    double value = 0, by_deflection = 0, by_rate = 0;
  };
  /// @param deviation  along the contact, from rest
  [[nodiscard]] Limit limit(double deviation, double rate) const;

  [[nodiscard]] const elements::RubbingFriction& law() const { return law_; }
  [[nodiscard]] bool is_ring() const { return ring_.has_value(); }
  [[nodiscard]] bool is_pressed_at_rest() const { return pressed_; }
  /// Of the linear machine in its place, of the three deflections.
  [[nodiscard]] Eigen::Matrix3d own_stiffness() const;

 private:
  elements::RubbingFriction law_;
  DeviationLaw::Parts contact_;
  double at_rest_;
  struct Ring {
    Eigen::Vector2d at_rest;  ///< place from the axis
    double radius;            ///< on which the travel around it is counted
  };
  std::optional<Ring> ring_;
  bool pressed_;
};

}  // namespace trivet::nonlinear
