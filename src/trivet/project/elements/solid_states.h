// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "trivet/elements/law.h"
#include "trivet/fem/condensation.h"
#include "trivet/fem/mesh.h"
#include "trivet/fem/preload.h"

/// Solids by finite elements, undeformed and loaded, or from the cache of an earlier run.
namespace trivet::project {

/// Mesh, materials and frame of a solid between its plates.
struct Solid {
  fem::Mesh mesh;
  std::optional<fem::Mesh> coarse;  ///< for the error estimate of hexahedra
  double refinement = 1.5;          ///< element sizes of the coarse mesh over those of the fine one
  std::vector<fem::Material> materials;
  fem::ElementFrame frame;
};
/// Meshes it when it is first needed.
using MeshedSolid = std::function<const Solid&()>;

/// Key of a solid in the cache: from its description and the contents of its files.
[[nodiscard]] std::string solid_key(const std::string& description, const std::vector<std::string>& files = {});

/// Undeformed, with the estimated error of its mesh.
[[nodiscard]] fem::SolidStiffness free_solid(const std::string& key, const MeshedSolid& meshed);

/// In equilibrium under a load of its plates.
struct LoadedSolid {
  elements::Matrix12 stiffness = elements::Matrix12::Zero();  ///< about the moved plates
  elements::Vector12 force = elements::Vector12::Zero();      ///< of the plates on it
  double distance = 0;                                        ///< of the plates along e3 [m]
  double deflection = 0;                                      ///< of K along e3 [m]
  int negative_eigenvalues = 0;                               ///< > 0: buckled between its plates
};
/// @return that, or why none is found
[[nodiscard]] std::variant<LoadedSolid, std::string> solid_under(const std::string& key, const MeshedSolid& meshed,
                                                                 const fem::Preload& load, int steps);

}  // namespace trivet::project
