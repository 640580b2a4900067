// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "trivet/foundation/index.h"
#include "trivet/project/elements/element_law.h"
#include "trivet/project/elements/element_table_readers.h"

/// Nonlinear laws of an element (docs/nonlinear.md).
namespace trivet::project {
namespace {

constexpr double half_way = 0.5;

/// `quadratic`, `cubic` and `polynomial`: coefficients of δ, δ², …
std::optional<elements::PolynomialForce> read_polynomial(TableReader& reader, bool is_rotation) {
  if (!reader.has("quadratic") && !reader.has("cubic") && !reader.has("polynomial")) return std::nullopt;
  elements::PolynomialForce law;
  law.coefficients = reader.numbers("polynomial", Quantity::pure).value_or(std::vector<double>());
  if (law.coefficients.size() < 3) law.coefficients.resize(3, 0.0);
  law.coefficients[1] +=
      reader.number("quadratic", is_rotation ? Quantity::moment_per_angle_squared : Quantity::force_per_length_squared)
          .value_or(0);
  law.coefficients[2] +=
      reader.number("cubic", is_rotation ? Quantity::moment_per_angle_cubed : Quantity::force_per_length_cubed)
          .value_or(0);
  while (!law.coefficients.empty() && law.coefficients.back() == 0) law.coefficients.pop_back();
  constexpr std::size_t highest = 12;
  if (law.coefficients.size() > highest)
    reader.error("polynomial", fmt::format("degree {}", law.coefficients.size()),
                 fmt::format("at most degree {}", highest), "such a polynomial oscillates between its points");
  return law.coefficients.empty() ? std::nullopt : std::optional(law);
}

void read_axis(TableReader& reader, int axis, double centre, const model::Span& span, model::Element& element) {
  model::NonlinearPart part{axis, centre, {}};
  const bool is_rotation = axis >= 3;
  const std::size_t before = reader.errors();
  reader.also_known({"quadratic", "cubic", "polynomial", "gap_stop"});
  if (const auto polynomial = read_polynomial(reader, is_rotation)) part.laws.emplace_back(*polynomial);
  if (const Node* table = reader.table("gap_stop")) {
    TableReader stop(*table, reader.path() + ".gap_stop", reader.problems());
    if (const auto law = read_gap_stop(stop, is_rotation)) {
      part.laws.emplace_back(*law);
      const Eigen::Matrix<double, 1, 12> row = elements::deflection_row(axis, span.arm, span.n_from_k, centre);
      const double own =
          element.law.scale * row.dot(row * element.law.nominal_stiffness) / std::pow(row.squaredNorm(), 2);
      if (law->power == 1 && law->stiffness < own)
        reader.problems()
            .warning(stop.path() + ".stiffness", fmt::format("{:.6g}", law->stiffness),
                     fmt::format("the stop is softer than the element itself, {:.6g}", own), "check digits and unit")
            .origin = table->origin;
    }
    stop.finish();
  }
  reader.finish();
  if (part.laws.empty() && reader.errors() == before)
    reader.error("", "no law", "it is a sum of quadratic, cubic, polynomial and gap_stop", "give one, or remove it");
  if (!part.laws.empty()) element.nonlinear_parts.push_back(std::move(part));
}

}  // namespace

std::optional<elements::GapStop> read_gap_stop(TableReader& reader, bool is_rotation) {
  const std::size_t before = reader.errors();
  elements::GapStop law;
  const Quantity travel = is_rotation ? Quantity::angle : Quantity::length;
  if (reader.has("gap") == reader.has("gaps"))
    reader.error(reader.has("gap") ? "gaps" : "", reader.has("gap") ? "gap and gaps" : "neither gap nor gaps",
                 "a stop has a gap in the positive direction, or gaps in both",
                 "gap = \"6 mm\", or gaps = [\"6 mm\", \"9 mm\"]");
  if (const auto gap = reader.number("gap", travel)) law.gap_above = *gap;
  if (const auto gaps = reader.numbers("gaps", travel)) {
    if (gaps->size() == 2) {
      law.gap_above = (*gaps)[0];
      law.gap_below = (*gaps)[1];
    } else {
      reader.error("gaps", fmt::format("{} numbers", gaps->size()),
                   "two are expected: in the positive and in the negative direction", "complete or shorten the list");
    }
  }
  for (const double gap : {law.gap_above, law.gap_below})
    if (gap < 0)
      reader.error(reader.has("gap") ? "gap" : "gaps", fmt::format("{:.6g} {}", gap, si_unit(travel)), "a gap is ≥ 0",
                   "describe a preloaded stop by its rest position: gravity closes gaps");
  law.power = reader.number("power", Quantity::pure).value_or(1);
  if (!(law.power >= 1 && law.power <= 10))
    reader.error("power", fmt::format("{:.6g}", law.power), "it is from 1 (linear) to 10; 1.5 is Hertz's contact",
                 "correct it");
  const Quantity stiffness = law.power != 1 ? Quantity::pure
      : is_rotation                         ? Quantity::moment_per_angle
                                            : Quantity::force_per_length;
  law.stiffness = reader.required_number("stiffness", stiffness);
  if (reader.errors() == before && !(law.stiffness > 0))
    reader.error("stiffness", fmt::format("{:.6g}", law.stiffness), "it is > 0", "correct it");
  return reader.errors() == before ? std::optional(law) : std::nullopt;
}

void read_laws(TableReader& reader, const model::Span& span, model::Element& element) {
  const Node* table = reader.table("laws");
  if (!table) return;
  TableReader laws(*table, reader.path() + ".laws", reader.problems());
  const double centre = laws.number("center", Quantity::pure).value_or(half_way);
  if (!(centre >= 0 && centre <= 1))
    laws.error("center", fmt::format("{:.6g}", centre), "it is between the ends: 0 (N) … 1 (K)",
               "give a fraction of the length");
  for (std::size_t j = 0; j < 6; ++j) {
    const char* axis = model::coordinate_names[j];
    const Node* of_axis = laws.table(axis);
    if (!of_axis) continue;
    TableReader inside(*of_axis, laws.path() + "." + axis, reader.problems());
    read_axis(inside, static_cast<int>(j), centre, span, element);
  }
  laws.finish();
  if (!element.nonlinear_parts.empty() && elements::loss_factor(element.law) > 0)
    reader.error("laws", "nonlinear laws beside a loss factor",
                 "a loss factor defines no motion in time, which a nonlinear law needs",
                 "give proportional damping: δ = η/ω at the frequency that matters");
}

namespace {

/// A point of a body against a plane, or between two: no force until a gap closes.
void read_stop(TableReader& reader, Placement&, model::Element& element) {
  if (!reader.has("axis") && !reader.has("orientation"))
    reader.missing("axis", "give the direction in which the body meets the stop: axis = \"z\" or \"-z\"");
  constexpr int along = 2;
  if (const auto law = read_gap_stop(reader, false)) element.nonlinear_parts.push_back({along, 1.0, {*law}});
}

}  // namespace

const ElementLaw stop_law = {
    .type = "stop", .placed = read_stop, .takes_damping = false, .keys = R"json({"properties": {
   "gap": {"$ref": "#/$defs/number", "description": "m, >= 0: travel of the body along the axis until it meets the stop"},
   "gaps": {"type": "array", "items": {"$ref": "#/$defs/number"}, "minItems": 2, "maxItems": 2, "description": "m: along and against the axis"},
   "stiffness": {"$ref": "#/$defs/number", "description": "N/m beyond the gap; with power p: N/m^p, a bare number"},
   "power": {"$ref": "#/$defs/number", "description": "of the travel beyond the gap, 1 to 10 (default: 1); 1.5: Hertz's contact"},
   "damping": false,
   "scale": false,
   "laws": false},
  "required": ["stiffness"]})json"};

}  // namespace trivet::project
