// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/part_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "trivet/project/text/model_path.h"

namespace trivet::project {
namespace {

class VectorsOfRow {
 public:
  VectorsOfRow(std::string path, foundation::Problems& problems) : path_(std::move(path)), problems_(problems) {}

  void make_arrays(Node& table, const std::string& inside = "") const {
    for (std::size_t i = 0; i < table.keys.size(); ++i) {
      Node& item = table.items[i];
      const std::string key = inside.empty() ? table.keys[i] : inside + "." + table.keys[i];
      if (item.kind != Node::Kind::table || table.keys[i] == "moved" || table.keys[i] == "stiffness_factor" ||
          table.keys[i] == "center_moved")
        continue;
      const bool components = !item.keys.empty() &&
          std::ranges::all_of(item.keys, [](const std::string& k) { return k == "x" || k == "y" || k == "z"; });
      if (components) make_array(item, key);
      else make_arrays(item, key);
    }
  }

 private:
  void make_array(Node& item, const std::string& key) const {
    Node array = table_node(item.origin);
    array.kind = Node::Kind::array;
    for (const char* component : {"x", "y", "z"}) {
      if (const Node* value = item.find(component)) array.items.push_back(*value);
      else {
        problems_
            .error(path_ + "." + key + "." + component, "missing", "a place or direction has three components",
                   fmt::format("give {0}.x, {0}.y and {0}.z", key))
            .origin = item.origin;
        array.items.push_back(cell_node("0", "", item.origin));  // to continue reading
      }
    }
    item = std::move(array);
  }

  std::string path_;
  foundation::Problems& problems_;
};

}  // namespace

Node text_node(std::string text, const foundation::Origin& origin) {
  Node node;
  node.kind = Node::Kind::text;
  node.text = std::move(text);
  node.origin = origin;
  return node;
}

Node table_node(const foundation::Origin& origin) {
  Node node;
  node.origin = origin;
  return node;
}

std::optional<Column> column_of(const std::string& header) {
  Column column;
  std::string path = header;
  if (const std::size_t open = header.find('['); open != std::string::npos) {
    if (header.back() != ']') return std::nullopt;
    column.unit = header.substr(open + 1, header.size() - open - 2);
    path.erase(header.find_last_not_of(' ', open == 0 ? 0 : open - 1) + 1);
  }
  column.keys = path_keys(path);
  return column.keys.empty() ? std::nullopt : std::optional(column);
}

std::optional<double> number_of(const std::string& cell) {
  double value = 0;
  const char* const begin = cell.data() + (cell.starts_with('+') ? 1 : 0);
  const auto [end, error] = std::from_chars(begin, cell.data() + cell.size(), value);
  return error == std::errc() && end == cell.data() + cell.size() ? std::optional(value) : std::nullopt;
}

Node cell_node(const std::string& cell, const std::string& unit, const foundation::Origin& origin) {
  const auto number = number_of(cell);
  if (number && unit.empty()) {
    Node node = text_node("", origin);
    node.kind = Node::Kind::real;
    node.number = *number;
    return node;
  }
  if (number) return text_node(cell + " " + unit, origin);
  if (cell == "true" || cell == "false") {
    Node node = text_node("", origin);
    node.kind = Node::Kind::boolean;
    node.boolean = cell == "true";
    return node;
  }
  return text_node(cell, origin);
}

void put(Node& table, const std::vector<std::string>& keys, Node value) {
  Node* node = &table;
  for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
    if (!node->find(keys[i])) {
      node->keys.push_back(keys[i]);
      node->items.push_back(table_node(value.origin));
    }
    node = node->find(keys[i]);
  }
  node->keys.push_back(keys.back());
  node->items.push_back(std::move(value));
}

void combine_components(Node& row, const std::string& path, foundation::Problems& problems) {
  VectorsOfRow(path, problems).make_arrays(row);
}

}  // namespace trivet::project
