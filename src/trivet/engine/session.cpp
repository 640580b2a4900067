// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/engine/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <stdexcept>

#include "trivet/engine/case_alone.h"
#include "trivet/engine/key_reader.h"
#include "trivet/engine/solved_cases.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/foundation/temporary_folder.h"
#include "trivet/judging/read_project.h"
#include "trivet/project/analysis_filter.h"
#include "trivet/project/rewritten_project.h"
#include "trivet/project/text/source_file.h"
#include "trivet/results/files/whole_file.h"
#include "trivet/results/model/project_json.h"

namespace trivet::engine {
namespace {

using foundation::InvalidInput;

/// The part of a file that a request looks at.
project::AnalysisFilter looked_at(const Request* request) {
  const Command* command = request ? find_command(request->command) : nullptr;
  if (!command || command->all_tables) return {};
  project::AnalysisFilter filter{command->looks_at, {}, {}, 0};
  if (command->of_one_case || !request->case_name.empty()) filter.of_case = request->case_name;
  if (command->is_analysis) {
    filter.command = command->name;
    const auto lowest = std::ranges::find(request->keys, "lowest", [](const auto& key) { return key.first; });
    foundation::Problems wrong;  // reported when the request is asked
    if (lowest != request->keys.end()) filter.lowest_modes = KeyReader(*command, *request, wrong).count("lowest");
  }
  return filter;
}

const project::Case& case_of(const project::Project& project, const std::string& name, const std::string& before_keys) {
  if (const project::Case* found = project.find(name)) return *found;
  std::vector<std::string> names;
  std::string known;
  for (const project::Case& variant : project.cases) {
    names.push_back(variant.name);
    if (!variant.name.empty()) known += (known.empty() ? "known: " : ", ") + variant.name;
  }
  const std::string guess = foundation::nearest_name(name, names);
  throw InvalidInput(fmt::format(
      "{}case \"{}\": no such case; {}", before_keys, name,
      guess.empty() ? (known.empty() ? "the project has none" : known) : "did you mean \"" + guess + "\"?"));
}

/// The picture file that a request names, prepared; nullptr if it names none.
std::unique_ptr<results::PictureFile> new_picture(const KeyReader& keys, const std::string& project_file) {
  const Value* file = keys.find("picture");
  if (!file) return nullptr;
  const std::string name = text_of(*file);
  if (!name.ends_with(".svg"))
    throw InvalidInput(
        fmt::format("{}: {}: pictures are SVG; name a file that ends in .svg", keys.written("picture"), name));
  try {
    return std::make_unique<results::PictureFile>(name, project_file);
  } catch (const InvalidInput& refused) {
    throw InvalidInput(keys.written("picture") + " " + refused.what());
  }
}

Result run_with_picture(const Task& task) {
  const auto picture = new_picture(task.keys, task.project->source);
  Result result = task.command.run(task);
  if (!picture || result.figures.empty()) return result;  // a wrong request has none
  try {
    picture->publish(whole(result.figures.front().second));
  } catch (const std::runtime_error& reason) {  // the result is there nevertheless
    result.add_not_written(reason.what());
  }
  return result;
}

}  // namespace

/// A slider makes many projects whose hash nobody asks for.
struct Session::Content {
  std::once_flag once;
  std::string hash;
};

foundation::Expected<Session> Session::open(const Source& source, const std::vector<std::string>& settings,
                                            const Request* only_for) {
  foundation::remove_abandoned_folders();
  foundation::Expected<std::string> text = source.text ? *source.text : project::read_source(source.name);
  if (!text) return tl::make_unexpected(std::move(text.error()));
  if (only_for) {
    auto read = judging::project_from_text_for(looked_at(only_for), *text, source.name, settings, source.folder);
    if (!read) return tl::make_unexpected(std::move(read.error()));
    return of(std::move(*read), "", settings);
  }
  auto read = judging::project_from_text(*text, source.name, settings, source.folder);
  if (!read) return tl::make_unexpected(std::move(read.error()));
  Session opened = of(std::move(*read), std::move(*text), settings);
  static_cast<void>(opened.content());  // of the files as they are now
  return opened;
}

Session Session::of(project::Project project, std::string text, const std::vector<std::string>& settings) {
  Session session;
  session.text_ = std::move(text);
  session.settings_ = settings;
  session.project_ = std::make_shared<const project::Project>(std::move(project));
  session.solved_ = std::make_shared<SolvedCases>();
  session.content_ = std::make_shared<Content>();
  return session;
}

foundation::Expected<Session> Session::changed(const std::vector<std::string>& settings) const {
  auto changed = judging::changed_project(*project_, settings);
  if (!changed) return tl::make_unexpected(std::move(changed.error()));
  return of(std::move(*changed), text_, settings);
}

Result Session::ask(const Request& request, const foundation::Progress& progress) const {
  Result result;
  result.command = request.command;
  result.case_name = request.case_name;
  result.title = title();
  try {
    const Command* command = find_command(request.command);
    if (!command) throw InvalidInput("no command is called \"" + request.command + "\"");
    const bool alone = !command->of_one_case && !request.case_name.empty();
    if (alone && command->case_alone.empty())
      result.errors.error(request.before_keys + "case \"" + request.case_name + "\"", "",
                          command->without_case.empty()
                              ? request.command + " is about the whole project, in all its cases"
                              : command->without_case,
                          "remove it; its result names each case");
    const KeyReader keys(*command, request, result.errors);
    if (result.errors.has_errors()) return result;
    const project::Case& named = case_of(*project_, request.case_name, request.before_keys);
    const std::shared_ptr<const project::Project> project = alone ? case_alone(*project_, named) : project_;
    const project::Case& variant = alone ? project->base() : named;
    const foundation::ThreadLimit limit(request.threads);
    Result found = run_with_picture({*command, project, settings_, variant, keys, request, progress, *solved_});
    found.command = result.command;
    found.case_name = result.case_name;
    found.title = result.title;
    found.findings.add(found.warnings);
    return found;
  } catch (const InvalidInput& wrong) {
    result.errors.error("", wrong.what(), "", "");
  } catch (const foundation::NotComputable& reason) {
    result.failure = reason.what();
  }
  return result;
}

const std::string& Session::content() const {
  std::call_once(content_->once, [this] {
    if (!text_.empty()) content_->hash = project::content_hash(*project_);
  });
  return content_->hash;
}

const project::Case& Session::model(const std::string& case_name) const { return case_of(*project_, case_name, ""); }

std::string Session::model_json(const std::string& case_name) const { return results::model_json(model(case_name)); }

std::vector<std::string> Session::case_names() const {
  std::vector<std::string> names;
  for (const project::Case& variant : project_->cases) names.push_back(variant.name);
  return names;
}

std::vector<std::string> Session::element_names() const {
  std::vector<std::string> names;
  for (const model::Element& element : project_->base().system.elements()) names.push_back(element.name);
  return names;
}

foundation::Expected<std::string> Session::text_with_settings(const std::string& target) const {
  return project::text_with_settings(text_, *project_, settings_, target);
}

namespace {

bool is_alone(const Command& command, const Keys::value_type& key) {
  return std::ranges::any_of(command.keys,
                             [&](const Key& row) { return row.without_project && row.name == key.first; });
}

}  // namespace

bool is_without_project(const Request& request) {
  const Command* command = find_command(request.command);
  return command && std::ranges::any_of(request.keys, [&](const auto& key) { return is_alone(*command, key); });
}

Result ask_without_project(const Request& request) {
  Result result;
  result.command = request.command;
  const Command& command = *find_command(request.command);
  const KeyReader keys(command, request, result.errors);
  for (const auto& key : request.keys)
    if (!is_alone(command, key))
      result.errors.error(keys.written(key.first), text_of(key.second), "this asks about no project", "leave it out");
  if (!request.case_name.empty())
    result.errors.error(keys.written("case"), request.case_name, "this asks about no project", "leave it out");
  if (result.errors.has_errors()) return result;
  try {
    Result found = command.run_alone(keys);
    found.command = request.command;
    return found;
  } catch (const InvalidInput& wrong) {
    result.errors.error("", wrong.what(), "", "");
  }
  return result;
}

}  // namespace trivet::engine
