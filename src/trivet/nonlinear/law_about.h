// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "trivet/elements/scalar_law.h"

namespace trivet::nonlinear {

/// Laws over the deviation x from a state and its rate v, beyond the stiffness and damping that the linear machine
/// contains in their place: f(state + x, v) − f(state) − stiffness · x − damping · v.
class LawAbout {
 public:
  // NOLINTNEXTLINE(google-explicit-constructor): laws about the undeformed state
  LawAbout(elements::ScalarLaws laws, double state = 0, elements::SmallMotion reference = {});

  struct Force {
    double force = 0, by_deviation = 0, by_rate = 0;
  };
  /// Of the parts without memory: elastic ones and dampers, with both references.
  [[nodiscard]] Force without_memory(double deviation, double rate) const;
  /// Of all parts in slow motion from the undeformed state.
  [[nodiscard]] elements::ForceAndTangent at_rest(double deviation) const;

  /// ∫ of the elastic parts, with the reference stiffness, over the deviation from 0 [J].
  [[nodiscard]] double energy(double deviation) const;

  struct Hysteretic {
    elements::HystereticForce law;
    double at_state = 0;  ///< its force at the state
  };
  [[nodiscard]] const std::vector<Hysteretic>& hysteretic() const { return hysteretic_; }

  /// Does the force at rest never fall as the deflection grows?
  [[nodiscard]] bool is_monotone() const { return elements::is_monotone(laws_); }
  /// Are all tangents constant between kinks?
  [[nodiscard]] bool is_piecewise_linear() const;
  [[nodiscard]] bool is_empty() const { return laws_.empty(); }
  [[nodiscard]] bool has_dampers() const { return has_dampers_; }

  /// Deviations and rates at which the parts without memory are not smooth, ascending.
  [[nodiscard]] const std::vector<double>& kinks() const { return kinks_; }
  [[nodiscard]] const std::vector<double>& rate_kinks() const { return rate_kinks_; }

  /// Deviations between which no stop is touched; infinite without stops.
  [[nodiscard]] std::pair<double, double> untouched() const;
  /// Deviations for which all forces are known.
  [[nodiscard]] std::pair<double, double> range() const;

 private:
  elements::ScalarLaws laws_;
  std::vector<elements::ElasticForce> elastic_;
  std::vector<elements::DampingForce> dampers_;
  std::vector<Hysteretic> hysteretic_;
  double state_ = 0, offset_ = 0;
  elements::SmallMotion reference_;
  bool has_dampers_;
  std::vector<double> kinks_, rate_kinks_;
};

}  // namespace trivet::nonlinear
