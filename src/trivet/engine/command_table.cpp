// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

#include "trivet/engine/command_rows.h"
#include "trivet/project/analyses/drive.h"
#include "trivet/project/schema.h"

namespace trivet::engine {
namespace {

using Json = nlohmann::ordered_json;

/// What a schema says of the kind of a value: "a number ≥ 1", "one of a, b", "a list".
std::string kind_words(const Json& schema) {
  if (schema.contains("enum")) {
    std::string choices;
    for (const Json& one : schema["enum"])
      choices += (choices.empty() ? "" : ", ") + (one.is_string() ? one.get<std::string>() : one.dump());
    return "one of " + choices;
  }
  if (schema.contains("type") && schema["type"].is_string()) return schema["type"].get<std::string>();
  return "";
}

/// The schema itself, or the definition that it refers to.
const Json* resolved(const Json& schema, const Json& whole) {
  if (!schema.contains("$ref")) return &schema;
  const std::string name = schema["$ref"].get<std::string>();
  return &whole.at("$defs").at(name.substr(name.rfind('/') + 1));
}

const Json* properties_of(const Json& schema, const Json& whole) {
  const Json& own = *resolved(schema, whole);
  if (own.contains("properties")) return &own["properties"];
  for (const char* alternatives : {"anyOf", "oneOf"})
    if (own.contains(alternatives))
      for (const Json& one : own[alternatives])
        if (const Json* found = properties_of(one, whole)) return found;
  return own.contains("items") ? properties_of(own["items"], whole) : nullptr;
}

}  // namespace

const char* heading(Group group) {
  switch (group) {
    case Group::whole:
      return "Everything at once";
    case Group::machine:
      return "Look at a machine";
    case Group::harmonic:
      return "Frequencies and harmonic curves";
    case Group::time:
      return "Time, random motion and run-up";
    case Group::nonlinear:
      return "Nonlinear machines";
    case Group::design:
      return "Judge and design";
    case Group::data:
      return "Files and data";
  }
  return "";
}

const std::vector<Command>& commands() {
  static const std::vector<Command> all = [] {
    std::vector<Command> list;
    for (const auto& rows :
         {whole_commands(), machine_commands(), analysis_commands(), design_commands(), data_commands()})
      list.insert(list.end(), rows.begin(), rows.end());
    return list;
  }();
  return all;
}

std::string value_name(const Key& key) {
  if (*key.value != '\0') return key.value;
  switch (key.kind) {
    case KeyKind::flag:
      return "";
    case KeyKind::count:
      return "N";
    case KeyKind::file:
      return "FILE";
    case KeyKind::choice:
      return fmt::format("{}", fmt::join(key.choices, "|"));
    case KeyKind::text:
      break;
  }
  std::string name = key.name;
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return name;
}

bool can_be_alone(const Command& command) { return std::ranges::any_of(command.keys, &Key::without_project); }

const Command* find_command(std::string_view name) {
  const auto found = std::ranges::find(commands(), name, &Command::name);
  return found == commands().end() ? nullptr : &*found;
}

std::string file_table(const Command& command) { return project::table_path(command.name); }

std::string file_keys(const Command& command) {
  const Json whole = Json::parse(project::project_schema());
  const Json& file = whole["properties"];
  const Json& tables = file_table(command) == command.name ? file : file["analyses"]["properties"];
  if (!tables.contains(command.name)) return "";
  const Json* keys = properties_of(tables[command.name], whole);
  if (!keys) return "";
  std::string text;
  for (const auto& [key, value] : keys->items()) {
    if (key == "accept") continue;
    const Json& own = *resolved(value, whole);
    std::string words = value.contains("description") ? value["description"].get<std::string>()
        : own.contains("description")                 ? own["description"].get<std::string>()
                                                      : kind_words(own);
    if (own.contains("enum") && words != kind_words(own)) words += "; " + kind_words(own);
    text += fmt::format("  {:<18} {}\n", key, words);
  }
  return text.empty() ? text : "Keys of [" + file_table(command) + "] in the file:\n" + text;
}

}  // namespace trivet::engine
