// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "trivet/elements/distance_force.h"
#include "trivet/elements/rubbing_friction.h"
#include "trivet/nonlinear/laws/contact_frame.h"
#include "trivet/nonlinear/laws/law_about.h"

namespace trivet::nonlinear {

/// Friction across a contact over deviations from rest, where it bears no force: beyond the stiffness with which the
/// linear machine sticks there if the contact is pressed at rest.
class RubbingAbout {
 public:
  /// Across an axis.
  /// @param contact  forces along the contact, which press it by their size
  /// @param at_rest  deflection along it
  RubbingAbout(elements::RubbingFriction law, const std::vector<elements::ElasticForce>& contact, double at_rest);
  /// Around and along the wall of a ring.
  RubbingAbout(elements::RubbingFriction law, const elements::DistanceForce& ring, const Eigen::Vector3d& at_rest);

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
  LawAbout::Parts contact_;
  double at_rest_;
  struct Ring {
    Eigen::Vector2d at_rest;  ///< place from the axis
    double radius;            ///< on which the travel around it is counted
  };
  std::optional<Ring> ring_;
  bool pressed_;
};

}  // namespace trivet::nonlinear
