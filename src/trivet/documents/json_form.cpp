// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/documents/document.h"

/// A document as JSON: an object with a key for each part.
namespace trivet::documents {
namespace {

Json json_list(const Numbers& numbers) {
  if (!numbers.exists()) return nullptr;
  json::NumberList list;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (numbers.is_complex()) list.add(numbers[i]);
    else list.add(numbers[i].real());
  return std::move(list).json();
}

Json json_rows(const Table& table) {
  const std::vector<UsedColumn> columns = used_columns(table, table.json, in_json);
  Json rows = Json::array();
  for (std::size_t i = 0; i < table.rows; ++i) {
    Json& row = rows.emplace_back(Json::object());
    for (const UsedColumn& used : columns)
      row[used.name] = used.column->list ? json_list(used.column->list(i)) : value_of(used, i);
  }
  return rows;
}

void add(const std::vector<Part>& parts, Json& object);

struct Adding {
  Json& object;

  void operator()(const Table& table) const {
    if (table.key.empty() || !(table.forms & in_json)) return;
    if (table.key == whole_json) object = json_rows(table);
    else object[table.key] = json_rows(table);
  }
  void operator()(const Curves& curves) const {
    if (curves.forms & in_json) object[curves.axis] = json_list(curves.points);
    for (const Curve& curve : curves.list)
      if (curve.forms & in_json) object[curve.name] = json_list(curve.values);
  }
  void operator()(const Single& single) const {
    if (single.forms & in_json) object[single.name] = single.value;
  }
  void operator()(const Words& words) const {
    if (!words.key.empty()) object[words.key] = words.list;
  }
  void operator()(const Sentence&) const {}
  void operator()(const LabelledArrays&) const {}
  void operator()(const Group& group) const {
    Json& place = group.key.empty() ? object : object[group.key];
    if (group.in_list) return add(group.parts, place.emplace_back(Json::object()));
    if (!group.key.empty()) place = Json::object();
    add(group.parts, place);
  }
};

void add(const std::vector<Part>& parts, Json& object) {
  for (const Part& part : parts) std::visit(Adding{object}, part.content);
}

}  // namespace

Json as_json(const Document& document) {
  Json object = Json::object();
  add(document.parts, object);
  return object;
}

std::string as_json_text(const Document& document) { return json::text(as_json(document), 1) + "\n"; }

}  // namespace trivet::documents
