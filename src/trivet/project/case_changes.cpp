// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/case_changes.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "trivet/foundation/plain_text.h"
#include "trivet/project/settings.h"
#include "trivet/project/text/changes.h"
#include "trivet/project/text/model_path.h"
#include "trivet/project/text/toml_text.h"

namespace trivet::project {
namespace {

const Node* table_of_cases(const Node& document) {
  const Node* cases = document.find("cases");
  return cases && cases->kind == Node::Kind::table ? cases : nullptr;
}

void report_no_path(const std::string& path, const Node& setting, foundation::Problems& problems) {
  problems
      .error(path, "cannot be changed as a whole", "a setting changes a number of a case",
             "name the number: cases.NAME.bodies.BODY.mass = …")
      .origin = setting.origin;
}

void report_unknown(const std::string& name, const Node* cases, const Node& setting, foundation::Problems& problems) {
  const std::vector<std::string> known = cases ? cases->keys : std::vector<std::string>();
  const std::string guess = foundation::nearest_name(name, known);
  problems
      .error("cases." + foundation::path_key(name), "no such case", "a setting changes a case that the file has",
             !guess.empty()      ? "did you mean \"" + guess + "\"?"
                 : known.empty() ? "the file has no cases"
                                 : "known: " + foundation::comma_separated(known))
      .origin = setting.origin;
}

/// Does this table stand for one value, which replaces another one as a whole?
bool is_one_value(const Node& node, const std::string& key) {
  return node.kind != Node::Kind::table || node.keys.empty() || (node.written_inline && is_exclusive_table(key));
}

/// "path = value" for each value, as a case has them.
void list_values(const Node& table, const std::string& path, std::string& lines, const std::string& line_end) {
  for (std::size_t i = 0; i < table.keys.size(); ++i) {
    const std::string here = (path.empty() ? "" : path + ".") + foundation::path_key(table.keys[i]);
    if (is_one_value(table.items[i], table.keys[i])) lines += here + " = " + toml_value(table.items[i]) + line_end;
    else list_values(table.items[i], here, lines, line_end);
  }
}

}  // namespace

bool is_of_case(const Node& setting) { return setting.keys.size() == 1 && setting.keys.front() == "cases"; }

Node merged_changes(Node first, const Node& second) {
  for (std::size_t i = 0; i < second.keys.size(); ++i) {
    const std::string& key = second.keys[i];
    const Node& change = second.items[i];
    Node* old = first.find(key);
    if (!old) {
      first.keys.push_back(key);
      first.items.push_back(change);
    } else if (old->kind == Node::Kind::table && !is_one_value(change, key)) {
      *old = merged_changes(std::move(*old), change);
    } else if (const auto component = change.kind == Node::Kind::table && change.keys.size() == 1
                   ? component_of(*old, change.keys.front())
                   : std::nullopt) {
      old->items[*component] = change.items.front();
    } else {
      *old = change;
    }
  }
  return first;
}

void change_cases(Node& document, const std::vector<Node>& settings, foundation::Problems& problems) {
  for (const Node& setting : settings) {
    if (!is_of_case(setting)) continue;
    const Node& names = setting.items.front();
    Node* cases = document.find("cases");
    for (std::size_t i = 0; i < names.keys.size(); ++i) {
      Node* changes = table_of_cases(document) ? cases->find(names.keys[i]) : nullptr;
      const Node& change = names.items[i];
      if (!changes || changes->kind != Node::Kind::table) report_unknown(names.keys[i], cases, setting, problems);
      else if (change.kind != Node::Kind::table) report_no_path("cases." + names.keys[i], setting, problems);
      else *changes = merged_changes(std::move(*changes), change);
    }
    if (names.kind != Node::Kind::table) report_no_path("cases", setting, problems);
  }
}

foundation::Expected<std::string> text_with_case(const std::string& text, const std::string& source,
                                                 const std::string& name, const std::string& like,
                                                 const std::vector<std::string>& settings) {
  auto before = parse_toml(text, source);
  if (!before) return tl::make_unexpected(before.error());
  foundation::Problems problems;
  const std::vector<Node> changes = read_settings(settings, "", problems).changes;
  change_cases(*before, changes, problems);
  const Node* cases = table_of_cases(*before);
  if (name.empty() || (cases && cases->find(name)))
    problems.error("cases", foundation::quoted(name), "a new case needs a name that no other case has",
                   "choose another name");
  const Node* known = cases && !like.empty() ? cases->find(like) : nullptr;
  if (!like.empty() && !known) report_unknown(like, cases, *before, problems);
  if (problems.has_errors()) return tl::make_unexpected(std::move(problems));

  Node of_case = known ? *known : Node();
  for (const Node& change : changes)
    if (!is_of_case(change)) of_case = merged_changes(std::move(of_case), change);
  for (const Node& change : changes)  // what is said of the case itself overrides what is said of all
    if (const Node* own = is_of_case(change) ? change.items.front().find(like) : nullptr)
      of_case = merged_changes(std::move(of_case), *own);
  const std::string line_end = text.find("\r\n") == std::string::npos ? "\n" : "\r\n";
  std::vector<Node> of_cases;
  std::ranges::copy_if(changes, std::back_inserter(of_cases), is_of_case);
  std::string result = text_with_changes(text, of_cases);
  if (!result.ends_with('\n')) result += line_end;
  result += fmt::format("{0}[cases.{1}]{0}", line_end, foundation::path_key(name));
  list_values(of_case, "", result, line_end);

  Node wanted = std::move(*before);
  if (!wanted.find("cases")) {
    wanted.keys.push_back("cases");
    wanted.items.emplace_back();
  }
  wanted.find("cases")->keys.push_back(name);
  wanted.find("cases")->items.push_back(of_case);
  const auto after = parse_toml(result, source);
  if (after && same_numbers(wanted, *after)) return result;
  return foundation::failure({.origin = {source, 0, 0},
                              .finding = "the case cannot be written at the end of its text",
                              .rule = "the new text must have this case more and nothing else",
                              .remedy = "write cases as tables: [cases.NAME]"});
}

}  // namespace trivet::project
