// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <variant>

#include "trivet/elements/bouc_wen_branch.h"
#include "trivet/elements/hysteresis.h"

namespace trivet::elements {

/// The force from one turning point to the next.
class HystereticBranch {
 public:
  /// @param start      the force at the turning point
  /// @param direction  of the travel, by its sign; upwards if it is 0
  HystereticBranch(const HystereticForce& law, double start, double direction);

  /// @param travel  in the direction of the branch; against it, where round-off puts a turning point, counts as none
  [[nodiscard]] ForceOnTravel at(double travel) const;
  /// The travel at which the force is not smooth: a slider begins to slip, a Bouc–Wen force changes its sign. Empty if
  /// there is none.
  [[nodiscard]] std::optional<double> kink() const;

 private:
  double sign_, start_;  ///< the force upwards is `sign_` times itself
  std::variant<Slider, BergFriction, BoucWenBranch, CoulombFriction> upwards_;
};

}  // namespace trivet::elements
