// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace trivet::assembly {

/// Ends of bands and speeds that differ by the round-off of their units are the same, relative.
inline constexpr double same_end = 1e-9;

}  // namespace trivet::assembly
