// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "trivet/assembly/band.h"
#include "trivet/foundation/interruption.h"
#include "trivet/project/project.h"
#include "trivet/study/map/curve_fractions.h"
#include "trivet/study/map/design_map.h"

namespace trivet::study {

/// Curves of the response of some designs of a map, exact except for rounding: for drawing them without the program.
struct MapCurves {
  std::vector<int> columns, rows;  ///< of the grid of the map, ascending; both ends and the best design are included
  std::vector<std::string> names, units;  ///< of the curves
  assembly::Band band;                    ///< in which they are drawn [rad/s]
  CurveForm form;
  bool real = true;                           ///< all numbers are real
  bool rounded = false;                       ///< the numerators are rounded to 24 bits
  Eigen::MatrixXcd denominators, numerators;  ///< designs × numbers, row by row of the map
  std::vector<char> drawn;                    ///< per design: it has curves
  double worst_error = 0;  ///< of these: largest relative deviation from direct solutions, see `curve_fractions`
  std::string reason;      ///< why there are no curves; else empty

  [[nodiscard]] std::size_t count() const { return columns.size() * rows.size(); }
  /// Index in the map of a design of this grid.
  [[nodiscard]] std::size_t design(std::size_t node, const design::MapGrid& grid) const {
    return grid.index(columns[node % columns.size()], rows[node / columns.size()]);
  }
};

/// Curves of the response that the case requests, else of all coordinates, from poles and residues, of as many designs
/// as `most_bytes` of stored numbers allow, every so many columns and rows. A design whose curves deviate by more than
/// `curves_within` from direct solutions, as with a double pole, has none; there are none at all with elements that
/// depend on frequency. Their band is that of the response, else of the map, else up to 1.3 times the highest natural
/// frequency of the corners, edges and middle of the map.
[[nodiscard]] MapCurves map_curves(const project::Case& variant, const DesignMap& map, double most_bytes,
                                   const foundation::Progress& progress = {});

}  // namespace trivet::study
