// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exports/part_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

#include "trivet/foundation/plain_text.h"
#include "trivet/project/text/model_path.h"

namespace trivet::exports {
namespace {

using project::Node;

/// Cells of one row: key path and value, in the order of the file.
using PartRow = std::vector<std::pair<std::string, Node>>;

/// Flattens a value into cells. @returns the key of a value that no cell can hold; empty if all have one
std::string add_cells(const std::string& key, const Node& value, PartRow& row) {
  if (value.kind == Node::Kind::table) {
    for (std::size_t i = 0; i < value.keys.size(); ++i)
      if (const std::string bad = add_cells(key + "." + foundation::path_key(value.keys[i]), value.items[i], row);
          !bad.empty())
        return bad;
    return "";
  }
  if (value.kind != Node::Kind::array) {
    row.emplace_back(key, value);
    return "";
  }
  constexpr std::array axes = {"x", "y", "z"};
  const auto is_number = [](const Node& item) { return project::written_number(item).has_value(); };
  if (value.items.size() != axes.size() || !std::ranges::all_of(value.items, is_number)) return key;
  for (std::size_t i = 0; i < axes.size(); ++i) row.emplace_back(key + "." + axes[i], value.items[i]);
  return "";
}

std::string quoted_cell(const std::string& text) {
  if (text.find_first_of(",;\t\"\n#") == std::string::npos && !text.empty()) return text;
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
  return cell + "\"";
}

/// A column of a table; its unit if all its values are numbers of one quantity with units.
struct PartColumn {
  std::string key;
  std::optional<std::string> unit;
};

/// "at.x" → "at.": components of one vector have one unit. Other keys: the whole key.
std::string stem(const std::string& key) {
  const bool is_component = key.size() > 2 && key[key.size() - 2] == '.' && key.back() >= 'x' && key.back() <= 'z';
  return is_component ? key.substr(0, key.size() - 1) : key;
}

PartColumn column_of(const std::string& key, const std::vector<PartRow>& rows) {
  PartColumn column{key, std::nullopt};
  if (key == "name" || key == "on" || key == "from" || key == "type" || key == "foundation") return column;
  for (const PartRow& row : rows)
    for (const auto& [cell, value] : row) {
      if (stem(cell) != stem(key)) continue;
      const auto number = project::written_number(value);
      if (!number || !project::is_known_unit(number->unit)) return {key, std::nullopt};
      if (!column.unit || column.unit->empty()) column.unit = number->unit;
      if (!project::in_unit(*number, *column.unit)) return {key, std::nullopt};
    }
  return column;
}

std::string cell_text(const PartColumn& column, const PartRow& row) {
  for (const auto& [key, value] : row) {
    if (key != column.key) continue;
    if (const auto number = project::written_number(value); number && column.unit)
      return fmt::format("{}", *project::in_unit(*number, *column.unit));
    if (value.kind == Node::Kind::boolean) return value.boolean ? "true" : "false";
    return value.kind == Node::Kind::text ? quoted_cell(value.text) : fmt::format("{}", value.number);
  }
  return "";
}

std::string csv_of(const std::vector<PartRow>& rows) {
  std::vector<PartColumn> columns;
  for (const PartRow& row : rows)
    for (const auto& cell : row)
      if (std::ranges::none_of(columns, [&](const PartColumn& one) { return one.key == cell.first; }))
        columns.push_back(column_of(cell.first, rows));
  std::string text;
  for (const PartColumn& column : columns)
    text += (text.empty() ? "" : ",") +
        quoted_cell(column.key + (column.unit && !column.unit->empty() ? " [" + *column.unit + "]" : ""));
  text += "\n";
  for (const PartRow& row : rows) {
    std::string line;
    for (std::size_t c = 0; c < columns.size(); ++c) line += (c > 0 ? "," : "") + cell_text(columns[c], row);
    text += line + "\n";
  }
  return text;
}

Node text_node(const std::string& text) {
  Node node;
  node.kind = Node::Kind::text;
  node.text = text;
  return node;
}

/// If some elements stand on a body, the others name the ground.
void name_the_ground(std::vector<PartRow>& rows) {
  const auto has_from = [](const PartRow& row) {
    return std::ranges::any_of(row, [](const auto& cell) { return cell.first == "from"; });
  };
  if (std::ranges::none_of(rows, has_from)) return;
  for (PartRow& row : rows)
    if (!has_from(row)) row.emplace_back("from", text_node("ground"));
}

void add_points(const std::string& body, const Node& points, std::vector<PartRow>& rows,
                std::vector<std::string>& lost) {
  for (std::size_t i = 0; i < points.keys.size(); ++i) {
    PartRow row = {{"name", text_node(points.keys[i])}, {"on", text_node(body)}};
    if (add_cells("at", points.items[i], row).empty()) rows.push_back(std::move(row));
    else lost.push_back(fmt::format("point {} of {}: its place is no list of three numbers", points.keys[i], body));
  }
}

}  // namespace

std::vector<PartTable> part_tables(const Node& document, std::vector<std::string>& lost) {
  std::vector<PartTable> tables;
  std::vector<PartRow> points;
  for (const char* kind : {"bodies", "nodes", "elements"}) {
    const Node* parts = document.find(kind);
    std::vector<PartRow> rows;
    for (std::size_t i = 0; parts && i < parts->keys.size(); ++i) {
      PartRow row = {{"name", text_node(parts->keys[i])}};
      std::string bad;
      const Node* own_points = nullptr;
      for (std::size_t k = 0; k < parts->items[i].keys.size() && bad.empty(); ++k) {
        const std::string& key = parts->items[i].keys[k];
        if (key == "points" && std::string(kind) == "bodies") own_points = &parts->items[i].items[k];
        else bad = add_cells(foundation::path_key(key), parts->items[i].items[k], row);
      }
      if (bad.empty() && own_points) add_points(parts->keys[i], *own_points, points, lost);
      if (bad.empty()) rows.push_back(std::move(row));
      else
        lost.push_back(
            fmt::format("{} {}: {} fits in no cell; keep it in the project file", kind, parts->keys[i], bad));
    }
    name_the_ground(rows);
    if (!rows.empty()) tables.push_back({kind, csv_of(rows)});
  }
  if (!points.empty()) tables.push_back({"points", csv_of(points)});
  return tables;
}

}  // namespace trivet::exports
