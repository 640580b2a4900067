// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace trivet::fem {

/// Pressure of a tetrahedron: constant and condensed (most stiffnesses converge from below on graded meshes), or linear
/// and continuous (from above). Hexahedra always have their own linear pressure, condensed.
enum class TetPressure { constant, continuous };

}  // namespace trivet::fem
