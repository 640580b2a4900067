// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/part_readers.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "trivet/foundation/plain_text.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::project {
namespace {

constexpr std::size_t most_observations = 1000;  // of each table

/// Reads the tables in a table, and lists their names.
void read_each(TableReader& root, const char* table, const std::string& rule, const std::string& remedy,
               std::vector<std::string>& names,
               const std::function<void(TableReader& reader, const std::string& name)>& read) {
  const Node* tables = root.table(table);
  if (!tables) return;
  if (tables->keys.size() > most_observations) {
    root.error(table, fmt::format("{} of them", tables->keys.size()),
               fmt::format("at most {} are allowed", most_observations), "keep those that are needed");
    return;
  }
  names = tables->keys;
  for (std::size_t i = 0; i < tables->keys.size(); ++i) {
    const std::string path = std::string(table) + "." + tables->keys[i];
    if (tables->items[i].kind != Node::Kind::table) {
      root.problems().error(path, kind_name(tables->items[i].kind), rule, remedy).origin = tables->items[i].origin;
      continue;
    }
    TableReader reader(tables->items[i], path, root.problems());
    read(reader, tables->keys[i]);
    reader.finish();
  }
}

class PlaceReader {
 public:
  PlaceReader(const model::Description& description, const SymbolTable& symbols)
      : description_(description), in_file_(symbols) {}

  /// None if it is not known; that is a problem unless the part could not be read.
  std::optional<model::Place> place(TableReader& reader, const std::string& key, const std::string& name) const {
    if (name == "ground") return model::Place{name, std::nullopt};
    for (std::size_t b = 0; b < description_.bodies.size(); ++b) {
      const model::Body& body = description_.bodies[b];
      if (name == body.name) return model::Place{name, b};
      for (const model::Point& point : body.points)
        if (name == body.name + "." + point.name) return model::Place{name, b, point.at};
    }
    std::vector<std::string> known = in_file_.bodies;
    for (const auto* more : {&in_file_.nodes, &in_file_.points}) known.insert(known.end(), more->begin(), more->end());
    if (in_file_.bodies_unknown || std::ranges::find(known, name) != known.end()) return std::nullopt;
    const std::string guess = foundation::nearest_name(name, known);
    reader.error(
        key, foundation::quoted(name), "a place is a body, BODY.POINT, a node or \"ground\"",
        guess.empty() ? "known are: " + foundation::comma_separated(known) : "did you mean \"" + guess + "\"?");
    return std::nullopt;
  }

 private:
  const model::Description& description_;
  const SymbolTable& in_file_;
};

std::optional<Eigen::Vector3d> required_direction(TableReader& reader, const std::string& key,
                                                  const std::string& remedy) {
  if (!reader.has(key)) reader.missing(key, remedy);
  return reader.direction(key);
}

void read_relative(TableReader& reader, const std::string& name, const PlaceReader& places,
                   model::Description& description) {
  const std::string of_name = reader.required_text("of"), to_name = reader.required_text("to");
  const auto axis =
      required_direction(reader, "axis", "give the axis of the joint in the ground frame: axis = [0, 0, 1]");
  const auto of = of_name.empty() ? std::nullopt : places.place(reader, "of", of_name),
             to = to_name.empty() ? std::nullopt : places.place(reader, "to", to_name);
  if (of && to && axis) description.relative_motions.push_back({name, *of, *to, spatial::axes_along(*axis)});
}

/// Indices of the named elements; none if one is not known, or could not be read.
std::optional<std::vector<std::size_t>> elements_named(TableReader& reader, const std::vector<std::string>& names,
                                                       const model::Description& description,
                                                       const SymbolTable& symbols) {
  std::vector<std::size_t> found;
  for (const std::string& name : names) {
    const auto at = std::ranges::find_if(description.elements,
                                         [&](const model::Element& e) { return e.name == name && !e.is_foundation; });
    if (at != description.elements.end()) {
      found.push_back(static_cast<std::size_t>(at - description.elements.begin()));
      continue;
    }
    if (std::ranges::find(symbols.elements, name) != symbols.elements.end()) continue;
    const std::string guess = foundation::nearest_name(name, symbols.elements);
    reader.error("elements", foundation::quoted(name), "no element has this name",
                 guess.empty() ? "check the name" : "did you mean \"" + guess + "\"?");
  }
  return found.size() == names.size() ? std::optional(found) : std::nullopt;
}

void read_section(TableReader& reader, const std::string& name, const SymbolTable& symbols,
                  model::Description& description) {
  if (!reader.has("elements")) reader.missing("elements", "name the elements that the section cuts: [\"ELEMENT\", …]");
  if (!reader.has("at")) reader.missing("at", "give the point of the moments in the ground frame: at = [x, y, z]");
  const auto names = reader.texts("elements", R"(["front bearing", "rear bearing"])");
  const auto at = reader.vector("at", Quantity::length);
  const auto axes = reader.orientation("axes");
  if (names && names->empty())
    reader.error("elements", "an empty list", "a section cuts at least one element", "name it, or remove the section");
  const auto elements = elements_named(reader, names.value_or(std::vector<std::string>()), description, symbols);
  if (elements && !elements->empty() && at && (axes || !reader.has("axes")))
    description.sections.push_back({name, *elements, *at, axes.value_or(Eigen::Matrix3d::Identity())});
}

void read_clearance(TableReader& reader, const std::string& name, const PlaceReader& places,
                    model::Description& description) {
  const std::string remedy = "name two places: between = [\"BODY.POINT\", \"ground\"]";
  if (!reader.has("between")) reader.missing("between", remedy);
  const auto between = reader.texts("between", R"(["machine.flange", "ground"])");
  const auto direction =
      required_direction(reader, "direction",
                         "give the direction from the first place to the second, ground frame: direction = [0, 0, 1]");
  const std::size_t before = reader.errors();
  const double gap = reader.required_number("gap", Quantity::length);
  if (between && between->size() != 2) {
    reader.error("between", fmt::format("{} places", between->size()), "a clearance is between two places", remedy);
    return;
  }
  if (!between || !direction || reader.errors() != before) return;
  const auto of = places.place(reader, "between", (*between)[0]), to = places.place(reader, "between", (*between)[1]);
  if (of && to) description.clearances.push_back({name, *of, *to, *direction, gap});
}

}  // namespace

void read_observations(TableReader& root, model::Description& description, SymbolTable& symbols) {
  const PlaceReader places(description, symbols);
  read_each(root, "relative", "a relative motion is a table", "write [relative.NAME] with of, to and axis",
            symbols.relative_motions,
            [&](TableReader& reader, const std::string& name) { read_relative(reader, name, places, description); });
  read_each(root, "sections", "a section is a table", "write [sections.NAME] with elements, at and axes",
            symbols.sections,
            [&](TableReader& reader, const std::string& name) { read_section(reader, name, symbols, description); });
  read_each(root, "clearances", "a clearance is a table", "write [clearances.NAME] with between, direction and gap",
            symbols.clearances,
            [&](TableReader& reader, const std::string& name) { read_clearance(reader, name, places, description); });
}

}  // namespace trivet::project
