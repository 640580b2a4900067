// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trivet/elements/rubbing_friction.h"
#include "trivet/nonlinear/law_about.h"

namespace trivet::nonlinear {

/// Friction across a contact over deviations from rest, where it bears no force: beyond the stiffness with which the
/// linear machine sticks there if the contact is pressed at rest.
class RubbingAbout {
 public:
  /// @param contact  forces along the contact, which press it by their size
  /// @param at_rest  deflection along it
  RubbingAbout(elements::RubbingFriction law, const std::vector<elements::ElasticForce>& contact, double at_rest);

  /// The largest friction, μ P.
  struct Limit {
    double value = 0, by_deflection = 0, by_rate = 0;
  };
  /// @param deviation  along the contact, from rest
  [[nodiscard]] Limit limit(double deviation, double rate) const;

  [[nodiscard]] const elements::RubbingFriction& law() const { return law_; }
  [[nodiscard]] bool is_pressed_at_rest() const { return pressed_; }
  /// Of the linear machine in its place.
  [[nodiscard]] double own_stiffness() const { return pressed_ ? law_.stiffness : 0; }

 private:
  elements::RubbingFriction law_;
  LawAbout::Parts contact_;
  double at_rest_;
  bool pressed_;
};

}  // namespace trivet::nonlinear
