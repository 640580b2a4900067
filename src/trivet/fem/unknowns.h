// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "trivet/fem/element_kernel.h"

namespace trivet::fem {

/// Numbers of the unknowns of a mesh between rigid plates: three displacements of each free node and, if pressures
/// are continuous, one pressure per corner node and material (the pressure jumps where materials meet).
struct Unknowns {
  static constexpr int on_plate_n = -1, on_plate_k = -2;
  int count = 0;
  int pressure_count = 0;
  std::vector<int> displacement;  ///< per node: number of u_x (u_y, u_z follow), or the plate it is bonded to
  std::vector<std::array<int, 4>> pressure;  ///< per element: numbers of its corner pressures; empty without them
};
[[nodiscard]] Unknowns number_unknowns(const Mesh& mesh, TetPressure tet_pressure);

}  // namespace trivet::fem
