// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "trivet/fem/condensation.h"
#include "trivet/fem/mesh.h"
#include "trivet/project/elements/element_table_readers.h"

/// Solids that are meshed and condensed onto their two plates, or taken from the cache of an earlier run.
namespace trivet::project {

/// Mesh, materials and frame of a solid between its plates.
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

/// Reads preload = {compression = …} or {force = …}.
[[nodiscard]] std::optional<Compression> read_compression(TableReader& reader);

/// Of a solid whose force along e3 is computed over large deformations: deflections of K relative to N [m].
struct Stroke {
  double from = 0, to = 0;  ///< from < 0 < to
};

/// Reads nonlinear = true and range = ["-8 mm", "3 mm"].
/// @param rubber  thickness of the rubber along e3 [m]: without a range the stroke is a quarter of it in compression,
/// and
///                a tenth in tension; empty: a range is needed
[[nodiscard]] std::optional<Stroke> read_stroke(TableReader& reader, std::optional<double> rubber);

/// Reads mooney_rivlin = [c10, c01] or yeoh = [c10, c20, c30] in place of the shear modulus of a rubber.
void read_large_strain(TableReader& reader, fem::Material& material);

/// All constants of a material, for the key of the cache.
[[nodiscard]] std::string constants_text(const fem::Material& material);

/// Key of a solid in the cache: from its description and the contents of its files.
[[nodiscard]] std::string solid_key(const std::string& description, const std::vector<std::string>& files = {});

/// Gives the element the stiffness, preloaded or not, of the solid that `make` builds, over a stroke also its force
/// along e3. Returns the distance of the plates in the preloaded state; none without preload or after reporting errors.
[[nodiscard]] ElementLength condensed(TableReader& reader, const std::string& key, const std::function<Solid()>& make,
                                      const std::optional<Compression>& compression,
                                      const std::optional<Stroke>& stroke, model::Element& element);

}  // namespace trivet::project
