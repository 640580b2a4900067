// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace trivet::fem {

/// How a tetrahedron carries its pressure: constant and condensed (approaches most stiffnesses from below on graded
/// meshes), or linear and continuous (from above). Hexahedra always carry a linear pressure of their own, condensed.
enum class TetPressure { constant, continuous };

}  // namespace trivet::fem
