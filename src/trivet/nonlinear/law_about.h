// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "trivet/elements/scalar_law.h"

namespace trivet::nonlinear {

/// Forces over the deviation x from a state, beyond those that the linear machine contains:
/// f(state + x) − f(state) − reference · x.
class LawAbout {
 public:
  // NOLINTNEXTLINE(google-explicit-constructor): laws about the undeformed state
  LawAbout(elements::ScalarLaws laws, double state = 0, double reference = 0)
      : laws_(std::move(laws)),
        state_(state),
        offset_(elements::force_and_tangent(laws_, state).force),
        reference_(reference) {}

  [[nodiscard]] elements::ForceAndTangent at(double deviation) const {
    const elements::ForceAndTangent whole = elements::force_and_tangent(laws_, state_ + deviation);
    return {whole.force - offset_ - reference_ * deviation, whole.tangent - reference_};
  }

  /// Of the whole force, with the reference.
  [[nodiscard]] bool is_monotone() const { return elements::is_monotone(laws_); }
  [[nodiscard]] bool is_piecewise_linear() const { return elements::is_piecewise_linear(laws_); }

  /// Deviations at which the force is not smooth, ascending.
  [[nodiscard]] std::vector<double> kinks() const {
    std::vector<double> found = elements::kinks(laws_);
    for (double& kink : found) kink -= state_;
    return found;
  }

 private:
  elements::ScalarLaws laws_;
  double state_, offset_, reference_;
};

}  // namespace trivet::nonlinear
