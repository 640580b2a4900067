// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/elements/rubber_mounts.h"
#include "trivet/fem/shapes.h"
#include "trivet/project/text/table_reader.h"

namespace trivet::project {

/// A parametric rubber mount, for closed formulas and for finite elements.
struct RubberShape {
  std::variant<elements::RubberDisc, elements::RubberBlock, elements::RubberBush, elements::Sandwich> formulas;
  fem::Shape solid;
  std::vector<fem::Material> materials;  ///< rubber, then the metal of a sandwich's plates
  double length = 0;                     ///< from N to K [m]
};

/// Dimensions and material of `kind` ("disc", "block", "bush", "sandwich"); none after reporting errors.
[[nodiscard]] std::optional<RubberShape> read_rubber_shape(TableReader& reader, const std::string& kind);

/// Keys of the file for the names in the checks of the formulas.
[[nodiscard]] const TableReader::Names& shape_keys();
[[nodiscard]] foundation::Problems check(const RubberShape& shape);
[[nodiscard]] elements::Matrix12 stiffness_by_formulas(const RubberShape& shape);

}  // namespace trivet::project
