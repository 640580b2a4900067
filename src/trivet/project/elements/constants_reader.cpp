// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "trivet/project/elements/element_law.h"
#include "trivet/project/elements/element_table_readers.h"
#include "trivet/project/text/shared_keys.h"

/// Laws with constants in the file: a matrix, springs at a point, a damper along a line.
namespace trivet::project {
namespace {

void read_matrix(TableReader& reader, Placement& ends, model::Element& element) {
  if (!reader.has("stiffness"))
    reader.missing("stiffness", "give the 6×6 of the moved end K, or the full 12×12 (N, K)");
  ends.damping_at = 1;
  if (const auto matrix =
          reader.matrix("stiffness", [](int, int i, int j) { return matrix_entry(false, i, j); }, {6, 12}))
    element.law.nominal_stiffness = full_matrix(*matrix, ends.span);
}

/// Elastic centre as a fraction of the way from N to K.
double read_center(TableReader& reader, Placement& ends) {
  const double center = reader.number("center", Quantity::pure).value_or(0.5);
  if (reader.has("center") && ends.known && ends.span.arm.isZero(0))
    warn_at_key(reader, "center", "center of an element without length",
                "it is a fraction of the distance from end N to end K, and this distance is 0",
                "give from_at, or remove it");
  if (!(center >= 0 && center <= 1))
    reader.error("center", fmt::format("{:.6g}", center), "the elastic centre is between the ends: 0 (N) … 1 (K)",
                 "give a fraction of the length");
  ends.damping_at = center;
  return center;
}

void read_springs_at_center(TableReader& reader, Placement& ends, bool with_rotation, model::Element& element) {
  const double center = read_center(reader, ends);
  const elements::Vector6 k =
      read_constants(reader, Quantity::force_per_length, Quantity::moment_per_angle, with_rotation);
  element.law.nominal_stiffness =
      elements::in_end_axes(elements::constants_at_point(k, ends.span.arm, center), ends.span.n_from_k);
  stiffen(stiffening_of(reader), element);
}

void read_bushing(TableReader& reader, Placement& ends, model::Element& element) {
  read_springs_at_center(reader, ends, true, element);
}
void read_three_springs(TableReader& reader, Placement& ends, model::Element& element) {
  read_springs_at_center(reader, ends, false, element);
}

void read_damper(TableReader& reader, Placement& ends, model::Element& element) {
  const double center = read_center(reader, ends);
  const double c = reader.required_number("coefficient", Quantity::damping_force_per_length);
  if (c < 0)
    reader.error("coefficient", fmt::format("{:.6g} N s/m", c), "it must be ≥ 0",
                 "a negative one would feed energy into the motion");
  for (const char* key : {"damping", "scale"}) {
    if (reader.has(key))
      reader.error(key, std::string(key) + " of a damper", "a damper has only a coefficient",
                   "remove it, and change the coefficient");
    static_cast<void>(reader.node(key));
  }
  Eigen::Vector3d line = ends.span.arm;
  if (reader.has("axis")) line = Eigen::Vector3d::UnitZ();  // local e3, which `axis` sets
  else if (!(line.norm() > 0)) {
    if (ends.known)
      reader.error("axis", "both ends are at the same point", "a damper works along a line",
                   "give axis = \"z\" or another from_at");
    return;
  }
  element.law.damping = elements::DampingMatrix{elements::in_end_axes(
      elements::constant_along_line(c, line.normalized(), ends.span.arm, center), ends.span.n_from_k)};
}

}  // namespace

const ElementLaw matrix_law = {.type = "matrix", .placed = read_matrix, .keys = R"json({"properties": {
   "stiffness": {"$ref": "#/$defs/matrix"}},
  "required": ["stiffness"]})json"};

const ElementLaw bushing_law = {.type = "bushing", .placed = read_bushing, .keys = R"json({"properties": {
   "center": {"$ref": "#/$defs/number", "description": "elastic centre as a fraction of the length from N, 0 to 1"},
   "translation": {"$ref": "#/$defs/vector", "description": "N/m along the local axes, static"},
   "rotation": {"$ref": "#/$defs/vector", "description": "N m/rad, static"},
   "stiffening": {"$ref": "#/$defs/number", "description": "stiffness in vibration over the static one (default: 1)"}},
  "required": ["translation"]})json"};

const ElementLaw three_springs_law = {
    .type = "three_springs", .placed = read_three_springs, .keys = R"json({"properties": {
   "center": {"$ref": "#/$defs/number", "description": "elastic centre as a fraction of the length from N, 0 to 1"},
   "translation": {"$ref": "#/$defs/vector", "description": "N/m along the local axes, static"},
   "stiffening": {"$ref": "#/$defs/number", "description": "stiffness in vibration over the static one (default: 1)"}},
  "required": ["translation"]})json"};

const ElementLaw damper_law = {
    .type = "damper", .placed = read_damper, .takes_damping = false, .keys = R"json({"properties": {
   "center": {"$ref": "#/$defs/number", "description": "elastic centre as a fraction of the length from N, 0 to 1"},
   "coefficient": {"$ref": "#/$defs/number", "description": "N s/m along the line from N to K, or along `axis`"},
   "damping": false},
  "required": ["coefficient"]})json"};

}  // namespace trivet::project
