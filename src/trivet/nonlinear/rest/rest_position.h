// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <utility>
#include <vector>

#include "trivet/model/system.h"

namespace trivet::nonlinear {

/// The position of rest of a machine with nonlinear parts, under gravity, preloads and constant forces: K q + W f(δ) =
/// Q, δ = Wᵀ q. It is the one that is reached when the load grows from zero.
struct RestPosition {
  model::System system;             ///< the machine, linear about this position (Law::nonlinear)
  std::vector<double> limit_loads;  ///< shares of the load at which it snaps through on the way, ascending
  bool stable = true;               ///< the energy is least there
};

/// One of several positions of rest.
struct RestState {
  std::vector<std::pair<std::string, double>> deflections;  ///< names and values of all nonlinear ones [m, rad]
  bool stable = true;
};
/// All positions of rest that a search from many starts finds.
[[nodiscard]] std::vector<RestState> rest_states(const model::System& system);

/// From the position of rest of a machine to all others that the search finds: changes of its deflections, in the order
/// of ReferenceMachine::deflections.
[[nodiscard]] std::vector<Eigen::VectorXd> to_other_positions_of_rest(const model::System& system);

/// "mount: tangent stiffness 1.061e+06 N/m along z at rest, at a deflection of -0.002845 m", for every nonlinear part,
/// after a sentence that analyses are linear about rest; empty for a linear machine.
[[nodiscard]] std::vector<std::string> notes_about_rest(const model::System& system);

/// @throws foundation::NotComputable if there is none within reach
[[nodiscard]] RestPosition rest_position(const model::System& system);

}  // namespace trivet::nonlinear
