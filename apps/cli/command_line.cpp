// SPDX-License-Identifier: BSD-3-Clause
#include "cli/command_line.h"

#include <fmt/format.h>

#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>

#include "cli/colours.h"
#include "cli/console.h"
#include "cli/progress_line.h"
#include "cli/shown_page.h"
#include "cli/signals.h"
#include "trivet/engine/problem_lines.h"
#include "trivet/engine/program.h"
#include "trivet/engine/result_file.h"
#include "trivet/engine/session.h"

namespace trivet::cli {
namespace {

int complain(const CommandLine& line, const foundation::Problems& errors) {
  if (line.form == Form::json) write_output(engine::errors_json(errors));
  write_error(painted(engine::message_list_with_lines(errors, line.source), line.paint_errors));
  return static_cast<int>(engine::Outcome::wrong_input);
}

/// From its first call on, Ctrl-C asks a search to end with the best design so far.
std::function<bool()> interruption() {
  struct Begun {
    std::once_flag once;
    std::optional<InterruptibleSearch> search;
  };
  return [begun = std::make_shared<Begun>()] {
    std::call_once(begun->once, [&] { begun->search.emplace(); });
    return begun->search->is_to_end();
  };
}

/// On a terminal in lines of its width; programs that read a pipe get each sentence on one line.
void write_text(const CommandLine& line, const engine::Result& result) {
  const documents::Screen screen{output_width(), line.full};
  const std::string text =
      engine::remarks_before(result) + (result.text_on ? result.text_on(screen) : engine::whole(result.text));
  write_output(painted(documents::with_line_breaks(text, screen.width), line.paint));
}

void write_result(const CommandLine& line, const engine::ResultFile* file, engine::Result& result) {
  const engine::Sink output = [](std::string_view piece) { write_output(piece); };
  for (const std::string& remark : result.remarks) write_error("note: " + engine::on_one_line(remark) + "\n");
  if (line.form != Form::json && !line.command->warnings_within)
    write_error(painted(engine::message_list(line.form == Form::csv ? result.warnings : engine::shown_warnings(result)),
                        line.paint_errors));
  if (line.form == Form::json) return result.json(output);
  if (line.form == Form::csv) return result.tables.front().second(output);
  if (!file) return write_text(line, result);
  try {
    file->publish(result);
    write_output(line.output + ": written\n");
  } catch (const std::runtime_error& reason) {
    result.add_not_written(reason.what());
  }
}

/// The page that the command writes; empty: none.
std::string page_of(const CommandLine& line) {
  if (line.command->name != "run") return line.output.ends_with(".html") ? line.output : "";
  std::string folder;
  for (const engine::Key& key : line.command->keys)
    if (std::string_view(key.name) == "output") folder = key.by_default;
  for (const auto& [key, value] : line.request.keys)
    if (key == "output") folder = std::get<std::string>(value);
  return folder + "/report.html";
}

/// @returns false if the page cannot be shown
bool show_result(const CommandLine& line) {
  const std::string page = page_of(line), reason = show_page(page);
  if (!reason.empty()) write_error("error: " + engine::on_one_line(page + " is not shown: " + reason) + "\n");
  return reason.empty();
}

/// The file that is requested, checked; null: none. @throws foundation::InvalidInput
std::unique_ptr<engine::ResultFile> result_file(const CommandLine& line) {
  if (line.is_shown && page_of(line).empty())
    throw foundation::InvalidInput("--open shows a page: name one, as in -o result.html");
  if (line.output.empty()) return nullptr;
  return std::make_unique<engine::ResultFile>(line.output, *line.command, line.source.name);
}

}  // namespace

int run(CommandLine line) {
  const auto session = engine::Session::open(line.source, line.settings, &line.request);
  if (!session) return complain(line, session.error());
  std::unique_ptr<engine::ResultFile> file;
  try {
    file = result_file(line);
  } catch (const foundation::InvalidInput& wrong) {
    foundation::Problems refused;
    refused.error("", wrong.what(), "", "");
    return complain(line, refused);
  }
  line.request.ends_search = interruption();
  engine::Result result = session->ask(line.request, progress());
  line.request.ends_search = {};  // from now on Ctrl-C ends the program
  if (result.errors.has_errors()) return complain(line, result.errors);
  if (!result.failure.empty()) {
    foundation::Problems failure;
    failure.error(result.failure, "", "", "");
    complain(line, failure);
  } else {
    write_result(line, file.get(), result);
  }
  if (!result.not_written.empty()) write_error("error: " + engine::on_one_line(result.not_written) + "\n");
  const bool is_there = result.failure.empty() && result.not_written.empty();
  const bool shown = !is_there || !line.is_shown || show_result(line);
  const engine::Outcome judged = engine::outcome(result, line.strict);
  const engine::Outcome code = judged == engine::Outcome::done && !shown ? engine::Outcome::not_computed : judged;
  if (line.strict && result.failure.empty() && result.complete && code != engine::Outcome::done)
    write_error(fmt::format("--strict: {}; exit code {}\n", result.findings.words(), static_cast<int>(code)));
  return static_cast<int>(code);
}

}  // namespace trivet::cli
