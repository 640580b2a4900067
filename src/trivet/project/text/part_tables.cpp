// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/part_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "trivet/foundation/plain_text.h"
#include "trivet/project/text/csv_table.h"
#include "trivet/project/text/model_path.h"
#include "trivet/project/text/source_file.h"
#include "trivet/project/text/symbol_table.h"
#include "trivet/project/text/table_reader.h"

namespace trivet::project {
namespace {

/// Most rows of one table; a model has at most as many elements.
constexpr std::size_t most_rows = 5000;

/// One kind of parts: "elements", "bodies", "nodes" or "points".
class PartTable {
 public:
  PartTable(Node& document, std::string kind, foundation::Problems& problems)
      : document_(document), kind_(std::move(kind)), problems_(problems) {}

  void read(const Node& table) {
    const std::string path = "tables." + kind_;
    TableReader reader(table, path, problems_);
    if (reader.has("file") == reader.has("rows")) {
      reader.error(reader.has("file") ? "rows" : "file", reader.has("file") ? "file and rows" : "neither file nor rows",
                   "a table is in a file or in rows",
                   reader.has("file") ? "keep one" : "file = \"" + kind_ + ".csv\", or rows = [{name = …, …}]");
      static_cast<void>(reader.node("file")), static_cast<void>(reader.node("rows"));
    } else if (reader.has("file")) {
      if (const auto file = read_file_name(reader, "file")) read_file(reader, *file);
    } else {
      read_rows(reader, *reader.node("rows"));
    }
    reader.finish();
  }

 private:
  void read_file(TableReader& reader, const std::filesystem::path& file) {
    auto cells = read_text_table(file, most_rows);
    if (!cells) return reader.add_of_file("file", cells.error());
    for (const int line : cells->comments_like_rows)
      problems_
          .warning("tables." + kind_, "a comment line with as many cells as the header",
                   "# begins a comment, and the row is not read",
                   "put a name that begins with # in quotes, or write the comment without separators")
          .origin = {file.string(), line, 0};
    std::vector<std::optional<Column>> columns;
    for (const std::string& header : cells->columns) {
      columns.push_back(column_of(header));
      if (!columns.back())
        problems_
            .error("tables." + kind_, "column " + foundation::quoted(header),
                   "a column is a key with its unit in brackets", "for instance name, type, on, at.x [mm], scale")
            .origin = {file.string(), cells->header_line, 0};
    }
    if (collide(columns, {file.string(), cells->header_line, 0})) return;
    refuse_doubtful_cells(*cells, columns, file.string());
    for (std::size_t r = 0; r < cells->rows.size(); ++r) {
      const foundation::Origin origin{file.string(), cells->lines[r], 0};
      if (std::ranges::all_of(cells->rows[r], [](const std::string& cell) { return cell.empty(); })) continue;
      Node row = table_node(origin);
      for (std::size_t c = 0; c < columns.size(); ++c)
        if (columns[c] && !cells->rows[r][c].empty())
          put(row, columns[c]->keys,
              is_text(*columns[c]) ? text_node(cells->rows[r][c], origin)
                                   : cell_node(cells->rows[r][c], columns[c]->unit, origin));
      add(std::move(row));
    }
  }

  /// Reports ambiguous cells: a second unit, and an empty `from`, which would mean the ground.
  void refuse_doubtful_cells(TextTable& cells, const std::vector<std::optional<Column>>& columns,
                             const std::string& source) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (!columns[c]) continue;
      const bool from = kind_ == "elements" && columns[c]->keys == std::vector<std::string>{"from"};
      const bool some_from = from && std::ranges::any_of(cells.rows, [&](const auto& row) { return !row[c].empty(); });
      for (std::size_t r = 0; r < cells.rows.size(); ++r) {
        std::string& cell = cells.rows[r][c];
        const bool blank = std::ranges::all_of(cells.rows[r], [](const std::string& other) { return other.empty(); });
        const foundation::Origin here{source, cells.lines[r], 0};
        if (!columns[c]->unit.empty() && !cell.empty() && !number_of(cell)) {
          problems_
              .error("tables." + kind_,
                     fmt::format("{} under {}", foundation::quoted(cell), foundation::quoted(cells.columns[c])),
                     "cells below a header with a unit are numbers",
                     "write the number in the unit of the column, or units in every cell and none in the header")
              .origin = here;
          if (const std::string number = cell.substr(0, cell.find(' ')); number_of(number))
            cell = number;  // the error is reported
        }
        if (some_from && cell.empty() && !blank)
          problems_
              .error("tables." + kind_, "an empty cell under \"from\"",
                     "if other rows name a body, each row names a body or the ground", "write the body, or \"ground\"")
              .origin = here;
      }
    }
  }

