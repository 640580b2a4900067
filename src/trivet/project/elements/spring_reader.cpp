// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "trivet/elements/coil_dynamics.h"
#include "trivet/elements/coil_preload.h"
#include "trivet/elements/coil_reduction.h"
#include "trivet/elements/coil_spring.h"
#include "trivet/foundation/hertz.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/significant_digits.h"
#include "trivet/project/elements/condensed_solid.h"
#include "trivet/project/elements/element_law.h"
#include "trivet/project/elements/element_shape.h"
#include "trivet/project/elements/element_table_readers.h"
#include "trivet/project/elements/material_reader.h"

namespace trivet::project {
namespace {

using elements::CoilSpring;

constexpr int default_internal_modes = 6, most_internal_modes = 60;

void read_wire(TableReader& reader, CoilSpring& spring) {
  const bool rectangular = reader.has("wire_width") || reader.has("wire_height");
  if (rectangular && reader.has("wire_diameter"))
    reader.error("wire_diameter", "a diameter and a width or height", "a wire is round or rectangular",
                 "keep wire_diameter, or wire_width (radial) and wire_height (axial)");
  if (rectangular)
    spring.wire = elements::RectangularWire{reader.required_number("wire_width", Quantity::length),
                                            reader.required_number("wire_height", Quantity::length)};
  else spring.wire = elements::RoundWire{reader.required_number("wire_diameter", Quantity::length)};
  static_cast<void>(reader.node("wire_diameter"));
}

/// Free length of the active coils, or their pitch.
void read_length(TableReader& reader, CoilSpring& spring) {
  if (reader.has("free_length") == reader.has("pitch"))
    reader.error(reader.has("pitch") ? "pitch" : "free_length",
                 reader.has("pitch") ? "free_length and pitch" : "missing",
                 "the length of the active coils follows from one of free_length, pitch", "give one of them");
  if (const auto length = reader.number("free_length", Quantity::length)) spring.active_length = *length;
  if (const auto pitch = reader.number("pitch", Quantity::length))
    spring.active_length = *pitch * (spring.active_coils > 0 ? spring.active_coils : 1);
}

/// One value for both ends, or [N, K].
template <typename Value, typename Read>
std::array<Value, 2> both_ends(const std::optional<std::vector<Value>>& list, const Value& otherwise,
                               const Read& wrong) {
  if (!list) return {otherwise, otherwise};
  if (list->size() == 1) return {(*list)[0], (*list)[0]};
  if (list->size() == 2) return {(*list)[0], (*list)[1]};
  wrong();
  return {otherwise, otherwise};
}

void read_ends_of_coil(TableReader& reader, CoilSpring& spring) {
  const auto wrong = [&](const char* key) {
    return [&reader, key] {
      reader.error(key, "neither one nor two values", "one value is for both ends, two are for N and K",
                   "give one or two");
    };
  };
  const Node* dead = reader.node("dead_coils");
  std::optional<std::vector<double>> coils;
  if (dead && dead->kind == Node::Kind::array) coils = reader.numbers("dead_coils", Quantity::pure);
  else if (const auto one = reader.number("dead_coils", Quantity::pure)) coils = std::vector<double>{*one};
  const auto dead_coils = both_ends<double>(coils, 0.0, wrong("dead_coils"));
  spring.dead_coils_n = dead_coils[0];
  spring.dead_coils_k = dead_coils[1];

  const Node* seats = reader.node("ends");
  std::optional<std::vector<std::string>> words;
  if (seats && seats->kind == Node::Kind::array) words = reader.texts("ends", R"(["clamped", "pivoted"])");
  else if (const auto one = reader.text("ends")) words = std::vector<std::string>{*one};
  const auto ends = both_ends<std::string>(words, "clamped", wrong("ends"));
  for (const std::string& word : ends)
    if (word != "clamped" && word != "pivoted")
      reader.error("ends", "\"" + word + "\"",
                   "a seat is \"clamped\" or \"pivoted\" (no moment about the lateral axes)", "choose one of them");
  spring.seat_n = ends[0] == "pivoted" ? elements::Seat::pivoted : elements::Seat::clamped;
  spring.seat_k = ends[1] == "pivoted" ? elements::Seat::pivoted : elements::Seat::clamped;
}

void add_facts(const CoilSpring& spring, double distance, model::Element& element) {
  const elements::Matrix12& k = element.law.nominal_stiffness;
  element.facts.push_back({"spring index D/d", fmt::format("{:.4g}", elements::spring_index(spring))});
  element.facts.push_back({"distance of its seats", foundation::prefixed_exactly(distance, "m", 6)});
  element.facts.push_back({"axial stiffness", foundation::prefixed_exactly(k(8, 8), "N/m", 6)});
  element.facts.push_back({"lateral stiffness",
                           fmt::format("{} and {}", foundation::prefixed_exactly(k(6, 6), "N/m", 6),
                                       foundation::prefixed_exactly(k(7, 7), "N/m", 6))});
}

/// Reads mass and frequency dependence of the spring in the state `seated`, which needs a density.
void read_level(TableReader& reader, const std::optional<elements::SeatedCoil>& seated, const std::string& level,
                model::Element& element) {
  if (seated) {
    element.massless_up_to = elements::natural_frequencies(*seated, elements::SeatsHeld::both, 1).front();
    element.facts.push_back(
        {"first own natural frequency, both seats held", foundation::hertz_words(element.massless_up_to, 6)});
  }
  const auto modes = reader.number("internal_modes", Quantity::pure);
  if (modes && level == "quasi_static")
    reader.error("internal_modes", "internal_modes without mass", "a quasi_static spring has none",
                 "set level = \"with_mass\" or \"exact\", or remove it");
  if (modes && !(*modes >= 0 && *modes <= most_internal_modes && *modes == std::floor(*modes))) {
    reader.error("internal_modes", fmt::format("{:.6g}", *modes),
                 fmt::format("a whole number from 0 to {}", most_internal_modes), "four to ten are usual");
    return;
  }
  if (level == "quasi_static" || !seated) return;
  const elements::SeatedCoil& coil = *seated;
  const elements::ReducedCoil own = elements::reduced(coil, modes ? static_cast<int>(*modes) : default_internal_modes);
  element.law.inertia = elements::Inertia{own.mass, own.coupling, own.natural_frequencies};
  const Eigen::Matrix<double, 12, 1> along =
      (Eigen::Matrix<double, 12, 1>() << 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0).finished();
  element.facts.push_back({"own mass", fmt::format("{:.6g} kg", along.dot(own.mass * along))});
  if (level == "exact") {
    element.law.frequency_dependence = elements::FrequencyDependence{};
    element.law.frequency_dependence->stiffness = [coil](std::complex<double> omega, double) {
      return elements::dynamic_stiffness(coil, omega);
    };
  }
  element.massless_up_to = std::numeric_limits<double>::infinity();
}

/// preload = {compression = …} or {force = …}: the state about which the spring vibrates.
std::optional<elements::CompressedCoil> read_compressed(TableReader& reader, const CoilSpring& spring) {
  const std::size_t before = reader.errors();
  const auto request = read_compression(reader);
  if (!request || reader.errors() > before) return std::nullopt;
  TableReader preload(*reader.table("preload"), reader.path() + ".preload", reader.problems());
  const char* key = request->is_force ? "force" : "compression";
  if (spring.seat_n == elements::Seat::pivoted || spring.seat_k == elements::Seat::pivoted) {
    reader.error("ends", "\"pivoted\" with a preload",
                 "a pivot cannot carry the moment that keeps a compressed spring from tilting",
                 "clamp both seats, or remove the preload");
    return std::nullopt;
  }
  try {
    elements::CompressedCoil state = request->is_force ? elements::compressed_with(spring, request->value)
                                                       : elements::compressed_by(spring, request->value);
    foundation::Problems findings = elements::check_compression(spring, state.compression);
    for (foundation::Problem& problem : findings.list()) problem.subject = key;
    preload.add(findings);
    if (findings.has_errors()) return std::nullopt;
    return state;
  } catch (const foundation::InvalidInput& reason) {
    preload.error(key, reason.what(), "this compression must be possible", "lower the preload");
  } catch (const foundation::NotComputable& reason) {
    preload.error(key, reason.what(), "the loaded spring must be in equilibrium",
                  "lower the preload, and check its sign and unit");
  }
  return std::nullopt;
}

void add_preload_facts(const CoilSpring& spring, const elements::CompressedCoil& state, model::Element& element) {
  element.facts.push_back({"preload",
                           fmt::format("{}, compressed by {}", foundation::prefixed_exactly(state.axial_force, "N", 6),
                                       foundation::prefixed_exactly(state.compression, "m", 6))});
  const auto limit = elements::buckling(spring, elements::SeatsHeld::both);
  element.facts.push_back({"buckles between parallel seats",
                           limit ? fmt::format("at {}, {}", foundation::prefixed_exactly(limit->axial_force, "N", 6),
                                               foundation::prefixed_exactly(limit->compression, "m", 6))
                                 : "not before its coils touch"});
  const auto standard = elements::standard_buckling(spring);
  element.facts.push_back({"the same by EN 13906-1, with smeared coils",
                           standard ? fmt::format("at {}", foundation::prefixed_exactly(*standard, "m", 6))
                                    : "not before its coils touch"});
  const bool round = std::holds_alternative<elements::RoundWire>(spring.wire);
  const double stress = round ? elements::wahl_shear_stress(spring, state.axial_force)
                              : elements::nominal_shear_stress(spring, state.axial_force);
  element.facts.push_back(
      {round ? "shear stress of the wire, Wahl's factor included" : "nominal shear stress of the wire",
       fmt::format("{:.6g} MPa", 1e-6 * stress)});
}

/// coil_bind = true: the coils touch, one after the other. The closed spring is taken as a hundred times as stiff as
/// the open one, with a little damping: far softer than its wire, and stiff enough to limit the travel.
void read_coil_bind(TableReader& reader, const CoilSpring& spring, model::Element& element) {
  if (!reader.boolean("coil_bind").value_or(false)) return;
  if (reader.has("preload")) {
    reader.error("coil_bind", "coil_bind with a preload", "its travel is counted from the free length",
                 "remove the preload, and let gravity or a constant force compress the spring");
    return;
  }
  const auto* round = std::get_if<elements::RoundWire>(&spring.wire);
  const double height = round ? round->diameter : std::get<elements::RectangularWire>(spring.wire).axial_height;
  constexpr double stiffer = 100;
  elements::GapStop bind;
  bind.gap_below = spring.active_length - spring.active_coils * height;
  bind.stiffness = stiffer * element.law.nominal_stiffness(8, 8);
  bind.dissipation = 0.5;  // [s/m]
  if (!(bind.gap_below > 0)) {
    reader.error("coil_bind", fmt::format("a travel of {:.6g} m", bind.gap_below),
                 "the coils do not touch when unloaded", "check free_length, active_coils and the wire");
    return;
  }
  constexpr int along = 2;
  constexpr double middle = 0.5;
  element.nonlinear_parts.push_back({along, middle, {elements::ElasticForce(bind)}});
  element.facts.push_back({"travel until its coils touch", foundation::prefixed_exactly(bind.gap_below, "m", 6)});
}

ElementLength read_coil_spring(TableReader& reader, model::Element& element) {
  const std::size_t before = reader.errors();
  reader.also_known({"preload", "internal_modes", "coil_bind"});
  CoilSpring spring = read_coil(reader);
  if (const auto factor = reader.number("shear_factor", Quantity::pure)) spring.shear_factor = *factor;
  const std::string level = reader.choice("level", {"quasi_static", "with_mass", "exact"}).value_or("quasi_static");
  if (const auto metal = read_metal(reader)) {
    spring.youngs_modulus = metal->young_modulus;
    spring.shear_modulus = metal->shear_modulus;
    spring.density = metal->density;
    if (level != "quasi_static" && std::isnan(metal->density))
      reader.error("material", "no density", "a spring with mass needs one",
                   "add density, or level = \"quasi_static\"");
  }
  reader.add(elements::check(spring, level != "quasi_static"),
             {{"active_length", reader.has("pitch") ? "pitch" : "free_length"},
              {"youngs_modulus", "material"},
              {"shear_modulus", "material"},
              {"density", "material"},
              {"dead_coils_n", "dead_coils"},
              {"dead_coils_k", "dead_coils"}});
  if (reader.errors() > before) return std::nullopt;
  element.law.nominal_stiffness = elements::stiffness(spring);
  double distance = elements::seat_distance(spring);
  std::optional<elements::SeatedCoil> seated;
  if (!std::isnan(spring.density)) seated = elements::seated_coil(spring);
  if (const auto compressed = read_compressed(reader, spring)) {
    element.law.nominal_stiffness = compressed->stiffness;
    element.law.preload = compressed->preload;
    if (seated) seated = compressed->coil;
    distance = compressed->seat_distance;
    add_preload_facts(spring, *compressed, element);
  }
  if (reader.errors() > before) return std::nullopt;
  add_facts(spring, distance, element);
  read_coil_bind(reader, spring, element);
  read_level(reader, seated, level, element);
  return distance;
}

}  // namespace

CoilSpring read_coil(TableReader& reader) {
  CoilSpring spring;
  read_wire(reader, spring);
  spring.mean_diameter = reader.required_number("mean_diameter", Quantity::length);
  spring.active_coils = reader.required_number("active_coils", Quantity::pure);
  read_length(reader, spring);
  read_ends_of_coil(reader, spring);
  spring.hand = reader.choice("hand", {"right", "left"}) == "left" ? elements::Hand::left : elements::Hand::right;
  spring.start_angle = reader.number("start_angle", Quantity::angle).value_or(0);
  return spring;
}

const ElementLaw coil_spring_law = {
    .type = "coil_spring",
    .sized = read_coil_spring,
    .keys = R"json({"properties": {
   "wire_diameter": {"$ref": "#/$defs/number", "description": "round wire, m, > 0"},
   "wire_width": {"$ref": "#/$defs/number", "description": "rectangular wire, radial side, m, > 0"},
   "wire_height": {"$ref": "#/$defs/number", "description": "rectangular wire, axial side, m, > 0"},
   "mean_diameter": {"$ref": "#/$defs/number",
     "description": "of the coils, m; at least 3 times the radial size of the wire"},
   "active_coils": {"$ref": "#/$defs/number", "description": "number of turns, >= 0.25"},
   "free_length": {"$ref": "#/$defs/number",
     "description": "of the active coils, wire centre to wire centre, m; or pitch"},
   "pitch": {"$ref": "#/$defs/number", "description": "m per turn; or free_length"},
   "dead_coils": {"description": "closed turns at each end (default: 0), or [N, K]",
     "anyOf": [{"$ref": "#/$defs/number"}, {"type": "array", "items": {"$ref": "#/$defs/number"}, "minItems": 1,
     "maxItems": 2}]},
   "ends": {"description": "seats (default: clamped), or [N, K]; a pivoted one carries no moment about the )json"
            R"json(lateral axes", "anyOf": [{"enum": ["clamped", "pivoted"]}, {"type": "array", "items": {"enum": )json"
            R"json(["clamped", "pivoted"]}, "minItems": 1, "maxItems": 2}]},
   "hand": {"enum": ["right", "left"], "description": "in which the wire winds (default: right)"},
   "start_angle": {"$ref": "#/$defs/number", "description": "of the wire at end N, about e3 from e1, rad (default: 0)"},
   "shear_factor": {"$ref": "#/$defs/number", "description": "of the wire's section, > 0 (default: Cowper's)"},
   "level": {"enum": ["quasi_static", "with_mass", "exact"],
     "description": "stiffness alone; with mass and internal modes; frequency-dependent (default: quasi_static)"},
   "internal_modes": {"type": "integer", "minimum": 0, "maximum": 60, "description": "with mass (default: 6)"},
   "material": {"$ref": "#/$defs/metal"},
   "coil_bind": {"type": "boolean", "description": "the coils touch and stop the spring (default: false)"},
   "preload": {"$ref": "#/$defs/preload"}},
  "required": ["mean_diameter", "active_coils", "material"],
  "allOf": [{"oneOf": [{"required": ["free_length"]}, {"required": ["pitch"]}]}, {"anyOf": [{"required": )json"
            R"json(["wire_diameter"], "properties": {"wire_width": false, "wire_height": false}}, {"required": )json"
            R"json(["wire_width", "wire_height"], "properties": {"wire_diameter": false}}]}]})json"};

}  // namespace trivet::project
