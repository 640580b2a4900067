// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/foundation/index.h"
#include "trivet/project/elements/element_law.h"
#include "trivet/project/elements/element_table_readers.h"
#include "trivet/project/elements/law_readers.h"

/// Nonlinear laws of an element (docs/nonlinear.md).
namespace trivet::project {
namespace {

constexpr double half_way = 0.5;

void read_axis(TableReader& reader, int axis, double centre, const model::Span& span, model::Element& element) {
  model::NonlinearPart part{axis, centre, {}};
  const bool is_rotation = axis >= 3;
  const std::size_t before = reader.errors();
  reader.also_known({"quadratic", "cubic", "polynomial", "gap_stop", "gas", "curve", "damping_curve", "friction",
                     "bouc_wen", "payne", "lugre"});
  if (const auto polynomial = read_polynomial(reader, is_rotation))
    part.laws.emplace_back(elements::ElasticForce(*polynomial));
  const auto inside = [&](const char* key, const auto& read) {
    const Node* table = reader.table(key);
    if (!table) return;
    TableReader law(*table, reader.path() + "." + key, reader.problems());
    read(law);
    law.finish();
  };
  inside("gap_stop", [&](TableReader& law) {
    const auto stop = read_gap_stop(law, is_rotation);
    if (!stop) return;
    part.laws.emplace_back(elements::ElasticForce(*stop));
    const Eigen::Matrix<double, 1, 12> row = elements::deflection_row(axis, span.arm, span.n_from_k, centre);
    const double own =
        element.law.scale * row.dot(row * element.law.nominal_stiffness) / std::pow(row.squaredNorm(), 2);
    const double stiffness = stop->curve ? stop->curve->at(stop->curve->knots().back()).slope : stop->stiffness;
    if (stop->power == 1 && stiffness < own)
      reader.problems()
          .warning(law.path() + (stop->curve ? ".curve" : ".stiffness"), fmt::format("{:.6g}", stiffness),
                   fmt::format("the stop is softer than the element itself, {:.6g}", own), "check digits and unit")
          .origin = law.content().origin;
  });
  if (is_rotation && reader.has("gas"))
    reader.error("gas", "gas about an axis", "it acts along an axis", "give it under x, y or z");
  else
    inside("gas", [&](TableReader& law) {
      if (const auto gas = read_gas_force(law)) part.laws.emplace_back(elements::ElasticForce(*gas));
    });
  inside("curve", [&](TableReader& law) {
    if (auto curve = read_force_curve(law, is_rotation)) part.laws.emplace_back(elements::ElasticForce(*curve));
  });
  inside("damping_curve", [&](TableReader& law) {
    if (auto curve = read_damping_curve(law, is_rotation)) part.laws.emplace_back(*curve);
  });
  inside("friction", [&](TableReader& law) {
    for (const elements::ScalarLaw& one : read_friction(law, is_rotation)) part.laws.push_back(one);
  });
  inside("payne", [&](TableReader& law) {
    if (const auto payne = read_payne(law, is_rotation)) part.laws.emplace_back(*payne);
  });
  inside("lugre", [&](TableReader& law) {
    if (const auto bristles = read_lugre(law, is_rotation)) part.laws.emplace_back(*bristles);
  });
  inside("bouc_wen", [&](TableReader& law) {
    if (const auto smooth = read_bouc_wen(law, is_rotation)) part.laws.emplace_back(elements::HystereticForce(*smooth));
  });
  reader.finish();
  if (part.laws.empty() && reader.errors() == before)
    reader.error(
        "", "no law",
        "it is a sum of quadratic, cubic, polynomial, curve, gap_stop, gas, damping_curve, friction, bouc_wen, "
        "lugre and payne",
        "give one, or remove it");
  if (part.laws.empty()) return;
  for (model::NonlinearPart& other : element.nonlinear_parts)  // of the type of the element
    if (!other.is_inner() && other.axis == axis && other.centre == centre) {
      other.laws.insert(other.laws.end(), part.laws.begin(), part.laws.end());
      return;
    }
  element.nonlinear_parts.push_back(std::move(part));
}

}  // namespace

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
}

