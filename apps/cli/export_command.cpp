// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/progress_line.h"
#include "trivet/exports/format.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"

namespace trivet::cli {
namespace {

/// "matrices, modes" → matrices, modes.
std::vector<std::string> names_in(const std::string& text) {
  std::vector<std::string> names;
  for (std::size_t from = 0; from <= text.size() && !text.empty();) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    std::string name = text.substr(from, comma - from);
    name.erase(0, name.find_first_not_of(' '));
    name.erase(name.find_last_not_of(' ') + 1);
    names.push_back(std::move(name));
    from = comma + 1;
  }
  return names;
}

}  // namespace

int export_command(const Options& options) {
  const auto project = read_or_complain(options);
  if (!project) return wrong_input;
  try {
    const project::Case& variant = chosen_case(*project, options.case_name);
    const std::vector<std::string> notes =
        exports::export_project(*project, variant, options.format, names_in(options.what), options.output, progress());
    for (const std::string& note : notes) write_error("note: " + foundation::on_one_line(note) + "\n");
    write_output(fmt::format("{}: {}\n", options.format, options.output));
    return done;
  } catch (const BadArgument& bad) {
    write_failure(bad);
  } catch (const foundation::InvalidInput& wrong) {
    write_failure(wrong);
  }
  return wrong_input;
}

}  // namespace trivet::cli
