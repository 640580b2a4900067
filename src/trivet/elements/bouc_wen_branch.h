// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>

#include "trivet/elements/hysteresis.h"
#include "trivet/elements/saturation.h"

namespace trivet::elements {

/// A Bouc–Wen force upwards from a turning point. It falls to zero with dz/du = 1 + (β − γ) |z|ⁿ and grows beyond with
/// 1 − (β + γ + 2φ) zⁿ, u in units of F/k.
class BoucWenBranch {
 public:
  BoucWenBranch(const BoucWen& law, double start);

  /// @param travel  ≥ 0
  [[nodiscard]] ForceOnTravel at(double travel) const;
  /// The travel at which the force changes its sign, if it does.
  [[nodiscard]] std::optional<double> to_zero() const;

 private:
  /// Of |z| on the way to zero, if γ > β: such a loop feeds energy.
  [[nodiscard]] double limit_against() const;

  std::shared_ptr<const Saturation> grows_;
  double stiffness_, force_, exponent_;
  double against_;  ///< β − γ
  double limit_;    ///< of z
  double from_;     ///< z at the start
  double rate_at_start_;
  double offset_;  ///< travel from z = 0 to the start
};

/// Limit of z upwards.
[[nodiscard]] double z_limit(const BoucWen& law);
[[nodiscard]] BoucWen mirrored(BoucWen law);

}  // namespace trivet::elements
