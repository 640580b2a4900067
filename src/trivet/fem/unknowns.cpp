// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/fem/unknowns.h"

#include <map>

#include "trivet/foundation/index.h"

namespace trivet::fem {

Unknowns number_unknowns(const Mesh& mesh, TetPressure tet_pressure) {
  Unknowns unknowns;
  unknowns.displacement.assign(to_size(mesh.nodes.cols()), 0);
  for (const int node : mesh.plate_n) unknowns.displacement[node] = Unknowns::on_plate_n;
  for (const int node : mesh.plate_k) unknowns.displacement[node] = Unknowns::on_plate_k;
  for (int& number : unknowns.displacement)
    if (number == 0) {
      number = unknowns.count;
      unknowns.count += 3;
    }
  if (mesh.kind != Mesh::Kind::tet10 || tet_pressure != TetPressure::continuous) return unknowns;
  std::map<std::pair<int, int>, int> numbers;  // by node and material
  for (Eigen::Index e = 0; e < mesh.elements.cols(); ++e) {
    auto& corners = unknowns.pressure.emplace_back();
    for (int c = 0; c < 4; ++c) {
      const auto [place, is_new] = numbers.try_emplace({mesh.elements(c, e), mesh.material[e]}, unknowns.count);
      unknowns.count += is_new;
      corners[c] = place->second;
    }
  }
  unknowns.pressure_count = static_cast<int>(numbers.size());
  return unknowns;
}

}  // namespace trivet::fem
