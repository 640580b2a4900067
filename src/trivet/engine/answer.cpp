// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/engine/answer.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "trivet/engine/command.h"
#include "trivet/engine/result.h"

namespace trivet::engine {
namespace {

using documents::json::Json;
using foundation::Problems;

/// What a page must not want: it reads results, and writes no files by commands.
Problems want_problems(const Request& want) {
  Problems problems;
  const Command* command = find_command(want.command);
  if (!command) return problems;  // reported by the session
  if (!command->json || command->for_programs)
    problems.error("wants", want.command, "a page can want commands with --json", "run it in a terminal");
  for (const Key& key : command->keys)
    for (const auto& [name, value] : want.keys)
      if (key.kind == KeyKind::file && name == key.name)
        problems.error(want.command + "." + name, "", "a page writes no files but the project", "leave the key out");
  return problems;
}

Result refused_result(const Request& want, Problems problems) {
  Result result;
  result.command = want.command;
  result.errors = std::move(problems);
  return result;
}

/// Nothing if the project is wrong and no request of it may be answered.
std::optional<Result> result_of(const Request& want, const Questioned& questioned,
                                const foundation::Progress& progress) {
  if (Problems problems = want_problems(want); problems.has_errors()) return refused_result(want, std::move(problems));
  if (questioned.session) return (*questioned.session)->ask(want, progress);
  if (!questioned.only_for) return std::nullopt;
  const auto own = questioned.only_for(want);
  return own ? own->ask(want, progress) : refused_result(want, own.error());
}

/// One entry of "results"; "json" has the bytes that the command prints with --json, unless the page knows them.
std::string result_text(const Result& result, const std::string& known) {
  const bool ok = !result.errors.has_errors() && result.failure.empty();
  const std::string bytes = ok && result.json ? whole(result.json) : "null";
  const std::string hash = fmt::format("{:016x}", std::hash<std::string>()(bytes));
  const bool same = ok && hash == known;
  std::string text = documents::json::text({{"command", result.command},
                                            {"ok", ok},
                                            {"problems", problem_list(ok ? shown_warnings(result) : result.errors)},
                                            {"failure", result.failure},
                                            {"failures", result.failures},
                                            {"notes", result.notes},
                                            {"hash", hash},
                                            {"same", same}});
  text.back() = ',';
  return text + "\"json\":" + (same ? "null" : bytes) + "}";
}

}  // namespace

Json problem_list(const Problems& problems) { return Json::parse(errors_json(problems))["problems"]; }

Problems warnings_of(const Session& session, const std::string& case_name) {
  const std::vector<std::string> cases = session.case_names();
  return std::ranges::find(cases, case_name) == cases.end() ? Problems() : session.model(case_name).warnings;
}

std::string answer_json(const Question& question, const Questioned& questioned, const foundation::Progress& progress) {
  std::string results;
  for (auto [request, known] : question.wants) {
    foundation::report_progress(progress, request.command, 0);
    const Command* command = find_command(request.command);
    if (command && command->of_one_case) request.case_name = question.case_name;
    const auto result = result_of(request, questioned, progress);
    foundation::report_progress(progress, request.command, 1);  // a newer question does not wait for its words
    if (result) results += (results.empty() ? "" : ",") + result_text(*result, known);
  }
  const auto& session = questioned.session;
  std::string head = documents::json::text(
      {{"revision", question.revision},
       {"ok", session.has_value()},
       {"version", questioned.version},
       {"problems", problem_list(session ? warnings_of(**session, question.case_name) : session.error())}});
  head.back() = ',';
  return head + "\"results\":[" + results + "]}";
}

}  // namespace trivet::engine
