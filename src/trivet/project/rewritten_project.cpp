// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/rewritten_project.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "trivet/foundation/plain_text.h"
#include "trivet/foundation/setting_words.h"
#include "trivet/project/case_changes.h"
#include "trivet/project/settings.h"
#include "trivet/project/text/changes.h"
#include "trivet/project/text/part_tables.h"
#include "trivet/project/text/source_file.h"
#include "trivet/project/text/toml_text.h"

namespace trivet::project {
namespace {

namespace fs = std::filesystem;

/// Reports changes of numbers that a table file holds.
void refuse_numbers_of_tables(const Project& project, const Node& change, const Node& at, const std::string& path,
                              foundation::Problems& problems) {
  for (std::size_t i = 0; i < change.keys.size(); ++i) {
    const std::string here = (path.empty() ? "" : path + ".") + foundation::path_key(change.keys[i]);
    const Node* next = at.kind == Node::Kind::table ? at.find(change.keys[i]) : nullptr;
    if (next && change.items[i].kind == Node::Kind::table) {
      refuse_numbers_of_tables(project, change.items[i], *next, here, problems);
      continue;
    }
    const std::string& source = (next ? *next : at).origin.source;
    if (source.empty() || source == project.source || source.starts_with(foundation::setting_source)) continue;
    problems
        .error(here, "it is in the table " + source, "--write changes the project file and no other file",
               "write the row into the project file: rows = [{…}] of [tables.…], or change the table by hand")
        .origin = (next ? *next : at).origin;
  }
}

/// Reports names of files that would lead elsewhere from the folder of the target.
void refuse_lost_files(const Node& node, const std::string& path, const fs::path& folder,
                       foundation::Problems& problems) {
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    const Node& item = node.items[i];
    const bool table = node.kind == Node::Kind::table;
    const std::string here =
        table ? (path.empty() ? "" : path + ".") + foundation::path_key(node.keys[i]) : fmt::format("{}[{}]", path, i);
    std::error_code error;
    const fs::path name = item.text;
    if (table && item.kind == Node::Kind::text && is_file_key(node.keys[i]) && name.is_relative() &&
        fs::is_regular_file(folder / name, error))
      problems
          .error(here, foundation::quoted(item.text),
                 "names of files are relative to the folder of the project file, and the file to write is in another",
                 fmt::format("write it to a file in {}", folder == "." ? "the folder of the project" : folder.string()))
          .origin = item.origin;
    refuse_lost_files(item, here, folder, problems);
  }
}

/// Is the file in this folder?
bool is_in(const fs::path& folder, const fs::path& file) {
  std::error_code error;
  return fs::equivalent(folder, file.has_parent_path() ? file.parent_path() : fs::path("."), error) && !error;
}

/// The base model of a text, with its tables.
foundation::Expected<Node> model_of(const std::string& text, const std::string& source) {
  foundation::Expected<Node> document = parse_toml(text, source);
  if (!document) return document;
  foundation::Problems problems;
  put_tables_in_place(*document, problems);
  if (problems.has_errors()) return tl::make_unexpected(std::move(problems));
  return document;
}

Node changed(Node document, const std::vector<Node>& changes) {
  foundation::Problems reported_when_read;
  for (const Node& change : changes)
    if (!is_of_case(change)) apply_changes(document, change, "", reported_when_read);
  change_cases(document, changes, reported_when_read);
  return document;
}

/// Settings override cases, and a case overrides the file.
void refuse_overridden_settings(const Project& project, const Node& model, const std::vector<Node>& settings,
                                const std::vector<Node>& changes, foundation::Problems& problems) {
  if (settings.empty()) return;
  const Node* cases = model.find("cases");
  for (const Case& variant : project.cases) {
    const Node* of_case = cases ? cases->find(variant.name) : nullptr;
    if (!of_case || same_numbers(changed(variant.written, changes), changed(model, {*of_case}))) continue;
    problems
        .error("cases." + foundation::path_key(variant.name), "it changes what a setting or a parameter changes",
               "a setting overrides a case, and the written file cannot", "remove it there, or leave the setting out")
        .origin = of_case->origin;
  }
}

/// The settings of a project, and all changes to write.
struct WrittenChanges {
  std::vector<Node> settings, all;
};

WrittenChanges written_changes(const Project& project, const std::vector<std::string>& settings,
                               const std::vector<Node>& changes, foundation::Problems& problems) {
  WrittenChanges written{read_settings(settings, folder_of_files(project), problems).changes, {}};
  written.all = written.settings;
  written.all.insert(written.all.end(), changes.begin(), changes.end());
  for (const Node& change : written.all)
    refuse_numbers_of_tables(project, change, project.base().written, "", problems);
  return written;
}

foundation::Problem cannot_be_written(const Project& project) {
  return {.origin = {project.source, 0, 0},
          .finding = "the changed numbers cannot be written into its text",
          .rule = "the written file must have these changes and no others",
          .remedy = "change it by hand, with the settings of the best design"};
}

}  // namespace