  /// Reports columns that set one key twice, or a key and a part of it.
  bool collide(const std::vector<std::optional<Column>>& columns, const foundation::Origin& header) {
    bool found = false;
    for (std::size_t i = 0; i < columns.size(); ++i)
      for (std::size_t j = 0; j < columns.size(); ++j) {
        if (i == j || !columns[i] || !columns[j]) continue;
        const auto &shorter = columns[i]->keys, &longer = columns[j]->keys;
        if (shorter.size() > longer.size() || !std::equal(shorter.begin(), shorter.end(), longer.begin()) ||
            (shorter.size() == longer.size() && i > j))
          continue;
        problems_
            .error("tables." + kind_, fmt::format("columns {} and {}", i + 1, j + 1),
                   "both set " + shorter.front() + (shorter.size() > 1 ? "." + shorter.back() : ""), "keep one of them")
            .origin = header;
        found = true;
      }
    return found;
  }

  /// Names are texts, also those that look like numbers.
  static bool is_text(const Column& column) {
    static constexpr std::array<const char*, 5> names = {"name", "type", "on", "from", "foundation"};
    return column.keys.size() == 1 && column.unit.empty() &&
        std::ranges::find(names, column.keys.front()) != names.end();
  }

  void read_rows(TableReader& reader, const Node& rows) {
    if (rows.kind != Node::Kind::array) {
      reader.error("rows", kind_name(rows.kind), "rows are a list of tables in braces",
                   "rows = [{name = \"front\", type = \"mount\", on = \"machine\", at = [0, 0, 0]}, …]");
      return;
    }
    if (rows.items.size() > most_rows) {
      reader.error("rows", fmt::format("{} rows", rows.items.size()), fmt::format("a table has at most {}", most_rows),
                   "split the model");
      return;
    }
    for (const Node& row : rows.items) {
      if (row.kind == Node::Kind::table) add(row);
      else
        problems_
            .error("tables." + kind_ + ".rows", value_text(row), "a row is a table in braces", "{name = \"front\", …}")
            .origin = row.origin;
    }
  }

  /// Adds a row to the parts of its kind, under its name.
  void add(Node row) {
    const Node* name = row.find("name");
    const foundation::Origin origin = row.origin;
    if (!name ||
        (name->kind != Node::Kind::text && name->kind != Node::Kind::real && name->kind != Node::Kind::integer)) {
      problems_
          .error("tables." + kind_, name ? value_text(*name) : "a row without a name",
                 "every row has a name, under the key or column \"name\"", "add it; keys are in lower case")
          .origin = origin;
      return;
    }
    const std::string called = name->kind == Node::Kind::text ? name->text : fmt::format("{}", name->number);
    remove(row, "name");
    if (!is_good_name(called, row)) return;
    Node* parts = holder(row, called);
    if (!parts) return;
    const std::string path = kind_ == "points" ? "points." + called : kind_ + "." + called;
    combine_components(row, path, problems_);
    if (const Node* other = parts->find(called)) {
      problems_
          .error(path, fmt::format("defined a second time, in {}", foundation::place(origin)),
                 fmt::format("the name is already used in {}", foundation::place(other->origin)),
                 "names are unique: rename one of them")
          .origin = origin;
      return;
    }
    if (kind_ == "points") {
      const Node* at = row.find("at");
      if (!at)
        problems_.error(path + ".at", "missing", "a point needs its position", "give at.x, at.y and at.z").origin =
            origin;
      for (const std::string& key : row.keys)
        if (key != "at")
          problems_
              .error(path + "." + key, "unknown key",
                     "a point has a name, the body that it is on, and its place: name, on, at", "remove it")
              .origin = origin;
      if (!at) return;
      row = Node(*at);
    }
    parts->keys.push_back(called);
    parts->items.push_back(std::move(row));
  }

  /// Checks a name as names in the file; problems have the line of the row.
  bool is_good_name(const std::string& called, const Node& row) {
    const std::string path = kind_ + "." + foundation::shortened(called);
    if (called.empty() || called.find('.') != std::string::npos) {
      problems_
          .error(path, fmt::format("name {}", foundation::quoted(called)), "a name is not empty and has no dot",
                 "choose another name")
          .origin = row.origin;
      return false;
    }
    Node parts = table_node(row.origin), all = table_node(row.origin);
    put(parts, {called}, row);
    put(all, {kind_}, std::move(parts));
    foundation::Problems found = check_names_and_texts(all);
    for (foundation::Problem& problem : found.list())
      if (problem.origin.line == 0) problem.origin = row.origin;
    problems_.add(found);
    return !found.has_errors();
  }

