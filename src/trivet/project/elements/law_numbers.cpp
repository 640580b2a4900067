// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/elements/law_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/project/text/pairs_reader.h"

namespace trivet::project {

double read_positive(TableReader& reader, const char* key, Quantity quantity) {
  const std::size_t before = reader.errors();
  const double value = reader.required_number(key, quantity);
  if (reader.errors() == before && !(value > 0))
    reader.error(key,
                 fmt::format("{:.6g}{}{}", value, quantity == Quantity::pure ? "" : " ", printed_si_unit(quantity)),
                 "it is > 0", "correct it");
  return value;
}

Quantity force_quantity(bool is_rotation) { return is_rotation ? Quantity::moment : Quantity::force; }
Quantity travel_quantity(bool is_rotation) { return is_rotation ? Quantity::angle : Quantity::length; }
Quantity velocity_quantity(bool is_rotation) { return is_rotation ? Quantity::angular_velocity : Quantity::velocity; }
Quantity stiffness_quantity(bool is_rotation) {
  return is_rotation ? Quantity::moment_per_angle : Quantity::force_per_length;
}

std::optional<CurvePoints> read_curve_points(TableReader& reader, const char* x_column, const char* y_column,
                                             Quantity x, Quantity y) {
  if (reader.has("rows") == reader.has("file")) {
    reader.also_known({"rows", "file"});
    reader.error("", reader.has("rows") ? "rows and file" : "neither rows nor file",
                 fmt::format("a curve has rows [[{}, {}], …] or a CSV file with these columns", x_column, y_column),
                 "give one of them");
    return std::nullopt;
  }
  const char* source = reader.has("rows") ? "rows" : "file";
  const auto pairs =
      reader.has("rows") ? read_pairs(reader, "rows", x, y) : read_pairs_of_file(reader, x_column, y_column, x, y);
  if (!pairs) return std::nullopt;
  CurvePoints points;
  double largest = 0;
  for (Eigen::Index i = 0; i < pairs->rows(); ++i) {
    points.x.push_back((*pairs)(i, 0));
    points.y.push_back((*pairs)(i, 1));
    largest = std::max(largest, std::abs(points.y.back()));
    if (i > 0 && !((*pairs)(i, 0) > (*pairs)(i - 1, 0))) {
      reader.error(source, fmt::format("row {}: {:.6g} after {:.6g}", i + 1, (*pairs)(i, 0), (*pairs)(i - 1, 0)),
                   fmt::format("the {} increases from row to row", x_column), "sort the rows and remove repeats");
      return std::nullopt;
    }
  }
  if (points.x.size() < 2) {
    reader.error(source, fmt::format("{} rows", points.x.size()), "a curve has at least two", "complete it");
    return std::nullopt;
  }
  if (!(points.x.front() <= 0 && points.x.back() >= 0)) {
    reader.error(source, fmt::format("a {} from {:.6g} to {:.6g}", x_column, points.x.front(), points.x.back()),
                 "the curve contains 0", "begin at 0; a law that acts in both senses begins below it");
    return std::nullopt;
  }
  const double at_zero = elements::KnotCurve(points.x, points.y, elements::Interpolation::linear).at(0).value;
  constexpr double round_off = 1e-9;
  if (std::abs(at_zero) > round_off * largest) {
    reader.error(source, fmt::format("a {} of {:.6g} at 0", y_column, at_zero), "a curve passes 0 at 0",
                 "describe a preload by `preload` of the element or a constant force");
    return std::nullopt;
  }
  return points;
}

elements::Interpolation read_interpolation(TableReader& reader) {
  const auto word = reader.choice("interpolation", {"linear", "monotone_cubic"});
  return word && *word == "monotone_cubic" ? elements::Interpolation::monotone_cubic : elements::Interpolation::linear;
}

}  // namespace trivet::project
