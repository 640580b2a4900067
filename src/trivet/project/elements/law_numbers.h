// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "trivet/elements/knot_curve.h"
#include "trivet/project/text/table_reader.h"

namespace trivet::project {

/// A number > 0 that must be there.
[[nodiscard]] double read_positive(TableReader& reader, const char* key, Quantity quantity);

[[nodiscard]] Quantity force_quantity(bool is_rotation);
[[nodiscard]] Quantity travel_quantity(bool is_rotation);
[[nodiscard]] Quantity velocity_quantity(bool is_rotation);
[[nodiscard]] Quantity stiffness_quantity(bool is_rotation);

struct CurvePoints {
  std::vector<double> x, y;  ///< x ascending
};

/// `rows` of a curve through (0, 0), or `file` with these columns. Empty with problems.
[[nodiscard]] std::optional<CurvePoints> read_curve_points(TableReader& reader, const char* x_column,
                                                           const char* y_column, Quantity x, Quantity y);
/// `interpolation`: between the points.
[[nodiscard]] elements::Interpolation read_interpolation(TableReader& reader);

}  // namespace trivet::project