  /// The table for the new part; created if the file has none.
  Node* holder(Node& row, const std::string& called) {
    if (kind_ != "points") return created_table(document_, kind_, row.origin);
    const Node* on = row.find("on");
    const Node* bodies = document_.find("bodies");
    Node* body = nullptr;
    if (on && on->kind == Node::Kind::text && bodies && bodies->kind == Node::Kind::table)
      body = document_.find("bodies")->find(on->text);
    if (!body || body->kind != Node::Kind::table) {
      const std::string guess = on && bodies ? foundation::nearest_name(on->text, bodies->keys) : "";
      problems_
          .error("points." + called + ".on", on ? value_text(*on) : "missing", "a point is on a body",
                 guess.empty() ? "name the body: on = \"BODY\"" : "did you mean \"" + guess + "\"?")
          .origin = row.origin;
      return nullptr;
    }
    remove(row, "on");
    return created_table(*body, "points", row.origin);
  }

  Node* created_table(Node& parent, const std::string& key, const foundation::Origin& origin) {
    if (Node* old = parent.find(key)) return old->kind == Node::Kind::table ? old : nullptr;
    parent.keys.push_back(key);
    parent.items.push_back(table_node(origin));
    return &parent.items.back();
  }

  static void remove(Node& table, const std::string& key) {
    const auto at = std::ranges::find(table.keys, key);
    table.items.erase(table.items.begin() + (at - table.keys.begin()));
    table.keys.erase(at);
  }

  Node& document_;
  std::string kind_;
  foundation::Problems& problems_;
};

}  // namespace

void gather_columns(foundation::Problems& problems) {
  std::map<std::string, std::vector<std::size_t>> columns;  // problems of one column in several rows: a key, or a unit
  for (std::size_t i = 0; i < problems.list().size(); ++i) {
    const foundation::Problem& problem = problems.list()[i];
    const std::size_t name = problem.subject.find('.'), unit = problem.finding.find(' ');
    if (problem.origin.line == 0 || problem.origin.column != 0 || name == std::string::npos) continue;
    const std::string_view finding = problem.finding;
    const bool number =
        !finding.empty() && std::string_view("0123456789-+.\"").find(finding.front()) != std::string_view::npos;
    const bool fixed = problem.rule.find("is fixed by its type") != std::string::npos;  // whatever the cells contain
    const std::string same(fixed ? "" : number && unit != std::string::npos ? finding.substr(unit) : finding);
    const std::size_t key = problem.subject.find('.', name + 1);
    if (key != std::string::npos && (!number || fixed || same.size() < finding.size()))
      columns[problem.origin.source + problem.subject.substr(key) + problem.rule + same].push_back(i);
  }
  std::vector<bool> dropped(problems.list().size(), false);
  for (const auto& [column, rows] : columns) {
    if (rows.size() < 2) continue;
    problems.list()[rows.front()].finding +=
        fmt::format(", here and in {} more row{}", rows.size() - 1, rows.size() > 2 ? "s" : "");
    for (std::size_t i = 1; i < rows.size(); ++i) dropped[rows[i]] = true;
  }
  foundation::Problems kept;
  for (std::size_t i = 0; i < dropped.size(); ++i)
    if (!dropped[i]) kept.add(problems.list()[i]);
  problems = std::move(kept);
}

void put_tables_in_place(Node& document, foundation::Problems& problems) {
  const auto at = std::ranges::find(document.keys, "tables");
  if (at == document.keys.end()) return;
  const Node tables = std::move(document.items[at - document.keys.begin()]);
  document.items.erase(document.items.begin() + (at - document.keys.begin()));
  document.keys.erase(at);
  if (tables.kind != Node::Kind::table) {
    problems
        .error("tables", kind_name(tables.kind), "[tables] has tables of bodies, nodes, points and elements",
               "write [tables.elements]")
        .origin = tables.origin;
    return;
  }
  TableReader reader(tables, "tables", problems);
  for (const char* kind : {"bodies", "nodes", "points", "elements"})
    if (const Node* table = reader.table(kind)) PartTable(document, kind, problems).read(*table);
  reader.finish();
}

}  // namespace trivet::project
