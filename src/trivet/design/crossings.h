// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
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

/// Pairs of feasible neighbours between which a natural frequency crosses the whole band of the amplitudes and an
/// infeasible design was found.
struct BandCrossings {
  std::size_t pairs = 0;
  std::array<std::size_t, 2> points{};  ///< along x and y: a grid with this many points has an infeasible design
                                        ///< between every such pair; 0 if no pair lies along that axis
};

/// Finds resonances that both designs of a pair miss because the natural frequency is below the band at one and above
/// it at the other. Bisects the edge until the natural frequency is in the band and evaluates the design there: it
/// violates a rule or, with enough damping, does not.
[[nodiscard]] BandCrossings band_crossings(const MapGrid& grid, const std::vector<DesignOutcome>& outcomes,
                                           const JudgePlaces& judge, const foundation::Progress& progress = {});

}  // namespace trivet::design
