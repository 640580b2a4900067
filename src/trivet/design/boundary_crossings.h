// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "trivet/design/design_outcome.h"
#include "trivet/design/map_contours.h"
#include "trivet/foundation/interruption.h"

namespace trivet::design {

inline constexpr double boundary_tolerance = 1e-6;  ///< of each axis

/// The place at the share `t` of an edge.
[[nodiscard]] MapPlace place_on_edge(const MapGrid& grid, const CrossedEdge& edge, double t);

/// A signed measure that is zero on the boundary of the feasible designs; strongly negative for designs without a
/// model.
[[nodiscard]] double boundary_level(const DesignOutcome& outcome);

/// Returns the outcomes of the designs at places on the map.
using JudgePlaces = std::function<std::vector<DesignOutcome>(const std::vector<MapPlace>& places,
                                                             const foundation::Progress& progress)>;

/// Position at which the boundary crosses each edge, as a share of the edge: by regula falsi and bisection, all edges
/// together.
/// @param outcomes  at the nodes
[[nodiscard]] std::vector<double> boundary_crossings(const MapGrid& grid, const std::vector<DesignOutcome>& outcomes,
                                                     const std::vector<CrossedEdge>& edges, const JudgePlaces& judge,
                                                     const foundation::Progress& progress = {});

}  // namespace trivet::design
