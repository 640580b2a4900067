// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/server/project_service.h"

#include <filesystem>
#include <stdexcept>
#include <utility>
#include <vector>

#include "trivet/documents/json_text.h"
#include "trivet/engine/answer.h"
#include "trivet/engine/program.h"
#include "trivet/project/case_changes.h"
#include "trivet/project/elements/catalogue.h"
#include "trivet/project/unopened_text.h"
#include "trivet/server/page_files.h"

namespace trivet::server {
namespace {

using documents::json::Json;
using foundation::Problems;

constexpr const char* unsaved_name = "machine.toml";  // in messages of a page without a project

/// Commands whose result a page can have: those with JSON.
Json commands_json() {
  Json list = Json::array();
  for (const engine::Command& command : engine::commands())
    if (command.json && !command.for_programs)
      list.push_back({{"name", command.name},
                      {"about", command.about},
                      {"group", engine::heading(command.group)},
                      {"of_one_case", command.of_one_case}});
  return list;
}

Json examples_json() {
  Json list = Json::array();
  for (const EmbeddedFile& file : example_files()) {
    const std::string name(file.name), text(file.content);
    list.push_back({{"name", name}, {"title", project::title_in_text(text, name)}, {"text", text}});
  }
  return list;
}

/// Of the generic catalogue, for the form of a new machine.
Json mounts_json() {
  Json list = Json::array();
  for (const project::Mount& mount : project::generic_catalogue().mounts) {
    const auto& along_axis = mount.rating.load[2];
    const Eigen::Vector3d& k = mount.translation;
    list.push_back({{"name", mount.name},
                    {"stiffness", Json::array({k.x(), k.y(), k.z()})},
                    {"static_load", along_axis ? Json::array({along_axis->x(), along_axis->y()}) : Json(nullptr)}});
  }
  return list;
}

Answer unprocessable(const std::string& sentence, const Problems& problems) {
  return {.status = 422,
          .body = documents::json::text({{"error", sentence}, {"problems", engine::problem_list(problems)}})};
}

Answer another_version() {
  return error_answer(412, "the program has opened another version of the file meanwhile; send the text");
}

/// Null if a page cannot have the text.
Json shown_text(const FileState& state) { return state.problems.has_errors() ? Json(nullptr) : Json(state.text); }

}  // namespace

Answer schema_answer() {
  static const std::string schema = engine::project_schema();
  return {.file = schema};
}

ProjectService::ProjectService(std::string file, bool read_only, std::string resume_key)
    : file_(std::move(file)),
      read_only_(read_only),
      resume_key_(std::move(resume_key)),
      sessions_(file_.empty() ? unsaved_name : file_) {
  if (!file_.empty()) open(read_state(file_));
}

FileState ProjectService::opened() const {
  const std::scoped_lock guard(lock_);
  return opened_;
}

void ProjectService::open(const FileState& state) {
  const std::scoped_lock guard(lock_);
  if (state.version == opened_.version && !state.version.empty()) return;  // its sessions stay
  sessions_.permit(PermittedFiles(file_, state.text));
  opened_ = state;
}

std::optional<ProjectService::Subject> ProjectService::subject_of(const engine::Question& question) const {
  FileState state = opened();
  if (question.text) return Subject{*question.text, std::move(state.version), {}};
  if (!question.version.empty() && question.version != state.version) return std::nullopt;
  return Subject{std::move(state.text), std::move(state.version), std::move(state.problems)};
}

Answer ProjectService::version() const {
  return {.body = documents::json::text({{"version", file_.empty() ? "" : read_state(file_).version}})};
}

Answer ProjectService::project(const foundation::Progress& progress) {
  Json answer{
      {"name", nullptr}, {"program", engine::version()}, {"commands", commands_json()}, {"resume_key", resume_key_}};
  if (file_.empty()) {
    answer["examples"] = examples_json();
    answer["mounts"] = mounts_json();
    return {.body = documents::json::text(answer)};
  }
  const FileState state = read_state(file_);
  open(state);
  Problems problems = state.problems;
  std::vector<std::string> cases{""};
  if (!problems.has_errors()) {
    const auto session = sessions_.of("", state.text, {}, progress);
    problems = session ? engine::warnings_of(**session, "") : session.error();
    if (session) cases = (*session)->case_names();
  }
  answer["name"] = std::filesystem::path(file_).filename().string();
  answer["title"] = project::title_in_text(state.text, file_);
  answer["text"] = shown_text(state);
  answer["version"] = state.version;
  answer["read_only"] = read_only_;
  answer["cases"] = cases;
  answer["problems"] = engine::problem_list(problems);
  return {.body = documents::json::text(answer)};
}

Answer ProjectService::ask(const std::string& client, const std::string& body, const foundation::Progress& progress) {
  const engine::Question question = engine::read_question(body);
  const auto subject = subject_of(question);
  if (!subject) return another_version();
  const std::string& text = subject->text;
  if (subject->problems.has_errors())
    return {.body = engine::answer_json(question, {.session = tl::make_unexpected(subject->problems)}, progress)};
  foundation::report_progress(progress, "opening the project", 0);
  engine::Questioned questioned{.session = sessions_.of(client, text, question.settings, progress),
                                .version = subject->version};
  if (!questioned.session && !sessions_.refused_files(text, question.settings).has_errors())
    questioned.only_for = [&](const engine::Request& want) {
      return sessions_.only_for(want, text, question.settings, progress);
    };
  return {.body = engine::answer_json(question, questioned, progress)};
}

foundation::Expected<std::string> ProjectService::new_text(const std::string& client, const std::string& text,
                                                           const std::vector<std::string>& settings) {
  if (Problems refused = sessions_.refused_files(text, settings); refused.has_errors())
    return tl::make_unexpected(std::move(refused));
  if (settings.empty()) return text;  // a wrong text may be saved, as in an editor
  const auto session = sessions_.of(client, text, settings);
  if (!session) return tl::make_unexpected(session.error());
  return (*session)->text_with_settings();
}

foundation::Expected<std::string> ProjectService::text_with_new_case(const std::string& text,
                                                                     const engine::Question& question) const {
  if (Problems refused = sessions_.refused_files(text, question.settings); refused.has_errors())
    return tl::make_unexpected(std::move(refused));
  return project::text_with_case(text, file_.empty() ? unsaved_name : file_, *question.new_case, question.case_name,
                                 question.settings);
}

Answer ProjectService::text(const std::string& client, const std::string& body) {
  const engine::Question question = engine::read_question(body);
  const auto given = subject_of(question);
  if (!given) return another_version();
  if (given->problems.has_errors()) return unprocessable("the file has no text", given->problems);
  const auto text =
      question.new_case ? text_with_new_case(given->text, question) : new_text(client, given->text, question.settings);
  if (!text) return unprocessable("the text with these settings is wrong", text.error());
  return {.body = documents::json::text({{"text", *text}})};
}

Answer ProjectService::save(const std::string& client, const std::string& body) {
  const engine::Question question = engine::read_question(body);
  if (read_only_) return error_answer(403, "the server was started with --read-only; nothing is saved");
  if (file_.empty()) return error_answer(409, "the page was opened without a project file; start trivet serve FILE");
  const std::scoped_lock guard(saving_);
  const FileState on_disk = read_state(file_);
  if (on_disk.version != question.version)
    return {.status = 409,
            .body = documents::json::text({{"error", "the file was changed meanwhile; nothing is written"},
                                           {"version", on_disk.version},
                                           {"text", shown_text(on_disk)},
                                           {"problems", engine::problem_list(on_disk.problems)}})};
  if (on_disk.is_hidden()) return unprocessable("nothing is written over what the page cannot show", on_disk.problems);
  const auto text = new_text(client, question.text.value_or(on_disk.text), question.settings);
  if (!text) return unprocessable("the text with these settings is wrong", text.error());
  if (text->find_first_not_of(" \t\r\n") == std::string::npos || text->find('\0') != std::string::npos)
    return error_answer(422, "a project file has text and no NUL bytes");
  replace_text(file_, *text);
  open({.text = *text, .version = version_of(*text)});
  return {.body = documents::json::text({{"version", version_of(*text)}})};
}

}  // namespace trivet::server
