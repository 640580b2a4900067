// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/part_readers.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "trivet/foundation/index.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/project/elements/element_table_readers.h"
#include "trivet/project/measured/ground_mobility.h"
#include "trivet/project/measured/measured_file.h"
#include "trivet/project/measured/mobility_reader.h"
#include "trivet/project/text/shared_keys.h"

namespace trivet::project {
namespace {

/// One foundation of the file, before its elements are put on it.
struct Ground {
  GroundPoints separate;  ///< a ground point under each element
  bool modal = false;     ///< modes that all its elements share take their place
  std::size_t index = 0;  ///< of the shared foundation
  std::map<std::string, Eigen::Matrix<double, 6, Eigen::Dynamic>> shapes;
};

std::vector<int> read_directions(TableReader& reader, bool with_rotation) {
  std::vector<int> directions;
  const auto names = reader.texts("free", R"(["x", "y"])");
  for (int j = 0; j < (with_rotation ? 6 : 3) && !names; ++j) directions.push_back(j);
  if (!names) return directions;
  for (const std::string& name : *names) {
    const auto at = std::ranges::find(model::coordinate_names, name);
    const auto j = static_cast<int>(at - model::coordinate_names.begin());
    if (j == 6)
      reader.error("free", foundation::quoted(name), "a direction is one of x, y, z, rx, ry, rz",
                   "for instance free = [\"z\"]");
    else if (j > 2 && !with_rotation)
      reader.error("free", "\"" + name + "\"", "a ground point that rotates needs a rotational stiffness",
                   "add rotation = [krx, kry, krz]");
    else if (std::ranges::find(directions, j) != directions.end())
      reader.error("free", "\"" + name + "\" twice", "each direction is named once", "remove one");
    else directions.push_back(j);
  }
  if (directions.empty())
    reader.error("free", "no direction", "a flexible foundation has at least one compliant direction",
                 "remove the foundation, or name one");
  return directions;
}

GroundPoints read_impedance(TableReader& reader) {
  GroundPoints ground;
  const bool turns = reader.has("rotation");
  ground.directions = read_directions(reader, turns);
  elements::Vector6 k;
  k << reader.vector("translation", Quantity::force_per_length).value_or(Eigen::Vector3d::Zero()),
      reader.vector("rotation", Quantity::moment_per_angle).value_or(Eigen::Vector3d::Zero());
  if (!reader.has("translation"))
    reader.missing("translation", "give the stiffness of a ground point: translation = [kx, ky, kz]");
  for (const int j : ground.directions)
    if (!(k(j) > 0) && reader.has("translation"))
      reader.error(j < 3 ? "translation" : "rotation", fmt::format("{:.6g} for {}", k(j), model::coordinate_names[j]),
                   "the stiffness of a compliant direction is > 0", "name the compliant directions: free = [\"z\"]");
  if (turns && !ground.directions.empty() && std::ranges::none_of(ground.directions, [](int j) { return j > 2; }))
    warn_at_key(reader, "rotation", "rotation of a ground point that does not rotate", "`free` names no rotation",
                "add rx, ry or rz to `free`, or remove it");
  const double mass = reader.number("mass", Quantity::mass).value_or(0);
  const Eigen::Vector3d inertia = reader.vector("inertia", Quantity::inertia).value_or(Eigen::Vector3d::Zero());
  if (mass < 0) reader.error("mass", fmt::format("{:.6g} kg", mass), "it is ≥ 0", "remove the sign");
  if (inertia.minCoeff() < 0)
    reader.error("inertia", "a negative moment of inertia", "all three are ≥ 0", "remove the sign");
  if (reader.has("inertia") && !turns)
    reader.error("inertia", "inertia without rotation", "a ground point that does not rotate needs no inertia",
                 "add rotation = [krx, kry, krz], or remove it");
  ground.mass << Eigen::Vector3d::Constant(mass), inertia;
  ground.impedance.law.nominal_stiffness = elements::constants_at_point(k, Eigen::Vector3d::Zero(), 1);
  read_damping(reader, {Eigen::Vector3d::Zero(), Eigen::Matrix3d::Identity()}, 1, ground.impedance);
  return ground;
}

/// Nodes of a universal file and the elements on them.
std::vector<int> read_ground_nodes(TableReader& reader, std::map<std::string, std::size_t>& points) {
  std::vector<int> numbers;
  const Node* table = reader.table("nodes");
  if (!table) return numbers;
  TableReader nodes(*table, reader.path() + ".nodes", reader.problems());
  for (const std::string& key : table->keys) {
    const auto number = node_number(key);
    const auto element = nodes.text(key);
    if (!number || *number <= 0)
      nodes.error(key, foundation::quoted(key), "the key is the number of a node of the file", "for instance \"11\"");
    if (!number || *number <= 0 || !element) continue;
    if (std::ranges::find(numbers, *number) != numbers.end())
      nodes.error(key, foundation::quoted(key), "each node is named once", "remove one");
    if (!points.emplace(*element, numbers.size()).second)
      nodes.error(key, foundation::quoted(*element) + " twice", "an element is on one node", "remove one");
    numbers.push_back(*number);
  }
  if (table->keys.empty())
    reader.error("nodes", "no node", "the ground points of the file are under elements",
                 "nodes = {\"11\" = \"ELEMENT\"} with the node of each ground point");
  return numbers;
}

GroundPoints read_mobility(TableReader& reader) {
  GroundPoints ground;
  const std::size_t before = reader.errors();
  std::optional<GroundMobility> mobility;
  if (reader.has("nodes")) {
    const std::vector<int> nodes = read_ground_nodes(reader, ground.points);
    reader.also_known({"file"});
    if (reader.errors() == before) mobility = read_universal_mobility(reader, nodes);
  } else {
    mobility = read_mobility_table(reader);
  }
  if (mobility) ground.mobility = std::make_shared<const GroundMobility>(std::move(*mobility));
  return ground;
}

Ground read_modal(TableReader& reader, const std::string& name, model::Description& description) {
  Ground ground;
  ground.modal = true;
  const Node* list = reader.node("modes");
  if (!list || list->kind != Node::Kind::array || list->items.empty()) {
    reader.error(
        "modes",
        !list                     ? "missing"
            : list->items.empty() ? "empty"
                                  : kind_name(list->kind),
        "a list of at least one mode is expected",
        "modes = [{frequency = \"12 Hz\", modal_mass = 800, damping = 0.02, shapes = {\"MOUNT\" = [0, 0, 1]}}]");
    return ground;
  }
  const auto count = to_index(list->items.size());
  model::Foundation shared{name, Eigen::MatrixXd::Zero(count, count), Eigen::MatrixXd::Zero(count, count),
                           Eigen::MatrixXd::Zero(count, count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const Node& node = list->items[i];
    if (node.kind != Node::Kind::table) {
      reader.error("modes", fmt::format("mode {} is {}", i + 1, kind_name(node.kind)), "a mode is a table",
                   "{frequency = …, modal_mass = …, damping = …, shapes = {…}}");
      continue;
    }
    TableReader mode(node, fmt::format("{}.modes[{}]", reader.path(), i), reader.problems());
    const double omega = mode.required_number("frequency", Quantity::angular_frequency),
                 mass = mode.number("modal_mass", Quantity::mass).value_or(1),
                 ratio = mode.number("damping", Quantity::pure).value_or(0);
    if (mode.has("frequency") && !(omega > 0))
      mode.error("frequency", value_text(*mode.node("frequency"), 0), "it is > 0", "correct it");
    if (!(mass > 0)) mode.error("modal_mass", fmt::format("{:.6g} kg", mass), "it is > 0", "correct it");
    if (!(ratio >= 0)) mode.error("damping", fmt::format("{:.6g}", ratio), "a damping ratio is ≥ 0", "correct it");
    shared.mass(i, i) = mass;
    shared.damping(i, i) = 2 * ratio * omega * mass;
    shared.stiffness(i, i) = omega * omega * mass;
    const Node* shapes = mode.table("shapes");
    if (!shapes) mode.missing("shapes", "give the motion of each mount in this mode: shapes = {\"MOUNT\" = [x, y, z]}");
    TableReader places(shapes ? *shapes : node, mode.path() + ".shapes", reader.problems());
    for (std::size_t s = 0; shapes && s < shapes->keys.size(); ++s) {
      const auto values = places.numbers(shapes->keys[s], Quantity::pure);
      if (!values) continue;
      if (values->size() != 3 && values->size() != 6) {
        places.error(shapes->keys[s], fmt::format("{} numbers", values->size()),
                     "three (x, y, z) or six (with rx, ry, rz) are expected", "complete the list");
        continue;
      }
      auto& shape = ground.shapes[shapes->keys[s]];
      if (shape.cols() == 0) shape.setZero(6, count);
      for (std::size_t j = 0; j < values->size(); ++j) shape(to_index(j), i) = (*values)[j];
    }
    mode.finish();
  }
  ground.index = description.foundations.size();
  description.foundations.push_back(std::move(shared));
  return ground;
}

/// Reports what a foundation has for a mount that is not on it. Shapes then have no effect; a ground point without a
/// mount would be free of forces, but its mobility could not be used, so that is an error.
/// @param key, thing  "modes" and "shapes", or "nodes" and "a node"
void report_idle_mount(TableReader& root, const std::string& ground, const std::string& mount, const std::string& key,
                       const std::string& thing, const SymbolTable& symbols) {
  if (std::ranges::any_of(symbols.foundation_references, [&](const SymbolTable::FoundationReference& one) {
        return one.element == mount && one.ground == ground;
      }))
    return;
  const std::string subject = "foundations." + ground + "." + key;
  const Node* origin = root.node("foundations")->find(ground)->find(key);
  const std::string finding = fmt::format("{} of {}", thing, foundation::quoted(mount));
  if (std::ranges::find(symbols.elements, mount) != symbols.elements.end()) {
    const std::string rule = "this element is not on the foundation",
                      remedy = "add foundation = \"" + ground + "\" to it, or remove " + thing;
    foundation::Problem& problem = key == "nodes" ? root.problems().error(subject, finding, rule, remedy)
                                                  : root.problems().warning(subject, finding, rule, remedy);
    problem.origin = origin->origin;
    return;
  }
  const std::string guess = foundation::nearest_name(mount, symbols.elements);
  root.problems()
      .error(subject, finding, "no element has this name",
             guess.empty() ? "check the name" : "did you mean \"" + guess + "\"?")
      .origin = origin->origin;
}

}  // namespace

void read_foundations(TableReader& root, model::Description& description, SymbolTable& symbols) {
  const Node* table = root.table("foundations");
  std::map<std::string, Ground> grounds;
  for (std::size_t i = 0; table && i < table->keys.size(); ++i) {
    const std::string& name = table->keys[i];
    if (table->items[i].kind != Node::Kind::table) {
      root.problems()
          .error("foundations." + name, kind_name(table->items[i].kind), "a foundation is a table",
                 "write [foundations.NAME] and its type below")
          .origin = table->items[i].origin;
      continue;
    }
    TableReader reader(table->items[i], "foundations." + name, root.problems());
    reader.required_text("type");
    const auto type = reader.choice("type", {"impedance", "mobility", "modal"});
    if (type == "impedance") grounds[name].separate = read_impedance(reader);
    if (type == "mobility") grounds[name].separate = read_mobility(reader);
    if (type == "modal") grounds[name] = read_modal(reader, name, description);
    if (type) reader.finish();
    if (std::ranges::none_of(symbols.foundation_references,
                             [&](const SymbolTable::FoundationReference& one) { return one.ground == name; }))
      reader.problems()
          .warning("foundations." + name, "no element is on it", "a foundation acts only under elements that name it",
                   "add foundation = \"" + name + "\" to them")
          .origin = table->items[i].origin;
  }
  for (const auto& [name, ground] : grounds) {
    for (const auto& [mount, shape] : ground.shapes) report_idle_mount(root, name, mount, "modes", "shapes", symbols);
    for (const auto& [mount, point] : ground.separate.points)
      report_idle_mount(root, name, mount, "nodes", "a node", symbols);
  }
  std::vector<std::string> names = table ? table->keys : std::vector<std::string>{};
  for (const auto& [element_name, ground_name, origin] : symbols.foundation_references) {
    const std::string subject = "elements." + element_name + ".foundation";
    const auto element = std::ranges::find_if(
        description.elements, [&, wanted = element_name](const model::Element& e) { return e.name == wanted; });
    if (std::ranges::find(names, ground_name) == names.end()) {
      const std::string guess = foundation::nearest_name(ground_name, names);
      root.problems()
          .error(subject, foundation::quoted(ground_name), "no foundation has this name",
                 guess.empty() ? "add [foundations.NAME]" : "did you mean \"" + guess + "\"?")
          .origin = origin;
      continue;
    }
    const auto ground = grounds.find(ground_name);
    if (element == description.elements.end() || ground == grounds.end()) continue;  // reported elsewhere
    if (!element->n.on_ground()) {
      root.problems()
          .error(subject, "an element between two bodies", "a foundation is under an end that is on the ground",
                 "remove it, or remove `from`")
          .origin = origin;
    } else if (ground->second.modal) {
      const auto shape = ground->second.shapes.find(element_name);
      if (shape == ground->second.shapes.end())
        root.problems()
            .error(subject, "\"" + ground_name + "\"", "no mode of this foundation has a shape for this element",
                   "add shapes = {\"" + element_name + "\" = [x, y, z]} to its modes")
            .origin = origin;
      else element->n.foundation = model::OnFoundation{ground->second.index, shape->second, spatial::Matrix6::Zero()};
    } else if (GroundPoints& points = ground->second.separate; points.mobility || !points.directions.empty()) {
      if (!points.points.empty() && !points.points.contains(element_name))
        root.problems()
            .error(subject, "\"" + ground_name + "\"", "this foundation has no node for this element",
                   "add nodes = {\"11\" = \"" + element_name + "\"} with the number of its node in the file")
            .origin = origin;
      else add_ground_point(points, element_name, description);
    }
  }
  for (const auto& [name, ground] : grounds) add_couplings(ground.separate, description);
}

}  // namespace trivet::project
