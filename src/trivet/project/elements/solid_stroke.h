// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "trivet/model/system.h"
#include "trivet/project/elements/element_table_readers.h"
#include "trivet/project/elements/solid_states.h"

/// Forces of solids over large deformations.
namespace trivet::project {

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

}  // namespace trivet::project
