// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/written_project.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "trivet/foundation/plain_text.h"
#include "trivet/foundation/setting_words.h"
#include "trivet/project/analyses/analysis_sizes.h"
#include "trivet/project/case_changes.h"
#include "trivet/project/settings.h"
#include "trivet/project/text/changes.h"
#include "trivet/project/text/part_tables.h"
#include "trivet/project/text/source_file.h"
#include "trivet/project/text/toml_text.h"

namespace trivet::project {
namespace {

constexpr std::size_t most_cases = 1000;

/// Number of bodies, nodes, elements and excitations in all cases together; each case has a separate model.
std::size_t parts_of_cases(const Node& document) {
  const auto count = [&](const char* table) { return document.find(table) ? document.find(table)->keys.size() : 0; };
  return count("cases") * (count("bodies") + count("nodes") + count("elements") + count("excitations"));
}

/// Reports cases that are not tables, or too many; false if there is none to read.
bool are_readable(const Node* cases, std::size_t parts, foundation::Problems& problems) {
  if (parts > most_parts_of_cases) {
    problems
        .error("cases", fmt::format("{} bodies, nodes, elements and excitations in all cases together", parts),
               fmt::format("at most {} are allowed", most_parts_of_cases), "split the file")
        .origin = cases->origin;
  } else if (cases && cases->kind != Node::Kind::table) {
    problems.error("cases", kind_name(cases->kind), "cases are tables", "write [cases.NAME]").origin = cases->origin;
  } else if (cases && cases->keys.size() > most_cases) {
    problems
        .error("cases", fmt::format("{} cases", cases->keys.size()), fmt::format("a file holds at most {}", most_cases),
               "split the file")
        .origin = cases->origin;
  } else {
    return cases != nullptr;
  }
  return false;
}

/// Settings of the base model, which hold in every case.
Settings of_all_cases(Settings settings) {
  std::erase_if(settings.changes, is_of_case);
  std::erase_if(settings.numbers, [](const ChangedNumber& number) { return number.path.starts_with("cases."); });
  return settings;
}

/// What a setting sets in this case; null if it is not of this case alone.
const Node* change_of_case(const Node& setting, const std::string& name) {
  const Node* cases = is_of_case(setting) ? setting.find("cases") : nullptr;
  return cases ? cases->find(name) : nullptr;
}

/// All cases have the same drawn designs.
void refuse_tolerances(const std::string& name, const Node& change, foundation::Problems& problems) {
  const auto refuse = [&](const Node* own, const std::string& key, const char* remedy) {
    if (own)
      problems
          .error("cases." + foundation::path_key(name) + "." + key, "cannot be changed",
                 "tolerances hold for all cases, which have the same drawn designs", remedy)
          .origin = own->origin;
  };
  refuse(change.find("tolerances"), "tolerances", "write them in [tolerances], or judge the case in a file of its own");
  const Node* analyses = change.find("analyses");
  refuse(analyses ? analyses->find("sample") : nullptr, "analyses.sample",
         "write it in [analyses.sample], or as a setting, analyses.sample.KEY=VALUE");
  if (const Node* own = analyses ? analyses->find("box") : nullptr)
    problems
        .error("cases." + foundation::path_key(name) + ".analyses.box", "cannot be changed",
               "one box holds for all cases in which the design has to hold",
               "write it in [analyses.box], or as a setting, analyses.box.KEY=VALUE")
        .origin = own->origin;
}

/// @param written  the document with the changed cases, without other settings of the command line
WrittenCase written_case(const std::string& name, const Node& change, const Node& written, const Settings& settings) {
  WrittenCase result{.name = name};
  if (change.kind != Node::Kind::table || name.empty()) {
    result.is_readable = false;
    result.problems
        .error("cases." + name, name.empty() ? "name \"\"" : kind_name(change.kind), "a case is a table with a name",
               "write [cases.NAME] and the changed numbers below")
        .origin = change.origin;
    return result;
  }
  result.document = written;
  if (const Node* report = change.find("report"))
    result.problems
        .error("cases." + name + ".report", "cannot be changed", "all cases share one report",
               "write it in [report], or as a setting, report.KEY=VALUE")
        .origin = report->origin;
  refuse_tolerances(name, change, result.problems);
  apply_changes(result.document, change, "", result.problems);
  for (const Node& setting : settings.changes)  // the command line overrides the case
    if (!is_of_case(setting)) apply_changes(result.document, setting, "", result.problems);
  foundation::Problems reported_before;
  for (const Node& setting : settings.changes)  // and what it says of this case alone overrides what it says of all
    if (const Node* own = change_of_case(setting, name)) apply_changes(result.document, *own, "", reported_before);
  result.changes = change_lines(&change, of_all_cases(settings), result.document);
  return result;
}

/// The cases of a document with its settings.
std::vector<WrittenCase> written_cases(const Node& document, const Node& written, const Settings& settings) {
  std::vector<WrittenCase> result;
  const Node* cases = document.find("cases");
  WrittenCase refused{.is_readable = false};
  if (!are_readable(cases, parts_of_cases(document), refused.problems)) {
    if (!refused.problems.list().empty()) result.push_back(std::move(refused));
    return result;
  }
  for (std::size_t i = 0; i < cases->keys.size(); ++i)
    result.push_back(written_case(cases->keys[i], cases->items[i], written, settings));
  return result;
}

/// Does a case change the number that a setting sets? @param setting  nested tables of one key down to the number
bool changes_same_number(const Node& change, const Node& setting) {
  const Node *in_case = &change, *in_setting = &setting;
  while (in_setting->kind == Node::Kind::table && in_setting->keys.size() == 1) {
    in_case = in_case->kind == Node::Kind::table ? in_case->find(in_setting->keys.front()) : nullptr;
    if (!in_case) return false;
    in_setting = &in_setting->items.front();
  }
  return true;
}

/// Warnings of settings that replace a change of a case, one for each.
foundation::Problems settings_over_cases(const Node& document, const std::vector<std::string>& given,
                                         const Settings& settings) {
  foundation::Problems warnings;
  const Node* cases = document.find("cases");
  if (!cases || cases->kind != Node::Kind::table || given.size() != settings.changes.size()) return warnings;
  const auto sets_again = [&](const std::string& name, const Node& number) {
    return std::ranges::any_of(settings.changes, [&](const Node& other) {
      const Node* own = change_of_case(other, name);
      return own && changes_same_number(*own, number);
    });
  };
  for (std::size_t i = 0; i < given.size(); ++i) {
    std::vector<std::string> names;
    for (std::size_t c = 0; c < cases->keys.size(); ++c)
      if (changes_same_number(cases->items[c], settings.changes[i]) && !sets_again(cases->keys[c], settings.changes[i]))
        names.push_back(foundation::quoted(cases->keys[c]));
    if (!names.empty())
      warnings.warning(std::string(foundation::setting_source) + given[i],
                       fmt::format("also replaces that of case {}", foundation::comma_separated(names)),
                       "a setting is applied to the base model and again to every case",
                       "to keep the change of the case set it again: cases.NAME.PATH=VALUE");
  }
  return warnings;
}

WrittenProject with_settings(Project project, const std::vector<std::string>& given) {
  WrittenProject result;
  std::string hashed = project.parsed->text;
  for (const std::string& setting : given) hashed += "\n" + setting;
  project.sha256 = sha256(hashed);
  project.settings = given;
  const Settings all = read_settings(given, folder_of_files(project), result.problems);
  std::optional<Node> with_changed_cases;
  if (std::ranges::any_of(all.changes, is_of_case))
    change_cases(with_changed_cases.emplace(project.parsed->document), all.changes, result.of_settings);
  const Node& written = with_changed_cases ? *with_changed_cases : project.parsed->document;
  const Settings settings = of_all_cases(all);
  result.problems.add(project.parsed->problems);
  result.base.document = written;
  for (const Node& change : settings.changes) apply_changes(result.base.document, change, "", result.of_settings);
  result.problems.add(result.of_settings);
  result.base.changes = change_lines(nullptr, settings, result.base.document);
  result.cases = written_cases(result.base.document, written, all);
  result.over_cases = settings_over_cases(written, given, all);
  result.project = std::move(project);
  return result;
}

}  // namespace

foundation::Expected<WrittenProject> written_project(const std::string& text, const std::string& source,
                                                     const std::vector<std::string>& settings,
                                                     const std::string& folder) {
  foundation::Expected<Node> document = parse_toml(text, source);
  if (!document) return tl::make_unexpected(document.error());
  if (!folder.empty()) set_folder(*document, folder);
  ParsedText parsed{text, std::move(*document), {}};
  put_tables_in_place(parsed.document, parsed.problems);
  Project project;
  project.source = source;
  project.folder = folder;
  project.parsed = std::make_shared<const ParsedText>(std::move(parsed));
  return with_settings(std::move(project), settings);
}

WrittenProject written_project(const Project& earlier, const std::vector<std::string>& settings) {
  Project project;
  project.source = earlier.source;
  project.folder = earlier.folder;
  project.parsed = earlier.parsed;
  return with_settings(std::move(project), settings);
}

}  // namespace trivet::project
