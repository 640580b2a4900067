// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "trivet/model/system.h"
#include "trivet/project/elements/element_table_readers.h"
#include "trivet/project/elements/solid_states.h"

namespace trivet::project {

// Forces of solids over large deformations.

/// Of a solid whose force along an axis is computed over large deformations: deflections of K relative to N [m].
struct Stroke {
  double from = 0, to = 0;  ///< from < 0 < to
  int axis = 2;
  bool is_symmetric = false;  ///< the same both ways: half of the states are mirrored
};

/// Reads nonlinear = true and range = ["-8 mm", "3 mm"] of a solid along e3.
/// @param rubber  thickness of the rubber along e3 [m]: without a range the stroke is a quarter of it in compression
///                and a tenth in tension; empty: a range is needed
[[nodiscard]] std::optional<Stroke> read_stroke(TableReader& reader, std::optional<double> rubber);
/// That of a bush along e1, by default a quarter of its wall both ways.
[[nodiscard]] std::optional<Stroke> read_stroke_of_bush(TableReader& reader, double wall);

/// Gives an element whose undeformed stiffness is known the force of its solid over a stroke, and its 12×12 about each
/// state, from finite elements at a few deflections.
void add_stroke(const Stroke& stroke, TableReader& reader, const std::string& key, const MeshedSolid& meshed,
                model::Element& element);

// Solids that are meshed and condensed onto their two plates, or taken from the cache of an earlier run.

/// Axial compression before vibration [m], or the force that causes it [N].
struct Compression {
  double value = 0;
  bool is_force = false;
};

/// Reads preload = {compression = …} or {force = …}.
[[nodiscard]] std::optional<Compression> read_compression(TableReader& reader);

/// Reads mooney_rivlin = [c10, c01] or yeoh = [c10, c20, c30] in place of the shear modulus of a rubber.
void read_large_strain(TableReader& reader, fem::Material& material);

/// All constants of a material, for the key of the cache.
[[nodiscard]] std::string constants_text(const fem::Material& material);

/// Gives the element the stiffness, preloaded or not, of the solid that `make` builds, over a stroke also its force
/// along e3. Returns the distance of the plates in the preloaded state; none without preload or after reporting errors.
[[nodiscard]] ElementLength condensed(TableReader& reader, const std::string& key, const std::function<Solid()>& make,
                                      const std::optional<Compression>& compression,
                                      const std::optional<Stroke>& stroke, model::Element& element);

}  // namespace trivet::project
