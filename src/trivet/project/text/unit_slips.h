// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "trivet/project/text/units.h"

namespace trivet::project {

/// What to do about a text that is no number of this quantity: "did you mean \"980 rpm\"?", the key `quantity` that
/// makes a velocity of a displacement, or the units to choose from.
/// @param where  path of the number: only motions of the ground and limit lines have that key
[[nodiscard]] std::string unit_remedy(std::string_view text, Quantity quantity, std::string_view where);

/// "give a number in N/m, or a text with a unit that converts to N/m"; of a frequency only a text: bare ones in rad/s
/// are read, and warned of.
[[nodiscard]] std::string number_remedy(Quantity quantity);

/// "add quantity = \"velocity\" if velocities are meant, or " for a text that is another motion than the expected one;
/// otherwise empty. @param density  the text is a spectral density
[[nodiscard]] std::string other_motion_advice(std::string_view text, Quantity quantity, std::string_view where,
                                              bool density = false);

}  // namespace trivet::project
