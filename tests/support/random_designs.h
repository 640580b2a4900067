// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/numerics/roots/designs.h"

namespace trivet::test {

/// Kind of damping of a random design.
enum class DampingKind { coupled, modal, near_coincident, overdamped, few_dampers, of_stiffness };
inline constexpr int damping_kinds = 6;

/// Systems with ω between 2 and 110 rad/s in random modes, the kinds of damping in turn; damping ratios between `least`
/// and 0.5 (up to 5 if overdamped).
numerics::Designs random_designs(int count, int n, double least, unsigned seed);

}  // namespace trivet::test
