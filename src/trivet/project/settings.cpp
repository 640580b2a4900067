// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "trivet/project/text/changes.h"

namespace trivet::project {

namespace {

void list_changes(const Node& node, const std::string& path, std::vector<ChangedNumber>& changes) {
  switch (node.kind) {
    case Node::Kind::table:
      for (std::size_t i = 0; i < node.keys.size(); ++i)
        list_changes(node.items[i], path.empty() ? node.keys[i] : path + "." + node.keys[i], changes);
      return;
    case Node::Kind::array:
      changes.push_back({path, fmt::format("[{} values]", node.items.size())});
      return;
    case Node::Kind::text:
      changes.push_back({path, "\"" + node.text + "\""});
      return;
    case Node::Kind::boolean:
      changes.push_back({path, node.boolean ? "true" : "false"});
      return;
    default:
      changes.push_back({path, fmt::format("{:.12g}", node.number)});
      return;
  }
}

bool is_part_of(const std::string& path, const std::string& whole) {
  return path == whole || path.starts_with(whole + ".");
}

/// True if the document has this number after all changes.
bool holds(const Node& document, const ChangedNumber& number) {
  std::vector<ChangedNumber> there;
  list_changes(deepest(document, number.path), number.path, there);
  return there.size() == 1 && there.front().path == number.path && there.front().value == number.value;
}

}  // namespace

void set_folder(Node& node, const std::string& folder) {
  if (node.kind == Node::Kind::text) node.folder = folder;
  for (Node& item : node.items) set_folder(item, folder);
}

Settings read_settings(const std::vector<std::string>& settings, const std::filesystem::path& folder,
                       foundation::Problems& problems) {
  Settings result;
  for (const std::string& setting : settings) {
    foundation::Expected<Node> change = parse_setting(setting);
    if (!change) {
      problems.add(change.error());
      continue;
    }
    std::vector<ChangedNumber> numbers;
    list_changes(*change, "", numbers);
    for (const ChangedNumber& number : numbers) {
      const auto earlier = std::ranges::find_if(result.numbers, [&](const ChangedNumber& known) {
        return is_part_of(known.path, number.path) || is_part_of(number.path, known.path);
      });
      if (earlier != result.numbers.end())
        problems
            .error(number.path,
                   number.value + ", and " + earlier->path + " = " + earlier->value + " in an earlier setting",
                   "two settings of one number: only one of them can apply", "keep one of them")
            .origin = change->origin;
    }
    result.numbers.insert(result.numbers.end(), numbers.begin(), numbers.end());
    set_folder(*change, folder.string());
    result.changes.push_back(std::move(*change));
  }
  return result;
}

std::vector<std::string> change_lines(const Node* of_case, const Settings& settings, const Node& document) {
  std::vector<ChangedNumber> numbers;
  if (of_case) list_changes(*of_case, "", numbers);
  std::erase_if(numbers, [&](const ChangedNumber& number) {
    const auto again = [&](const ChangedNumber& setting) { return is_part_of(number.path, setting.path); };
    return !holds(document, number) || std::ranges::any_of(settings.numbers, again);
  });
  numbers.insert(numbers.end(), settings.numbers.begin(), settings.numbers.end());
  std::vector<std::string> lines;
  for (const ChangedNumber& number : numbers) lines.push_back(number.path + " = " + number.value);
  return lines;
}

DisplayUnits read_display(TableReader& root) {
  DisplayUnits units;
  const Node* table = root.table("display");
  if (!table) return units;
  TableReader reader(*table, "display", root.problems());
  for (const char* key : {"length", "force", "angle", "mass", "frequency", "level"}) {
    const auto value = reader.text(key);
    if (!value) continue;
    const foundation::Problems found = set_shown_unit(units, key, *value);
    for (const foundation::Problem& problem : found.list())
      reader.error(key, problem.finding, problem.rule, problem.remedy);
  }
  reader.finish();
  return units;
}

}  // namespace trivet::project