namespace {

std::optional<elements::RubbingFriction> read_friction_of_stop(TableReader& reader) {
  const Node* table = reader.table("friction");
  if (!table) return std::nullopt;
  TableReader inside(*table, reader.path() + ".friction", reader.problems());
  const std::optional<elements::RubbingFriction> found = read_rubbing_friction(inside);
  inside.finish();
  return found;
}

/// A point of a body against a plane, or between two: no force until a gap closes.
void read_stop(TableReader& reader, Placement& ends, model::Element& element) {
  if (!reader.has("axis") && !reader.has("orientation"))
    reader.missing("axis", "give the direction in which the body meets the stop: axis = \"z\" or \"-z\"");
  constexpr int along = 2;
  reader.also_known({"ring", "gap", "gaps"});
  const std::optional<elements::RubbingFriction> friction = read_friction_of_stop(reader);
  if (reader.has("ring")) {
    for (const char* other : {"gap", "gaps"})
      if (reader.has(other))
        reader.error(other, std::string("ring and ") + other, "a stop is within a ring, or along its axis",
                     "remove one");
    const double play = reader.number("ring", Quantity::length).value_or(1);
    if (!(play > 0))
      reader.error("ring", fmt::format("{:.6g} m", play), "the play of a pin in its ring is > 0",
                   "describe a pin without play by a stiff spring");
    if (const auto law = read_gap_stop(reader, false, std::max(play, 0.0))) {
      model::DistancePart part;
      part.law.offset = ends.span.arm;
      part.law.across = true;
      part.law.laws.emplace_back(elements::ElasticForce(*law));
      part.friction = friction;
      element.distance_parts.push_back(std::move(part));
    }
    return;
  }
  if (const auto law = read_gap_stop(reader, false))
    element.nonlinear_parts.push_back({along, 1.0, {elements::ElasticForce(*law)}});
  if (friction) element.rubbing_parts.push_back({*friction, 0});
}

}  // namespace

const ElementLaw stop_law = {
    .type = "stop", .placed = read_stop, .takes_damping = false, .takes_laws = false, .keys = R"json({"properties": {
   "gap": {"$ref": "#/$defs/number", "description": "m, >= 0: travel of the body along the axis until it meets the stop"},
   "gaps": {"type": "array", "items": {"$ref": "#/$defs/number"}, "minItems": 2, "maxItems": 2, "description": "m: along and against the axis"},
   "ring": {"$ref": "#/$defs/number", "description": "m, > 0: play of a pin within a ring, in all directions across the axis"},
   "stiffness": {"$ref": "#/$defs/number", "description": "N/m beyond the gap; with power p: N/m^p, a bare number; or a curve"},
   "power": {"$ref": "#/$defs/number", "description": "of the travel beyond the gap, 1 to 10 (default: 1); 1.5: Hertz's contact"},
   "dissipation": {"$ref": "#/$defs/number", "description": "s/m, >= 0: the force grows by this times the closing speed (default: 0)"},
   "curve": {"$ref": "#/$defs/curve_of_stop"},
   "gap_at": {"enum": ["unloaded", "rest"], "description": "the state in which the gap is measured (default: unloaded)"},
   "friction": {"type": "object", "additionalProperties": false, "required": ["coefficient", "stiffness"], "description": "while it is closed: across its axis, or around and along the wall of its ring", "properties": {
     "coefficient": {"$ref": "#/$defs/number", "description": "> 0: the friction is at most this times the force on the stop"},
     "stiffness": {"$ref": "#/$defs/number", "description": "N/m, > 0: with which it sticks, in all these directions"}}},
   "damping": false,
   "scale": false,
   "laws": false},
  "oneOf": [{"required": ["stiffness"]}, {"required": ["curve"], "properties": {"power": false}}]})json"};

}  // namespace trivet::project
