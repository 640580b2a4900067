// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/design_axis_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "trivet/foundation/plain_text.h"
#include "trivet/project/analyses/analyses.h"
#include "trivet/project/text/admissible_range.h"
#include "trivet/project/text/model_path.h"
#include "trivet/project/text/shared_keys.h"
#include "trivet/project/text/units.h"

namespace trivet::project {
namespace {

/// True if a blank is outside the quoted names.
bool has_stray_blank(const std::string& path) {
  char quote = 0;
  for (const char c : path) {
    if (quote == 0 && std::isspace(static_cast<unsigned char>(c))) return true;
    if (quote == 0 && (c == '"' || c == '\'')) quote = c;
    else if (c == quote) quote = 0;
  }
  return false;
}

/// Tables of adjustments, which the file need not have.
bool is_adjustment(const std::string& key) {
  static constexpr std::array<const char*, 4> tables = {"stiffness_factor", "moved", "center_moved",
                                                        "inertia_about_center"};
  return std::ranges::find(tables, key) != tables.end();
}

std::optional<WrittenNumber> end_of_range(TableReader& reader, const std::string& key) {
  const Node* node = reader.node(key);
  if (!node) {
    reader.missing(key, "give the range: from = …, to = …");
    return std::nullopt;
  }
  const auto number = written_number(*node);
  const bool good = number && std::isfinite(number->value) && !outside_range(number->value, Quantity::pure);
  if (!good)
    reader.error(key, value_text(*node),
                 "an end of the range is a finite number up to 1e30, or a text of a number and a unit",
                 "for instance from = 0.5, or from = \"5 mm\"");
  return good ? number : std::nullopt;
}

}  // namespace

std::vector<ParameterPlace> read_places(TableReader& root, TableReader& reader, const std::string& noun) {
  std::vector<ParameterPlace> places;
  const Node* node = reader.node("path");
  const std::string remedy =
      "path = \"elements.mount.scale\", a list of paths, or {\"elements.mount.at.y\" = -1} with factors";
  if (!node) {
    reader.missing("path", remedy);
    return places;
  }
  const auto add = [&](const Node& path) {
    if (path.kind == Node::Kind::text) places.push_back({path.text, 1});
    else reader.error("path", value_text(path), "a path is a text", remedy);
  };
  if (node->kind == Node::Kind::array) {
    for (const Node& item : node->items) add(item);
  } else if (node->kind == Node::Kind::table) {
    for (std::size_t i = 0; i < node->keys.size(); ++i) {
      const auto factor = written_number(node->items[i]);
      if (factor && factor->unit.empty() && std::isfinite(factor->value) && factor->value != 0)
        places.push_back({node->keys[i], factor->value});
      else
        reader.error("path", fmt::format("{} = {}", foundation::quoted(node->keys[i]), value_text(node->items[i])),
                     "a factor is a number without unit and not 0; a dotted path is in quotes", remedy);
    }
  } else {
    add(*node);
  }
  const bool several = node->kind == Node::Kind::array || node->kind == Node::Kind::table;
  if (several && node->items.empty())
    reader.error("path", "no path", "a " + noun + " moves at least one number", remedy);
  for (const ParameterPlace& place : places) check_model_path(root, reader, "path", place.path);
  return places;
}

void refuse_shared_numbers(const std::vector<NamedPlaces>& all, const std::string& table, const std::string& noun,
                           TableReader& root) {
  struct Known {
    std::vector<std::string> keys;
    std::string name;
  };
  std::vector<Known> known;
  for (const NamedPlaces& one : all)
    for (const ParameterPlace& place : one.places) {
      const std::vector<std::string> keys = path_keys(place.path);
      const auto same = std::ranges::find(known, keys, &Known::keys);
      if (same != known.end())
        root.problems()
            .error(table + "." + one.name + ".path", foundation::quoted(place.path),
                   same->name == one.name
                       ? "the " + noun + " names this number twice"
                       : "the " + noun + " " + foundation::quoted(same->name) + " moves this number too",
                   "a number has one " + noun + ": remove it from one of them")
            .origin = deepest(*root.node(table), one.name + ".path").origin;
      known.push_back({keys, one.name});
    }
}

void check_model_path(TableReader& root, TableReader& reader, const std::string& key, const std::string& path) {
  const std::string shown = "\"" + path.substr(0, 80) + "\"";
  if (path.find('[') != std::string::npos)
    return static_cast<void>(reader.error(key, shown, "a path names its parts and has no indices",
                                          "name a number: \"elements.mount.scale\", \"elements.mount.at.y\" of an "
                                          "array of three, \"bodies.machine.mass\""));
  if (has_stray_blank(path))
    return static_cast<void>(reader.error(
        key, shown, "a name with blanks needs quotes in a path",
        R"(write it without, "elements.mount.scale", or the name in quotes, 'elements."front left".scale')"));
  const std::vector<std::string> keys = path_keys(path);
  const std::vector<std::string> parts = {"bodies",      "nodes",   "elements",   "element_types",
                                          "excitations", "damping", "foundations"};
  if (keys.size() < 2 || std::ranges::find(parts, keys.front()) == parts.end()) {
    reader.error(key, shown, "a parameter is a number of the model, named by its path",
                 "for instance \"elements.mount.scale\" or \"bodies.machine.mass\"");
    return;
  }
  const Node* node = root.node(keys.front());
  for (std::size_t i = 1; i < keys.size(); ++i) {
    const bool is_table = node && node->kind == Node::Kind::table;
    const Node* next = node ? node_at(*node, {keys[i]}) : nullptr;
    if (!next && is_table && i >= 2 && (i + 1 == keys.size() || is_adjustment(keys[i]) || is_zero_by_default(keys[i])))
      return;
    if (!next) {
      const std::string guess = is_table ? foundation::nearest_name(keys[i], node->keys) : "";
      reader.error(key, shown, fmt::format("the file has no \"{}\" there", foundation::shortened(keys[i])),
                   !guess.empty()                         ? "did you mean \"" + guess + "\"?"
                       : node && component_of(*node, "x") ? "the components of an array of three numbers are x, y and z"
                                                          : "check the path");
      return;
    }
    node = next;
  }
  const auto at_this_path = [&](const foundation::Problem& p) {
    return p.severity == foundation::Severity::error && p.subject == path;
  };
  if (!written_number(*node) && std::ranges::none_of(root.problems().list(), at_this_path))
    reader.error(key, shown,
                 fmt::format("it is {}, not a number",
                             node->kind == Node::Kind::text ? project::value_text(*node) : kind_name(node->kind)),
                 "name one number: those of an array of three are .x, .y and .z; a matrix is varied by the scale of "
                 "its element");
}

void read_range(TableReader& reader, DesignAxis& axis) {
  axis.logarithmic = reader.choice("spacing", {"linear", "logarithmic"}) == "logarithmic";
  const auto from = end_of_range(reader, "from"), to = end_of_range(reader, "to");
  if (!from || !to) return;
  const auto of_to = from->unit == to->unit ? std::optional(1.0) : unit_ratio(to->unit, from->unit);
  if (!of_to) {
    reader.error("to",
                 fmt::format("from = {}, to = {}", value_text(*reader.node("from")), value_text(*reader.node("to"))),
                 "both ends of a range have units of the same quantity, or neither has one", "give both the same unit");
    return;
  }
  axis.from = from->value;
  axis.to = *of_to * to->value;
  axis.unit = from->unit;
  if (!(axis.from < axis.to))
    reader.error("to", fmt::format("from {:.6g} to {:.6g}", axis.from, axis.to),
                 "a range goes from the smaller to the larger number", "exchange or change them");
  else if (axis.logarithmic && !(axis.from > 0))
    reader.error("from", fmt::format("{:.6g}", axis.from), "a logarithmic range starts above 0",
                 "raise it; if 0 or less is a possible value, take spacing = \"linear\"");
}

std::vector<DesignAxis> read_parameters(TableReader& root) {
  std::vector<DesignAxis> parameters;
  const Node* table = root.table("parameters");
  if (!table) return parameters;
  for (std::size_t i = 0; i < table->keys.size(); ++i) {
    const std::string subject = "parameters." + table->keys[i];
    if (table->items[i].kind != Node::Kind::table) {
      root.problems()
          .error(subject, kind_name(table->items[i].kind), "a parameter is a table",
                 "write [parameters.NAME] with path, from and to")
          .origin = table->items[i].origin;
      continue;
    }
    if (is_mount_choice(table->items[i])) continue;
    TableReader reader(table->items[i], subject, root.problems());
    DesignAxis axis;
    axis.name = table->keys[i];
    axis.places = read_places(root, reader, "parameter");
    if (!axis.places.empty()) axis.parameter = axis.places.front().path;
    axis.quantity = quantity_at(root.content(), path_keys(axis.parameter));
    read_range(reader, axis);
    reader.finish();
    parameters.push_back(std::move(axis));
  }
  std::vector<NamedPlaces> named;
  for (const DesignAxis& axis : parameters) named.push_back({axis.name, axis.places});
  refuse_shared_numbers(named, "parameters", "parameter", root);
  return parameters;
}

double DesignAxis::at(double share) const {
  if (share <= 0) return from;
  if (share >= 1) return to;
  return logarithmic ? from * std::exp(share * std::log(to / from)) : from + share * (to - from);
}

double DesignAxis::share(double value) const {
  return logarithmic ? std::log(value / from) / std::log(to / from) : (value - from) / (to - from);
}

}  // namespace trivet::project
