// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "trivet/documents/json_text.h"
#include "trivet/project/project.h"
#include "trivet/results/scene/drawn_machine.h"

namespace trivet::results {

/// What an element is drawn as.
struct ShownElement {
  std::string kind;                ///< "coil", "rubber", "bush", "beam", … "matrix"
  double length = 0;               ///< between its ends; of a bush its own [m]
  std::optional<double> diameter;  ///< largest outer size across [m]; none: its law has no dimensions
  std::string key;                 ///< of `dimensions`: "coil", "rubber", "section"; empty: it has none
  documents::json::Json dimensions;
};
[[nodiscard]] ShownElement shown_element(const project::Case& variant, std::size_t element);

/// Vertices and triangles of a surface, each as one list of numbers; "triangles_given" if it was coarsened.
/// @param size  of the machine [m]: places are given to 1e-7 of it
[[nodiscard]] documents::json::Json mesh_json(const SolidSurface& surface, double size);

}  // namespace trivet::results
