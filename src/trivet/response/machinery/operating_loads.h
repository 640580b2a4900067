// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "trivet/response/machinery/run_up.h"
#include "trivet/response/machinery/transmissibility.h"

namespace trivet::response {

/// All excitation that runs with the machine (model::runs_with_machine), or that of those named, by order of its speed:
/// forces of orders, and at order 1 unbalances and harmonic forces. A motion of the ground is of order 1 if it is
/// named. Orders without a load are left out.
/// @throws foundation::InvalidInput for a name that is neither a harmonic nor an order excitation
[[nodiscard]] std::vector<OrderLoading> operating_loads(const model::System& system,
                                                        const assembly::Assembled& assembled,
                                                        const std::vector<std::string>& selected = {});

/// The force of one excitation in one order, and how much of it reaches the ground.
struct OperatingForce {
  std::string excitation;
  double order = 0;
  std::string reason = {};  ///< why it has no transmissibility; empty: it has one
  ExcitationTransmission transmission = {{assembly::Loading(Eigen::VectorXd()), {}}, {}};  ///< over ω = order · Ω
  int power_of_speed = 0;  ///< the exciting force is that of the transmission times Ω to this power
  bool rotation = false;   ///< it is a moment

  /// Magnitude of the exciting force [N] or moment [N m] at Ω.
  [[nodiscard]] double exciting(double speed) const;
};

/// Forces on bodies that run with the machine, or those named, over speeds from … to; equal ends: one speed.
[[nodiscard]] std::vector<OperatingForce> operating_forces(const model::System& system,
                                                           const assembly::Assembled& assembled,
                                                           const assembly::Band& speeds,
                                                           const std::vector<std::string>& selected = {});

}  // namespace trivet::response
