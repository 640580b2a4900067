// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/part_readers.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

#include "trivet/foundation/plain_text.h"
#include "trivet/project/elements/adjustments_reader.h"

namespace trivet::project {

namespace {

/// All may move in one direction (analysis_sizes.h).
constexpr std::size_t most_bodies = 1000;
/// Each has six channels.
constexpr std::size_t most_body_points = 5000;

/// Fills mass, centre and inertia; returns whether an inertia was given.
/// @param usual  what it is about without the key; none: the key is required
bool read_inertia(TableReader& body, spatial::MassProperties& mass, const std::optional<std::string>& usual = {}) {
  const Node* table = body.table("inertia");
  if (!table) return false;
  TableReader reader(*table, body.path() + ".inertia", body.problems());
  if (!reader.has("about") && !usual) reader.missing("about", "write about = \"pole\" or about = \"center_of_mass\"");
  const auto given = reader.choice("about", {"pole", "center_of_mass"});
  const std::optional<std::string> about = given ? std::string(*given) : usual;
  Eigen::Matrix3d j;
  const double xx = reader.required_number("xx", Quantity::inertia),
               yy = reader.required_number("yy", Quantity::inertia),
               zz = reader.required_number("zz", Quantity::inertia);
  const double xy = reader.number("xy", Quantity::inertia).value_or(0),
               xz = reader.number("xz", Quantity::inertia).value_or(0),
               yz = reader.number("yz", Quantity::inertia).value_or(0);
  reader.finish();
  j << xx, -xy, -xz, -xy, yy, -yz, -xz, -yz, zz;
  if (about == "pole") mass = spatial::from_inertia_about_pole(mass.mass, mass.centre, j);
  else mass.inertia_about_centre = j;
  return true;
}

/// Masses beside solids: `parts = [{mass = 120, at = [0, 0, 0.4], inertia = {…}}, …]`, without inertia a point mass.
std::vector<spatial::MassProperties> read_parts(TableReader& body) {
  std::vector<spatial::MassProperties> parts;
  const Node* list = body.node("parts");
  if (!list) return parts;
  if (!body.has("solids"))
    body.error("parts", "parts without solids", "parts are masses beside the solids of a body",
               "add solids, or describe the body by mass, center_of_mass and inertia");
  if (list->kind != Node::Kind::array) {
    body.error("parts", kind_name(list->kind), "it is a list of masses",
               "write parts = [{mass = 120, at = [0, 0, 0.4]}]");
    return parts;
  }
  for (std::size_t i = 0; i < list->items.size(); ++i) {
    const std::string name = fmt::format("parts[{}]", i);
    if (list->items[i].kind != Node::Kind::table) {
      body.error("parts", kind_name(list->items[i].kind), "a part is a table",
                 "write {mass = …, at = [x, y, z]}, and inertia if it is not a point mass");
      continue;
    }
    TableReader reader(list->items[i], body.path() + "." + name, body.problems());
    const std::size_t before = body.errors();
    spatial::MassProperties part;
    part.mass = reader.required_number("mass", Quantity::mass);
    if (body.errors() == before && !(part.mass > 0))
      reader.error("mass", fmt::format("{:.6g} kg", part.mass), "a mass must be > 0", "correct it");
    part.centre = reader.vector("at", Quantity::length).value_or(Eigen::Vector3d::Zero());
    const bool has_inertia = read_inertia(reader, part, "center_of_mass");  // `at` is that of the part
    if (has_inertia && body.errors() == before)
      for (const spatial::ViolatedBound& bound : spatial::violated_bounds(part))
        reader.error("inertia", bound.finding, bound.rule, "correct mass, place and inertia");
    reader.finish();
    if (body.errors() == before) parts.push_back(part);
  }
  return parts;
}

void read_points(TableReader& reader, model::Body& body, SymbolTable& symbols) {
  const Node* table = reader.table("points");
  if (!table) return;
  TableReader points(*table, reader.path() + ".points", reader.problems());
  if (table->keys.size() > most_body_points) {
    reader.error("points", fmt::format("{} points", table->keys.size()),
                 fmt::format("a body has at most {}", most_body_points), "keep the points that are needed");
    return;
  }
  for (const std::string& name : table->keys) {
    symbols.points.push_back(body.name + "." + name);
    if (const auto at = points.vector(name, Quantity::length)) body.points.push_back({name, *at});
  }
}

void add_guided_names(const model::Body& body, SymbolTable& symbols) {
  for (std::size_t j = 0; j < 6; ++j)
    if (!body.free[j]) symbols.guided.push_back(body.name + "." + model::coordinate_names[j]);
}

void add_names(const model::Body& body, SymbolTable& symbols) {
  for (const model::Point& point : body.points) symbols.points.push_back(body.name + "." + point.name);
  add_guided_names(body, symbols);
}

std::optional<model::Body> known_body(const KnownModel& known, const std::string& name, const Node& now) {
  if (!known.unchanged("bodies", name, now)) return std::nullopt;
  const auto& bodies = known.description.bodies;
  const auto found = std::ranges::find(bodies, name, &model::Body::name);
  return found == bodies.end() ? std::nullopt : std::optional(*found);
}

model::Body read_body(const Node& node, const std::string& name, std::size_t index, SymbolTable& symbols,
                      foundation::Problems& problems) {
  TableReader reader(node, "bodies." + name, problems);
  model::Body body;
  body.name = name;
  body.allow_unphysical = reader.boolean("allow_unphysical").value_or(false);
  if (reader.has("solids")) {
    for (const char* key : {"center_of_mass", "inertia"}) {
      if (reader.has(key))
        reader.error(key, std::string(key) + " together with solids", "the solids give centre and inertia",
                     "remove it, or remove solids");
      static_cast<void>(reader.node(key));
    }
    static_cast<void>(read_solids(reader, {.lumps = read_parts(reader)}, body));
  } else {
    body.mass.mass = reader.required_number("mass", Quantity::mass);
    body.mass.centre = reader.vector("center_of_mass", Quantity::length).value_or(Eigen::Vector3d::Zero());
    body.has_inertia = read_inertia(reader, body.mass);
    if (reader.has("parts")) static_cast<void>(read_parts(reader));
    else reader.also_known({"parts"});
  }
  body.pose.position = reader.vector("position", Quantity::length).value_or(Eigen::Vector3d::Zero());
  body.pose.rotation = reader.orientation("orientation").value_or(Eigen::Matrix3d::Identity());
  read_points(reader, body, symbols);
  read_free(reader, body, symbols);
  if (!reader.has("inertia") && !reader.has("solids") && (body.free[3] || body.free[4] || body.free[5]))
    reader.missing("inertia",
                   "a body that can turn needs inertia = {about = \"center_of_mass\", xx = …, yy = …, zz = …}; a point "
                   "mass has xx = 0, yy = 0, zz = 0");
  read_body_adjustments(reader, body, index, symbols);
  reader.finish();
  return body;
}

}  // namespace

void read_free(TableReader& reader, model::Body& body, SymbolTable& symbols) {
  const auto names = reader.texts("free", R"(["x", "y"])");
  if (!names) return;
  body.free.fill(false);
  for (const std::string& name : *names) {
    const auto found = std::ranges::find(model::coordinate_names, name);
    if (found != model::coordinate_names.end() && body.free[found - model::coordinate_names.begin()])
      reader.error("free", "\"" + name + "\" twice", "each coordinate is named once", "remove one");
    else if (found != model::coordinate_names.end()) body.free[found - model::coordinate_names.begin()] = true;
    else
      reader.error("free", foundation::quoted(name), "a coordinate is one of x, y, z, rx, ry, rz",
                   "name the coordinates that move");
  }
  add_guided_names(body, symbols);
}

void read_bodies(TableReader& root, model::Description& description, SymbolTable& symbols, const KnownModel* known) {
  const Node* table = root.table("bodies");
  symbols.bodies_unknown = !table;
  if (!table) {
    if (!root.has("bodies")) root.missing("bodies", "describe at least one body: [bodies.NAME]");
    return;
  }
  if (table->keys.size() > most_bodies)
    root.error("bodies", fmt::format("{} bodies", table->keys.size()),
               fmt::format("this version takes at most {}", most_bodies), "split the model");
  symbols.bodies = table->keys;
  for (std::size_t i = 0; i < table->keys.size() && i < most_bodies; ++i) {
    const auto earlier = known ? known_body(*known, table->keys[i], table->items[i]) : std::nullopt;
    if (earlier) {
      add_names(*earlier, symbols);
      description.bodies.push_back(*earlier);
    } else if (table->items[i].kind == Node::Kind::table) {
      description.bodies.push_back(
          read_body(table->items[i], table->keys[i], description.bodies.size(), symbols, root.problems()));
    } else {
      root.problems()
          .error("bodies." + table->keys[i], kind_name(table->items[i].kind), "a body is a table",
                 "write [bodies.NAME] and its mass below")
          .origin = table->items[i].origin;
    }
  }
}

namespace {

/// Each has up to six coordinates.
constexpr std::size_t most_nodes = 200;

model::Body read_node(const Node& node, const std::string& name, SymbolTable& symbols, foundation::Problems& problems) {
  TableReader reader(node, "nodes." + name, problems);
  model::Body body;
  body.name = name;
  body.is_node = true;
  body.mass.mass = 0;
  body.mass.centre.setZero();
  body.mass.inertia_about_centre.setZero();
  body.pose.position = reader.vector("position", Quantity::length).value_or(Eigen::Vector3d::Zero());
  if (!reader.has("position")) reader.missing("position", "give its place in the ground frame: position = [x, y, z]");
  body.pose.rotation = reader.orientation("orientation").value_or(Eigen::Matrix3d::Identity());
  read_free(reader, body, symbols);
  for (const char* key : {"mass", "inertia", "center_of_mass", "solids", "parts", "points"}) {
    if (!reader.has(key)) continue;
    reader.error(key, "unknown key", "a node has no mass and is one place: position, orientation and free",
                 "describe a part with mass or several points as a body: [bodies.NAME]");
    static_cast<void>(reader.node(key));
  }
  reader.finish();
  return body;
}

}  // namespace

void read_nodes(TableReader& root, model::Description& description, SymbolTable& symbols) {
  const Node* table = root.table("nodes");
  if (!table) {
    symbols.bodies_unknown = symbols.bodies_unknown || root.has("nodes");
    return;
  }
  if (table->keys.size() > most_nodes)
    root.error("nodes", fmt::format("{} nodes", table->keys.size()),
               fmt::format("this version takes at most {}", most_nodes), "split the model");
  symbols.nodes = table->keys;
  for (std::size_t i = 0; i < table->keys.size() && i < most_nodes; ++i)
    if (table->items[i].kind == Node::Kind::table)
      description.bodies.push_back(read_node(table->items[i], table->keys[i], symbols, root.problems()));
    else
      root.problems()
          .error("nodes." + table->keys[i], kind_name(table->items[i].kind), "a node is a table",
                 "write [nodes.NAME] and its position below")
          .origin = table->items[i].origin;
}

}  // namespace trivet::project
