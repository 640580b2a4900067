// SPDX-License-Identifier: BSD-3-Clause
#include "cli/command_line.h"

#include <fmt/format.h>

#include <functional>
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

/// What may be asked to end early, from the first time on that it asks whether it is to end.
class EarlyEnd {
 public:
  [[nodiscard]] std::function<bool()> asked(Interruptible::Kind kind) {
    return [this, kind] {
      std::call_once(once_, [&] { begun_.emplace(kind); });
      return begun_->is_to_end();
    };
  }
  /// From now on signals end the program. @returns the exit code of the signal that asked for the end; 0: none has
  int over() {
    const int code = begun_ ? begun_->exit_code() : 0;
    begun_.reset();
    return code;
  }

 private:
  std::once_flag once_;
  std::optional<Interruptible> begun_;
};

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
std::unique_ptr<engine::ResultFile> result_file(CommandLine& line) {
  if (line.output.empty()) line.output = engine::taken_result_file(*line.command, line.request);
  if (!line.output.empty() && line.form != Form::text)
    throw foundation::InvalidInput("--output " + line.output + ": its ending chooses the form; omit --json and --csv");
  if (line.is_shown && page_of(line).empty())
    throw foundation::InvalidInput("--open shows a page: name one, as in -o result.html");
  if (line.output.empty()) return nullptr;
  return std::make_unique<engine::ResultFile>(line.output, *line.command, line.source.name);
}

}  // namespace

namespace {

int refuse(const CommandLine& line, const std::string& reason) {
  foundation::Problems refused;
  refused.error("", reason, "", "");
  return complain(line, refused);
}

/// What is asked about no project.
int run_alone(const CommandLine& line) {
  if (!line.source.name.empty() || !line.settings.empty() || !line.output.empty())
    return refuse(line, "this asks about no project; omit the project file and all other options");
  engine::Result result = engine::ask_without_project(line.request);
  if (result.errors.has_errors()) return complain(line, result.errors);
  write_result(line, nullptr, result);
  return static_cast<int>(engine::outcome(result, false));
}

}  // namespace

int run(CommandLine line) {
  if (engine::is_without_project(line.request)) return run_alone(line);
  if (line.source.name.empty())
    return refuse(line, "PROJECT is required: the project file (TOML); - for standard input");
  const auto session = engine::Session::open(line.source, line.settings, &line.request);
  if (!session) return complain(line, session.error());
  std::unique_ptr<engine::ResultFile> file;
  try {
    file = result_file(line);
  } catch (const foundation::InvalidInput& wrong) {
    return refuse(line, wrong.what());
  }
  EarlyEnd early_end;
  line.request.ends_search = early_end.asked(Interruptible::Kind::search);
  line.request.ends_study = early_end.asked(Interruptible::Kind::study);
  engine::Result result = session->ask(line.request, progress());
  const int code_of_signal = early_end.over();
  if (result.errors.has_errors()) return complain(line, result.errors);
  if (!result.failure.empty()) {
    foundation::Problems failure;
    failure.error(result.failure, "", "", "");
    complain(line, failure);
  } else {
    write_result(line, file.get(), result);
  }
  if (!result.not_written.empty()) write_error("error: " + engine::on_one_line(result.not_written) + "\n");
  if (!result.go_on.empty()) write_error("ended early; this goes on with the rest:\n  " + result.go_on + "\n");
  const bool is_there = result.failure.empty() && result.not_written.empty();
  const bool shown = !is_there || !line.is_shown || show_result(line);
  const engine::Outcome judged = engine::outcome(result, line.strict);
  const engine::Outcome code = judged == engine::Outcome::done && !shown ? engine::Outcome::not_computed : judged;
  if (line.strict && result.failure.empty() && result.complete && code != engine::Outcome::done)
    write_error(fmt::format("--strict: {}; exit code {}\n", result.findings.words(), static_cast<int>(code)));
  return !result.go_on.empty() && code_of_signal != 0 ? code_of_signal : static_cast<int>(code);
}

}  // namespace trivet::cli
