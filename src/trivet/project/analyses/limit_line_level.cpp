// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/analyses/limit_line_level.h"

#include <string>
#include <utility>
#include <vector>

#include "trivet/project/text/column_units.h"
#include "trivet/project/text/csv_table.h"
#include "trivet/project/text/source_file.h"

namespace trivet::project {
namespace {

void add_level_of(const std::string& text, std::vector<Level>& found) {
  if (const auto level = split_level(text).level) found.push_back(*level);
}

/// Levels after units in the rows, the key `unit` and the headings of the file.
std::vector<Level> written_levels(const TableReader& reader) {
  std::vector<Level> found;
  if (const Node* rows = reader.content().find("rows"))
    for (const Node& row : rows->items)
      if (row.kind == Node::Kind::array && row.items.size() == 2 && row.items[1].kind == Node::Kind::text)
        add_level_of(row.items[1].text, found);
  if (const Node* unit = reader.content().find("unit"); unit && unit->kind == Node::Kind::text)
    add_level_of(unit->text, found);
  if (!reader.content().find("file")) return found;
  foundation::Problems reported_later;  // when the rows of the file are read
  TableReader same(reader.content(), reader.path(), reported_later);
  const auto file = read_file_name(same, "file");
  const auto csv = file ? read_csv_table(*file, most_rows_over_frequency) : tl::make_unexpected(foundation::Problems());
  const std::string wanted = same.text("limit").value_or("limit");
  if (!csv) return found;
  for (const std::string& column : csv->columns)
    if (const UnitHeading heading = unit_heading(column); heading.name == wanted || column == wanted)
      add_level_of(heading.unit, found);
  return found;
}

/// Is there a row with a unit, but without a level?
bool has_row_without_level(const TableReader& reader) {
  const Node* rows = reader.content().find("rows");
  return rows && std::ranges::any_of(rows->items, [](const Node& row) {
           return row.kind == Node::Kind::array && row.items.size() == 2 && row.items[1].kind == Node::Kind::text &&
               !split_level(row.items[1].text).level;
         });
}

}  // namespace

Level read_level_of_line(TableReader& reader, bool over_bands) {
  const auto word = reader.choice("level", {"rms", "zero_to_peak"});
  const Level of_key = word == "zero_to_peak" ? Level::amplitude : Level::rms;
  const std::vector<Level> written = written_levels(reader);
  if (!written.empty() && !word && has_row_without_level(reader))
    reader.error("rows", "numbers with a level and others without", "a limit line has one level",
                 std::string("write ") + level_ending(written.front()) + " after every unit");
  for (const Level level : written) {
    if (over_bands || level == (word ? of_key : written.front())) continue;
    const std::string other = std::string("\"") + level_ending(level) + "\"";
    if (word)
      reader.error("level", "\"" + *word + "\" of numbers with " + other, "a limit line has one level",
                   "remove the key: the level after the unit holds");
    else
      reader.error(reader.has("rows") ? "rows" : "unit",
                   std::string("\"") + level_ending(written.front()) + "\" and " + other, "a limit line has one level",
                   "convert its numbers to one");
    break;
  }
  if (word) return of_key;
  const bool peak = !over_bands && !written.empty() && written.front() != Level::rms;
  return peak ? Level::amplitude : Level::rms;
}

}  // namespace trivet::project
