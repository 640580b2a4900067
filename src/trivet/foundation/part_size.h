// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace trivet::foundation {

/// Lengths of the parts of a machine: below a nanometre matter is no continuum, and beyond 10 km nothing vibrates as
/// one machine. Fourth powers of such lengths and products of these with moduli stay far inside double arithmetic. [m]
inline constexpr double shortest_part = 1e-9, longest_part = 1e4;
inline constexpr const char* part_size_rule = "a length of a part lies between 1 nm and 10 km";

[[nodiscard]] constexpr bool is_part_size(double length) { return length >= shortest_part && length <= longest_part; }

/// Largest ratio of two lengths of one part that is computed; laminated bearings and long wires have 1000 and less.
inline constexpr double most_slender = 1e4;

}  // namespace trivet::foundation
