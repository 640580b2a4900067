// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace trivet::foundation {

/// Limits for lengths of machine parts [m]: below 1 nm matter is not a continuum, and above 10 km no machine vibrates
/// as a whole. Fourth powers of such lengths and their products with moduli stay well inside the range of doubles.
inline constexpr double shortest_part = 1e-9, longest_part = 1e4;
inline constexpr const char* part_size_rule = "a length of a part must be between 1 nm and 10 km";

[[nodiscard]] constexpr bool is_part_size(double length) { return length >= shortest_part && length <= longest_part; }

/// Largest accepted ratio of two lengths of one part; laminated bearings and long wires have 1000 or less.
inline constexpr double most_slender = 1e4;

}  // namespace trivet::foundation
