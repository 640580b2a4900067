// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "trivet/fem/condensation.h"
#include "trivet/fem/mesh.h"
#include "trivet/project/elements/element_parts.h"

/// Solids that are meshed and condensed onto their two plates, or remembered from an earlier run.
namespace trivet::project {

/// A solid between its plates, whatever it was made from.
struct Solid {
  fem::Mesh mesh;
  std::optional<fem::Mesh> coarse;  ///< for the error estimate of hexahedra
  double refinement = 1.5;          ///< element sizes of the coarse mesh over those of the fine one
  std::vector<fem::Material> materials;
  fem::ElementFrame frame;
};

/// Axial compression before vibration [m], or the force that causes it [N].
struct Compression {
  double value = 0;
  bool is_force = false;
};

/// preload = {compression = …} or {force = …}.
[[nodiscard]] std::optional<Compression> read_compression(TableReader& reader);

/// mooney_rivlin = [c10, c01] or yeoh = [c10, c20, c30] in place of the shear modulus of a rubber.
void read_large_strain(TableReader& reader, fem::Material& material);

/// All that distinguishes a material, for the key of what is remembered.
[[nodiscard]] std::string words(const fem::Material& material);

/// Key of a solid among what is remembered: its description in words, and the files it comes from.
[[nodiscard]] std::string solid_key(const std::string& description, const std::vector<std::string>& files = {});

/// Stiffness, preloaded or not, of the solid that `make` builds. Returns the distance of the plates in the preloaded
/// state; nothing without preload, or after reporting why there is none.
[[nodiscard]] LengthOf condensed(TableReader& reader, const std::string& key, const std::function<Solid()>& make,
                                 const std::optional<Compression>& compression, model::Element& element);

}  // namespace trivet::project
