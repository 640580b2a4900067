// SPDX-License-Identifier: BSD-3-Clause
#include "cli/command_line.h"

#include <fmt/format.h>

#include <memory>
#include <mutex>
#include <optional>

#include "cli/colours.h"
#include "cli/console.h"
#include "cli/progress_line.h"
#include "cli/signals.h"
#include "trivet/engine/problem_lines.h"
#include "trivet/engine/program.h"
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

void write_text(const CommandLine& line, const engine::Result& result) {
  write_output(painted(engine::remarks_before(result), line.paint));
  const documents::Screen screen{output_width(), line.full};
  const engine::Sink output = [&line](std::string_view piece) { write_output(painted(piece, line.paint)); };
  if (result.text_on) output(result.text_on(screen));
  else result.text(output);
}

void write_result(const CommandLine& line, const engine::Result& result) {
  const engine::Sink output = [](std::string_view piece) { write_output(piece); };
  for (const std::string& remark : result.remarks) write_error("note: " + engine::on_one_line(remark) + "\n");
  if (line.form != Form::json && !line.command->warnings_within)
    write_error(painted(engine::message_list(line.form == Form::csv ? result.warnings : engine::shown_warnings(result)),
                        line.paint_errors));
  if (line.form == Form::json) return result.json(output);
  if (line.form == Form::csv) return result.tables.front().second(output);
  write_text(line, result);
}

}  // namespace

int run(CommandLine line) {
  const auto session = engine::Session::open(line.source, line.settings, &line.request);
  if (!session) return complain(line, session.error());
  line.request.ends_search = interruption();
  const engine::Result result = session->ask(line.request, progress());
  line.request.ends_search = {};  // from now on Ctrl-C ends the program
  if (result.errors.has_errors()) return complain(line, result.errors);
  if (!result.failure.empty()) {
    foundation::Problems failure;
    failure.error(result.failure, "", "", "");
    complain(line, failure);
  } else {
    write_result(line, result);
  }
  if (!result.not_written.empty()) write_error("error: " + engine::on_one_line(result.not_written) + "\n");
  const engine::Outcome code = engine::outcome(result, line.strict);
  if (line.strict && result.failure.empty() && result.complete && code != engine::Outcome::done)
    write_error(fmt::format("--strict: {}; exit code {}\n", result.findings.words(), static_cast<int>(code)));
  return static_cast<int>(code);
}

}  // namespace trivet::cli
