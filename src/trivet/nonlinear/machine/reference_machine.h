// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/assembly/assembled.h"
#include "trivet/model/system.h"
#include "trivet/nonlinear/laws/deflections.h"
#include "trivet/nonlinear/machine/condensed_machine.h"
#include "trivet/nonlinear/machine/periodic_excitation.h"

namespace trivet::nonlinear {

/// The machine with references in place of its nonlinear parts, the parts beyond them, and its periodic excitation.
struct ReferenceMachine {
  /// @param without_law  a displacement that is followed as if it were nonlinear; empty: none
  ReferenceMachine(const model::System& given, const References& references,
                   const std::vector<std::string>& excitations, const std::string& without_law = "");
  ReferenceMachine(const ReferenceMachine&) = delete;
  ReferenceMachine& operator=(const ReferenceMachine&) = delete;
  /// The same for motions that repeat after two periods of the excitation: its harmonic k is their harmonic 2k.
  struct TwoPeriods {};
  ReferenceMachine(const ReferenceMachine& same, TwoPeriods);

  model::System system;
  assembly::Assembled assembled;
  std::vector<Deflection> deflections;
  PeriodicExcitation excitation;
  CondensedMachine condensed;
};

/// What tangents at rest do for a machine.
struct HoldAtRest {
  bool holds = false;       ///< they hold all bodies
  bool conditions = false;  ///< and so well that round-off does not decide how far
};
[[nodiscard]] HoldAtRest hold_at_rest(const model::System& given);

/// Do tangents at rest hold all bodies in static results, which have no second-order effect of the weight?
[[nodiscard]] bool holds_static_load(const model::System& given);

/// Tangents at rest, or what keeps the receptance of a machine finite that they do not hold or damp.
[[nodiscard]] References references_of(const model::System& given, const HoldAtRest& hold);

}  // namespace trivet::nonlinear
