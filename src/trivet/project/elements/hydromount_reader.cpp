// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "trivet/foundation/index.h"
#include "trivet/foundation/significant_digits.h"
#include "trivet/project/elements/element_law.h"
#include "trivet/project/elements/element_table_readers.h"

/// A rubber mount with two chambers of fluid, a track between them and a decoupler (docs/elements/hydromount.md).
namespace trivet::project {
namespace {

/// Pressures over volumes and flows, read as numbers in SI.
struct FluidColumn {
  double inertance = 0, resistance = 0, quadratic = 0;  // Pa s²/m³, Pa s/m³, Pa s²/m⁶
};

double read_at_least_zero(TableReader& reader, const char* key, const char* unit, double otherwise) {
  const double value = reader.number(key, Quantity::pure).value_or(otherwise);
  if (!(value >= 0)) reader.error(key, fmt::format("{:.6g} {}", value, unit), "it is ≥ 0", "correct its sign");
  return value;
}

double read_above_zero(TableReader& reader, const char* key, const char* unit) {
  const std::size_t before = reader.errors();
  const double value = reader.required_number(key, Quantity::pure);
  if (reader.errors() == before && !(value > 0))
    reader.error(key, fmt::format("{:.6g} {}", value, unit), "it is > 0", "correct it");
  return value;
}

FluidColumn read_column(TableReader& reader) {
  FluidColumn column;
  column.inertance = read_above_zero(reader, "inertance", "Pa s²/m³");
  column.resistance = read_at_least_zero(reader, "resistance", "Pa s/m³", 0);
  column.quadratic = read_at_least_zero(reader, "quadratic_resistance", "Pa s²/m⁶", 0);
  return column;
}

void read_hydromount(TableReader& reader, Placement& ends, model::Element& element) {
  constexpr int along = 2;
  constexpr double middle = 0.5;
  const std::size_t before = reader.errors();
  const elements::Vector6 rubber = read_constants(reader, Quantity::force_per_length, Quantity::moment_per_angle, true);
  element.law.nominal_stiffness =
      elements::in_end_axes(elements::constants_at_point(rubber, ends.span.arm, middle), ends.span.n_from_k);
  const double upper = read_above_zero(reader, "upper", "Pa/m³"), lower = read_above_zero(reader, "lower", "Pa/m³");
  const double area = reader.required_number("piston_area", Quantity::area);
  if (reader.errors() == before && !(area > 0))
    reader.error("piston_area", fmt::format("{:.6g} m²", area), "it is > 0", "correct it");
  std::vector<FluidColumn> columns;
  std::vector<std::string> names;
  if (const Node* table = reader.table("track")) {
    TableReader track(*table, reader.path() + ".track", reader.problems());
    columns.push_back(read_column(track));
    names.emplace_back("track");
    track.finish();
  } else {
    reader.missing("track", "give the inertia track: track = {inertance = …, resistance = …}");
  }
  double play = 0, seat = 0, centring = 0;
  if (const Node* table = reader.table("decoupler")) {
    TableReader decoupler(*table, reader.path() + ".decoupler", reader.problems());
    columns.push_back(read_column(decoupler));
    names.emplace_back("decoupler");
    constexpr double faint = 1e-5;
    play = decoupler.required_number("play", Quantity::volume);
    if (decoupler.has("play") && !(play > 0))
      decoupler.error("play", fmt::format("{:.6g} m³", play), "it is > 0: the volume until it closes, either way",
                      "correct it, or remove the decoupler");
    seat = decoupler.number("seat", Quantity::pure).value_or(upper);
    centring = decoupler.number("centring", Quantity::pure).value_or(faint * lower);
    if (decoupler.has("seat") && !(seat > 0))
      decoupler.error("seat", fmt::format("{:.6g} Pa/m³", seat), "it is > 0", "correct it");
    if (!(centring > 0))
      decoupler.error("centring", fmt::format("{:.6g} Pa/m³", centring),
                      "it is > 0: without any, the fluid circulates freely and has no position of rest",
                      "give a small one, or leave it out");
    decoupler.finish();
    // Fluid that circulates through track and decoupler deflects nothing else: its stiffness must exceed the round-off
    // of the chambers' stiffnesses.
    constexpr double round_off = 1e-14;
    if (const double least = round_off * (upper + lower); reader.errors() == before && centring < least)
      reader.error(
          decoupler.has("centring") ? "decoupler.centring" : "lower",
          fmt::format("{:.6g} Pa/m³", decoupler.has("centring") ? centring : lower),
          fmt::format("the centring of the decoupler, {:.6g} Pa/m³, is at least 1e-14 of upper + lower, {:.6g} "
                      "Pa/m³: below, the fluid has no defined rest position",
                      centring, least),
          "correct the stiffnesses of the chambers, or give a stiffer centring");
  }
  if (reader.errors() > before) return;
  const Eigen::Index count = to_index(columns.size()), size = 12 + count;
  elements::InnerParts parts{names, Eigen::MatrixXd::Zero(size, size), Eigen::MatrixXd::Zero(size, size),
                             Eigen::MatrixXd::Zero(size, size)};
  // Volumes over the area are deflections: compression of the mount, and flow out of the upper chamber.
  Eigen::VectorXd into_upper = Eigen::VectorXd::Zero(size), into_lower = into_upper;
  into_upper.head(12) = -elements::deflection_row(along, ends.span.arm, ends.span.n_from_k, middle).transpose();
  into_upper.tail(count).setConstant(-1);
  into_lower.tail(count).setConstant(1);
  const double square = area * area;
  parts.stiffness =
      square * upper * into_upper * into_upper.transpose() + square * lower * into_lower * into_lower.transpose();
  for (Eigen::Index i = 0; i < count; ++i) {
    const FluidColumn& column = columns[i];
    parts.mass(12 + i, 12 + i) = square * column.inertance;
    parts.damping(12 + i, 12 + i) = square * column.resistance;
    model::NonlinearPart part;
    part.inner = static_cast<int>(i);
    if (column.quadratic > 0) {
      const double coefficient = square * area * column.quadratic;
      part.laws.emplace_back(elements::DampingForce(elements::QuadraticDamping{coefficient, coefficient}));
    }
    if (i == 1) {
      parts.stiffness(13, 13) += square * centring;
      elements::GapStop closing;
      closing.gap_above = closing.gap_below = play / area;
      closing.stiffness = square * seat;
      // The film of fluid at the seat damps as much as is critical at a tenth of the play beyond it.
      constexpr double beyond = 0.1;
      closing.dissipation = 2 / (std::sqrt(seat / column.inertance) * beyond * play / area);
      part.laws.emplace_back(elements::ElasticForce(closing));
    }
    if (!part.laws.empty()) element.nonlinear_parts.push_back(std::move(part));
  }
  element.law.inner = std::move(parts);
  const double gained = square * upper * lower / (upper + lower);
  element.facts.push_back({"axial stiffness of the fluid when slow", foundation::prefixed_exactly(gained, "N/m", 6)});
  element.facts.push_back({"axial stiffness of the fluid when the track is blocked",
                           foundation::prefixed_exactly(square * upper, "N/m", 6)});
}

}  // namespace

const ElementLaw hydromount_law = {.type = "hydromount", .placed = read_hydromount, .keys = R"json({"properties": {
   "translation": {"$ref": "#/$defs/vector", "description": "of the rubber, N/m along the local axes"},
   "rotation": {"$ref": "#/$defs/vector", "description": "of the rubber, N m/rad"},
   "upper": {"$ref": "#/$defs/number", "description": "bulge stiffness of the upper chamber, Pa/m^3, a bare number"},
   "lower": {"$ref": "#/$defs/number", "description": "of the lower chamber, Pa/m^3"},
   "piston_area": {"$ref": "#/$defs/number", "description": "m^2: effective area that pumps the fluid, > 0"},
   "track": {"type": "object", "description": "channel between both chambers", "properties": {
     "inertance": {"$ref": "#/$defs/number", "description": "Pa s^2/m^3: pressure per acceleration of the flow, > 0"},
     "resistance": {"$ref": "#/$defs/number", "description": "Pa s/m^3: pressure per flow (default: 0)"},
     "quadratic_resistance": {"$ref": "#/$defs/number", "description": "Pa s^2/m^6: pressure per flow squared (default: 0)"}},
     "required": ["inertance"], "additionalProperties": false},
   "decoupler": {"type": "object", "description": "membrane with play beside the track", "properties": {
     "inertance": {"$ref": "#/$defs/number", "description": "Pa s^2/m^3: pressure per acceleration of the flow, > 0"},
     "resistance": {"$ref": "#/$defs/number", "description": "Pa s/m^3: pressure per flow (default: 0)"},
     "quadratic_resistance": {"$ref": "#/$defs/number", "description": "Pa s^2/m^6: pressure per flow squared (default: 0)"},
     "play": {"$ref": "#/$defs/number", "description": "volume until it closes, either way, m^3"},
     "seat": {"$ref": "#/$defs/number", "description": "stiffness when closed, Pa/m^3 (default: upper)"},
     "centring": {"$ref": "#/$defs/number", "description": "stiffness when open, Pa/m^3 (default: 1e-5 lower)"}},
     "required": ["inertance", "play"], "additionalProperties": false}},
  "required": ["translation", "upper", "lower", "piston_area", "track"]})json"};

}  // namespace trivet::project
