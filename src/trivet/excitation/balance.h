// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace trivet::excitation {

/// Permissible residual unbalance m e [kg m] of a rigid rotor: e ω = G. [ISO 21940-11]
/// @param grade_mm_per_s   balance quality grade G > 0, "G 6.3" is 6.3 [mm/s]
/// @param mass             of the rotor [kg] > 0
/// @param angular_speed    highest service speed [rad/s] > 0; m e is the same at lower speeds
/// @throws foundation::InvalidInput for numbers out of range
[[nodiscard]] double permissible_unbalance(double grade_mm_per_s, double mass, double angular_speed);

}  // namespace trivet::excitation
