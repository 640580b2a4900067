// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "trivet/foundation/significant_digits.h"
#include "trivet/project/elements/element_law.h"
#include "trivet/project/elements/law_readers.h"

/// A spring, a damper and gas along the line between two points, which follows their finite motion (docs/nonlinear.md).
namespace trivet::project {
namespace {

void read_strut(TableReader& reader, Placement& ends, model::Element& element) {
  const std::size_t before = reader.errors();
  model::DistancePart part;
  part.law.offset = ends.span.arm;
  const double between = ends.span.arm.norm();
  if (ends.known && !(between > 0))
    reader.error("from_at", "both ends are at the same point", "a strut works along the line between them",
                 "give the other end: from_at = [x, y, z]");
  part.law.length = reader.number("free_length", Quantity::length).value_or(between);
  if (!(part.law.length >= 0))
    reader.error("free_length", fmt::format("{:.6g} m", part.law.length), "a length is ≥ 0", "correct it");
  reader.also_known(
      {"stiffness", "quadratic", "cubic", "polynomial", "curve", "gap_stop", "gas", "coefficient", "damping_curve"});
  for (const char* key : {"friction", "bouc_wen", "lugre", "payne", "laws"}) {
    if (reader.has(key))
      reader.error(key, std::string(key) + " of a strut", "its force follows its extension and rate alone",
                   "give it to another element between the same points");
    static_cast<void>(reader.node(key));
  }
  if (reader.has("stiffness")) {
    const double stiffness = reader.required_number("stiffness", Quantity::force_per_length);
    if (!(stiffness > 0))
      reader.error("stiffness", fmt::format("{:.6g} N/m", stiffness), "it is > 0", "correct it, or remove it");
    part.law.laws.emplace_back(elements::ElasticForce(elements::PolynomialForce{{stiffness}}));
  }
  if (const auto polynomial = read_polynomial(reader, false))
    part.law.laws.emplace_back(elements::ElasticForce(*polynomial));
  const auto inside = [&](const char* key, const auto& read) {
    const Node* table = reader.table(key);
    if (!table) return;
    TableReader law(*table, reader.path() + "." + key, reader.problems());
    if (const auto found = read(law)) part.law.laws.emplace_back(elements::ElasticForce(*found));
    law.finish();
  };
  inside("curve", [](TableReader& law) { return read_force_curve(law, false); });
  inside("gap_stop", [](TableReader& law) {
    auto stop = read_gap_stop(law, false);
    if (stop && stop->gaps_at_rest) {
      law.error("gap_at", "\"rest\" in a strut", "its gaps are extensions from the free length",
                "give them so, and remove gap_at");
      stop.reset();
    }
    return stop;
  });
  inside("gas", [](TableReader& law) { return read_gas_force(law); });
  if (reader.has("coefficient")) {
    const double c = reader.required_number("coefficient", Quantity::damping_force_per_length);
    if (!(c >= 0))
      reader.error("coefficient", fmt::format("{:.6g} N s/m", c), "a damper does not feed energy: it is ≥ 0",
                   "correct its sign");
    elements::DampingCurve line;
    line.force = elements::KnotCurve({-1, 1}, {-c, c}, elements::Interpolation::linear);
    part.law.laws.emplace_back(elements::DampingForce(line));
  }
  if (const Node* table = reader.table("damping_curve")) {
    TableReader law(*table, reader.path() + ".damping_curve", reader.problems());
    if (const auto curve = read_damping_curve(law, false)) part.law.laws.emplace_back(*curve);
    law.finish();
  }
  if (reader.errors() > before) return;
  if (part.law.laws.empty())
    reader.error("", "a strut without any law",
                 "it is a sum of stiffness, quadratic, cubic, polynomial, curve, gap_stop, gas, coefficient and "
                 "damping_curve over its extension",
                 "give one");
  const elements::SpatialForce there =
      elements::force_in_motion(part.law, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
  element.facts.push_back({"length between its ends", foundation::prefixed_exactly(between, "m", 6)});
  element.facts.push_back(
      {"pull at this length", foundation::prefixed_exactly(there.force.dot(ends.span.arm) / between, "N", 6)});
  element.distance_parts.push_back(std::move(part));
}

}  // namespace

const ElementLaw strut_law = {
    .type = "strut", .placed = read_strut, .takes_damping = false, .takes_laws = false, .keys = R"json({"properties": {
   "free_length": {"$ref": "#/$defs/number", "description": "m: where the forces over the extension begin (default: the length between the ends)"},
   "stiffness": {"$ref": "#/$defs/number", "description": "N/m over the extension"},
   "coefficient": {"$ref": "#/$defs/number", "description": "N s/m over its rate"},
   "quadratic": {"$ref": "#/$defs/number", "description": "N/m^2: coefficient of the squared extension"},
   "cubic": {"$ref": "#/$defs/number", "description": "N/m^3: coefficient of the cubed extension"},
   "polynomial": {"type": "array", "items": {"$ref": "#/$defs/number"},
     "description": "coefficients of the first, second, … power of the extension, SI"},
   "curve": {"type": "object", "description": "force over the extension through points; keys as in laws"},
   "gap_stop": {"type": "object", "description": "stop beyond gaps of the extension; keys as in laws, without gap_at"},
   "gas": {"type": "object", "description": "gas that a negative extension compresses; keys as in laws"},
   "damping_curve": {"type": "object", "description": "force over the rate of the extension; keys as in laws"},
   "damping": false,
   "scale": false,
   "laws": false}})json"};

}  // namespace trivet::project
