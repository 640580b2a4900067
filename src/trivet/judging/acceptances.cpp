// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/judging/acceptances.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>

#include "trivet/foundation/plain_text.h"
#include "trivet/foundation/setting_words.h"
#include "trivet/project/text/accepting_tables.h"

namespace trivet::judging {
namespace {

std::string join(const std::string& path, const std::string& key) { return path.empty() ? key : path + "." + key; }

/// "[elements.\"front left\"]".
std::string header(const std::string& table) {
  if (table.empty()) return "at the top of the file";
  const std::size_t dot = table.find('.');
  if (dot == std::string::npos) return "in [" + table + "]";
  const std::string name = table.substr(dot + 1);
  const bool bare =
      std::ranges::all_of(name, [](unsigned char c) { return (c < 128 && std::isalnum(c)) || c == '_' || c == '-'; });
  return "in [" + table.substr(0, dot + 1) + (bare ? name : "\"" + name + "\"") + "]";
}

void read_table(const project::Node& table, const std::string& path, std::vector<Acceptance>& found,
                foundation::Problems& problems) {
  const project::Node* accept = table.find("accept");
  if (!accept) return;
  const std::string subject = join(path, "accept"), example = "for instance accept = {\"mass\" = \"with its water\"}";
  if (accept->kind != project::Node::Kind::table) {
    problems.error(subject, project::value_text(*accept), "it is a table of kinds of suspicions and reasons", example)
        .origin = accept->origin;
    return;
  }
  const std::vector<std::string> kinds(std::begin(plausibility::kinds), std::end(plausibility::kinds));
  for (std::size_t i = 0; i < accept->keys.size(); ++i) {
    const std::string& kind = accept->keys[i];
    const project::Node& reason = accept->items[i];
    if (std::ranges::find(kinds, kind) == kinds.end()) {
      const std::string guess = foundation::nearest_name(kind, kinds);
      problems
          .error(subject, foundation::quoted(kind), "there is no suspicion of this kind",
                 guess.empty() ? "the warning states its kind" : "did you mean \"" + guess + "\"?")
          .origin = reason.origin;
      continue;
    }
    if (reason.kind != project::Node::Kind::text || reason.text.find_first_not_of(" \t\n") == std::string::npos) {
      problems
          .error(subject, fmt::format("\"{}\" = {}", kind, project::value_text(reason)),
                 "an acceptance needs a reason in words", example)
          .origin = reason.origin;
      continue;
    }
    found.push_back({path, kind, reason.origin});
  }
}

}  // namespace

std::vector<Acceptance> read_acceptances(const project::Node& document, foundation::Problems& problems) {
  std::vector<Acceptance> found;
  read_table(document, "", found, problems);
  for (const char* single : project::accepting_tables)
    if (const project::Node* table = document.find(single); table && table->kind == project::Node::Kind::table)
      read_table(*table, single, found, problems);
  for (const char* holder : project::holders_of_accepting_tables) {
    const project::Node* parts = document.find(holder);
    if (!parts || parts->kind != project::Node::Kind::table) continue;
    for (std::size_t i = 0; i < parts->keys.size(); ++i)
      if (parts->items[i].kind == project::Node::Kind::table)
        read_table(parts->items[i], join(holder, parts->keys[i]), found, problems);
  }
  return found;
}

foundation::Problems AcceptanceBook::warnings(const std::vector<plausibility::Suspicion>& suspicions,
                                              const std::vector<Acceptance>& acceptances, const project::Node& document,
                                              const std::string& case_name) {
  for (const Acceptance& a : acceptances)
    if (known_.insert(key(a)).second) all_.push_back(a);
  foundation::Problems result;
  for (const plausibility::Suspicion& s : suspicions) {
    const std::string table = plausibility::table_of(s.subject);
    const auto accepted =
        std::ranges::find_if(acceptances, [&](const Acceptance& a) { return a.table == table && a.kind == s.kind; });
    if (accepted != acceptances.end()) {
      needed_.insert(key(*accepted));
      continue;
    }
    foundation::Problems one;
    one.warning(
        s.subject,
        s.by_case && !case_name.empty() ? s.finding + " in case " + foundation::quoted(case_name) : s.finding,
        fmt::format("suspicion \"{}\": {}", s.kind, s.rule),
        fmt::format("{}; if it is right: accept = {{\"{}\" = \"reason\"}} {}", s.probable, s.kind, header(table)));
    project::locate(one, document);
    const foundation::Origin& origin = one.list().front().origin;
    result.add(reported_
                   .try_emplace(Key{origin.source, origin.line, origin.column, s.subject,
                                    s.by_case ? s.kind + s.finding : s.kind},
                                one.list().front())
                   .first->second);
  }
  return result;
}

foundation::Problems AcceptanceBook::unused_acceptances(bool changed) const {
  foundation::Problems result;
  for (const Acceptance& a : all_)
    if (!needed_.contains(key(a)) && (!changed || a.origin.source.starts_with(foundation::setting_source)))
      result
          .error(join(a.table, "accept"), "\"" + a.kind + "\"", "no case has a suspicion of this kind here",
                 "remove it, so that it cannot hide a later one")
          .origin = a.origin;
  return result;
}

}  // namespace trivet::judging
