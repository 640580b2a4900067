// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <variant>

#include "trivet/elements/coil_spring.h"
#include "trivet/fem/shapes.h"
#include "trivet/project/text/document.h"
#include "trivet/project/text/table_reader.h"

namespace trivet::project {

/// Rubber between plates, or between the tubes of a bush.
struct RubberForm {
  fem::Shape solid;
  double hole_diameter = 0;  ///< of a disc [m]
};

/// Section of a beam: a round rod if `inner` is 0 and it has no sides, a tube, or a rectangle [m].
struct SectionForm {
  double outer = 0, inner = 0;    ///< diameters
  std::array<double, 2> sides{};  ///< along e1 and e2
};

/// What an element looks like, as far as its law has dimensions.
using ElementShape = std::variant<std::monostate, elements::CoilSpring, RubberForm, SectionForm>;

/// The shape of an element as its table in `Case::document` gives it, for a drawing. Reports nothing: reading the
/// project has.
[[nodiscard]] ElementShape element_shape(const Node& element);

/// Wire, coils, length, ends, hand and start angle of a coil_spring, without its material.
[[nodiscard]] elements::CoilSpring read_coil(TableReader& reader);

}  // namespace trivet::project
