// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "trivet/foundation/index.h"
#include "trivet/foundation/significant_digits.h"
#include "trivet/foundation/unit_prefix.h"
#include "trivet/identification/rope_fit.h"
#include "trivet/project/elements/element_law.h"
#include "trivet/project/elements/element_table_readers.h"
#include "trivet/project/elements/law_readers.h"
#include "trivet/project/elements/loop_file.h"

/// Wire ropes: along each axis a spring together with dry friction, from numbers or from measured loops.
namespace trivet::project {
namespace {

/// One axis: what is linear in large loops, and the laws beside it.
struct AxisOfRope {
  double stiffness = 0;
  elements::ScalarLaws laws;
};

/// Reads `loops`, and gives the element the fit.
std::optional<AxisOfRope> read_measured_axis(TableReader& reader, const char* axis, model::Element& element) {
  for (const char* key : {"stiffness", "quadratic", "cubic", "friction"})
    if (reader.has(key)) {
      reader.error(key, std::string(key) + " beside loops", "the fit of the loops gives it", "remove one of them");
      return std::nullopt;
    }
  const auto loops = read_loop_file(reader);
  if (!loops) return std::nullopt;
  const auto fit = identification::rope_fit(*loops);
  if (!fit) {
    add_loop_problems(reader, fit.error());
    return std::nullopt;
  }
  constexpr double poor = 0.1;
  if (fit->relative_rms > poor) {
    foundation::Problems doubts;
    doubts.warning("", fmt::format("the fit deviates from the loops by {:.3g} %", 100 * fit->relative_rms),
                   "a law should fit its loops within 10 %",
                   "check the loops; those of a rate that matters are no dry friction");
    add_loop_problems(reader, doubts);
  }
  double largest = 0;
  for (const identification::LoopFit& loop : *loops) largest = std::max(largest, loop.amplitude.value);
  constexpr double slips_well = 1.5, in_metres = 0.3;
  const double slips_at = fit->friction.force / fit->friction.stiffness;
  foundation::Problems remarks;
  if (largest < slips_well * slips_at)
    remarks.warning("",
                    fmt::format("loops up to {}, and the fit slips from about {}", foundation::prefixed(largest, "m"),
                                foundation::prefixed(slips_at, "m")),
                    "the limit of the friction and the spring of large loops are then extrapolated",
                    "measure loops of at least one and a half times that amplitude");
  if (largest > in_metres)
    remarks.warning("", "loops up to " + foundation::prefixed(largest, "m"), "a wire rope hardly moves that far",
                    "give length_unit and force_unit of the file");
  add_loop_problems(reader, remarks);
  std::string deviations;
  for (std::size_t i = 0; i < loops->size(); ++i)
    deviations += fmt::format("{}{:.3g} % at {}", i > 0 ? ", " : "", 100 * fit->rms[i],
                              foundation::prefixed((*loops)[i].amplitude.value, "m"));
  element.facts.push_back(
      {fmt::format("loops along {}", axis),
       fmt::format("{}, {:.4g} N/m², {:.4g} N/m³ together with friction with a limit of {}, {} in small loops, "
                   "exponent {:.3g}; deviates by {}",
                   foundation::prefixed_exactly(fit->stiffness, "N/m", 5), fit->quadratic, fit->cubic,
                   foundation::prefixed_exactly(fit->friction.force, "N", 5),
                   foundation::prefixed_exactly(fit->friction.stiffness, "N/m", 5), fit->friction.exponent,
                   deviations)});
  return AxisOfRope{fit->stiffness,
                    {elements::ElasticForce(elements::PolynomialForce{{0, fit->quadratic, fit->cubic}}),
                     elements::HystereticForce(fit->friction)}};
}

std::optional<AxisOfRope> read_axis_of_rope(TableReader& reader, const char* axis, bool is_rotation,
                                            model::Element& element) {
  const std::size_t before = reader.errors();
  reader.also_known({"stiffness", "quadratic", "cubic", "friction", "loops", "length_unit", "force_unit"});
  if (reader.has("loops")) {
    if (!is_rotation) return read_measured_axis(reader, axis, element);
    reader.error("loops", "loops about an axis", "they are fitted along axes", "give numbers");
    return std::nullopt;
  }
  for (const char* key : {"length_unit", "force_unit"})
    if (reader.has(key))
      reader.error(key, std::string(key) + " without loops", "it is a unit of the file of loops", "remove it");
  AxisOfRope found;
  found.stiffness =
      reader.required_number("stiffness", is_rotation ? Quantity::moment_per_angle : Quantity::force_per_length);
  if (!(found.stiffness >= 0))
    reader.error("stiffness", fmt::format("{:.6g}", found.stiffness), "it is ≥ 0", "correct its sign");
  if (const auto polynomial = read_polynomial(reader, is_rotation))
    found.laws.emplace_back(elements::ElasticForce(*polynomial));
  if (const Node* table = reader.table("friction")) {
    TableReader inside(*table, reader.path() + ".friction", reader.problems());
    if (const auto friction = read_bouc_wen(inside, is_rotation))
      found.laws.emplace_back(elements::HystereticForce(*friction));
    inside.finish();
  }
  return reader.errors() == before ? std::optional(std::move(found)) : std::nullopt;
}

void read_wire_rope(TableReader& reader, Placement& ends, model::Element& element) {
  if (reader.has("file")) {
    for (const char* axis : model::coordinate_names)
      if (reader.has(axis)) {
        reader.error(axis, std::string(axis) + " beside a file",
                     "a wire rope is a table, or has numbers or loops per axis", "remove one of them");
        static_cast<void>(reader.node(axis));
      }
    return read_tabulated(reader, ends, element);
  }
  reader.also_known({"file", "interpolation"});
  if (reader.has("interpolation"))
    reader.error("interpolation", "interpolation without a file", "it belongs to a table", "remove it");
  const double centre = reader.number("center", Quantity::pure).value_or(0.5);
  if (!(centre >= 0 && centre <= 1))
    reader.error("center", fmt::format("{:.6g}", centre), "it is between the ends: 0 (N) … 1 (K)",
                 "give a fraction of the length");
  elements::Vector6 constants = elements::Vector6::Zero();
  bool any = false;
  for (std::size_t j = 0; j < 6; ++j) {
    const char* axis = model::coordinate_names[j];
    const Node* table = reader.table(axis);
    if (!table) continue;
    any = true;
    TableReader inside(*table, reader.path() + "." + axis, reader.problems());
    if (auto found = read_axis_of_rope(inside, axis, j >= 3, element)) {
      constants(to_index(j)) = found->stiffness;
      if (!found->laws.empty())
        element.nonlinear_parts.push_back({static_cast<int>(j), centre, std::move(found->laws)});
    }
    inside.finish();
  }
  if (!any)
    reader.error("", "neither a file nor an axis",
                 "a wire rope is a table over frequency, or has x, y, z with stiffness and friction or measured loops",
                 R"(for instance z = {stiffness = "4 N/mm", friction = {stiffness = "11 N/mm", force = "45 N"}})");
  element.law.nominal_stiffness =
      elements::in_end_axes(elements::constants_at_point(constants, ends.span.arm, centre), ends.span.n_from_k);
}

}  // namespace

const ElementLaw wire_rope_law = {.type = "wire_rope", .placed = read_wire_rope, .keys = R"json([
   {"properties": {
   "file": {"type": "string", "description": "CSV as of a table"},
   "interpolation": {"enum": ["monotone_cubic", "linear"],
     "description": "between the rows (default: monotone_cubic)"},
   "center": {"$ref": "#/$defs/number",
     "description": "elastic centre as a fraction of the length from N, 0 to 1 (default: 0.5)"},
   "damping": false},
   "required": ["file"]},
   {"properties": {
   "file": false,
   "x": {"$ref": "#/$defs/rope_axis"}, "y": {"$ref": "#/$defs/rope_axis"}, "z": {"$ref": "#/$defs/rope_axis"},
   "rx": {"$ref": "#/$defs/rope_axis"}, "ry": {"$ref": "#/$defs/rope_axis"}, "rz": {"$ref": "#/$defs/rope_axis"},
   "center": {"$ref": "#/$defs/number", "description": "elastic centre as a fraction of the length from N (default: 0.5)"}}}])json"};

}  // namespace trivet::project