namespace {

foundation::Expected<std::string> changed_text(const std::string& text, const Project& project,
                                               const WrittenChanges& written, const std::vector<Node>& changes) {
  std::string result = text_with_changes(text, written.all);
  const auto before = model_of(text, project.source), after = model_of(result, project.source);
  if (!before || !after || !same_numbers(changed(*before, written.all), *after))
    return foundation::failure(cannot_be_written(project));
  foundation::Problems problems;
  refuse_overridden_settings(project, *after, written.settings, changes, problems);
  if (problems.has_errors()) return tl::make_unexpected(std::move(problems));
  return result;
}

}  // namespace

foundation::Expected<std::string> text_with_settings(const std::string& text, const Project& project,
                                                     const std::vector<std::string>& settings, const fs::path& target) {
  foundation::Problems problems;
  foundation::Expected<std::string> result = text;
  if (!settings.empty()) {
    const WrittenChanges written = written_changes(project, settings, {}, problems);
    if (!problems.has_errors()) result = changed_text(text, project, written, {});
  }
  const fs::path folder = folder_of_files(project);
  if (const auto given = result ? parse_toml(*result, project.source) : tl::make_unexpected(foundation::Problems());
      given && !target.empty() && !is_in(folder, target))
    refuse_lost_files(*given, "", folder, problems);
  if (problems.has_errors()) return tl::make_unexpected(std::move(problems));
  return result;
}

namespace {

/// Hashes of the files that a node names, one per line.
void add_files(const Node& node, std::string& hashes) {
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    const Node& item = node.items[i];
    if (node.kind == Node::Kind::table && item.kind == Node::Kind::text && is_file_key(node.keys[i])) {
      std::ifstream file(named_file(item), std::ios::binary);
      const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
      if (file) hashes += sha256(bytes) + "\n";
    }
    add_files(item, hashes);
  }
}

}  // namespace

std::string content_hash(const Project& project) {
  std::string all;
  for (const Case& variant : project.cases) {
    all += variant.name + "\n" + canonical(variant.written) + "\n";
    add_files(variant.written, all);
  }
  return sha256(all);
}

bool is_project_file(const fs::path& path) {
  const auto text = read_source(path);
  const auto document = text ? parse_toml(*text, path.string()) : tl::make_unexpected(text.error());
  return document && document->find("trivet");
}

foundation::Expected<std::string> rewritten_project(const Project& project, const std::vector<std::string>& settings,
                                                    const std::vector<Node>& changes, const fs::path& target) {
  const auto text = read_source(project.source);
  if (!text) return tl::make_unexpected(text.error());
  std::string hashed = *text;
  for (const std::string& setting : settings) hashed += "\n" + setting;
  if (sha256(hashed) != project.sha256)
    return foundation::failure({.origin = {project.source, 0, 0},
                                .finding = "the file was changed meanwhile",
                                .rule = "the numbers were computed for its earlier content",
                                .remedy = "start again"});
  foundation::Problems problems;
  const WrittenChanges written = written_changes(project, settings, changes, problems);
  if (const auto given = parse_toml(*text, project.source); given && !is_in(folder_of_files(project), target))
    refuse_lost_files(*given, "", folder_of_files(project), problems);
  if (problems.has_errors()) return tl::make_unexpected(std::move(problems));

  return changed_text(*text, project, written, changes);
}

}  // namespace trivet::project
