// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cli/colours.h"
#include "cli/command_line.h"
#include "cli/console.h"
#include "cli/main_program.h"
#include "cli/parser.h"
#include "cli/shown_page.h"
#include "cli/signals.h"
#include "trivet/engine/names.h"
#include "trivet/engine/program.h"
#include "trivet/server/page_server.h"

namespace {

using trivet::cli::CommandLine;
using trivet::cli::FurtherWords;

constexpr int wrong_input = static_cast<int>(trivet::engine::Outcome::wrong_input);

/// Reports a word that is not a command.
void refuse_command(CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App* one) { return !one->get_group().empty(); }))
    names.push_back(command->get_name());
  const std::string guess = trivet::foundation::nearest_name(word, names);
  trivet::cli::write_error("error: " + trivet::engine::quoted(word) + " is not a command; " +
                           (guess.empty() ? "trivet --help lists them" : "did you mean \"" + guess + "\"?") + "\n");
}

/// Reports words that look like options of a command and are not; false if it has none.
bool refuse_options(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  bool is_refused = false;
  for (const std::string& given : command.remaining()) {
    if (!given.starts_with("--") || given == "--") continue;
    const std::string word = given.substr(0, given.find('=')), guess = trivet::foundation::nearest_name(word, names);
    trivet::cli::write_error(
        "error: " + trivet::engine::quoted(word) + " is not an option of " + command.get_name() + "; " +
        (guess.empty() ? "trivet help " + command.get_name() + " lists them" : "did you mean \"" + guess + "\"?") +
        "\n");
    is_refused = true;
  }
  return is_refused;
}

int print_help(CLI::App& app, const std::string& command) {
  const auto found = app.get_subcommands([&](const CLI::App* one) { return one->get_name() == command; });
  if (found.empty() && !command.empty()) {
    refuse_command(app, command);
    return wrong_input;
  }
  trivet::cli::write_output(command.empty() ? app.help() : found.front()->help("trivet"));
  return 0;
}

/// Prints help and version unchanged; for a wrong command line, prints what the user typed as printable text.
int said_by_parser(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) return app.exit(error);
  std::stringstream text;
  static_cast<void>(app.exit(error, text, text));
  std::string mark = "error: ";
  for (std::string one; std::getline(text, one); mark.clear())
    trivet::cli::write_error(mark + trivet::engine::on_one_line(one) + "\n");
  return wrong_input;
}

/// Writes the starter file, or prints it if no file is named. An existing file stays.
int write_starter(const std::string& file) {
  if (file.empty()) return trivet::cli::write_output(trivet::engine::starter_text()), 0;
  errno = 0;
  std::FILE* stream = std::fopen(file.c_str(), "wx");
  if (!stream) {
    const std::string reason = errno == EEXIST ? "it exists; choose another name" : std::strerror(errno);
    trivet::cli::write_error("error: " + trivet::engine::on_one_line(file) + ": " + reason + "\n");
    return wrong_input;
  }
  const std::string text = trivet::engine::starter_text();
  const bool written = std::fwrite(text.data(), 1, text.size(), stream) == text.size();
  if (std::fclose(stream) != 0 || !written) throw std::runtime_error(file + ": could not be written completely");
  trivet::cli::write_output(file + ": a project to begin with; trivet run " + file + "\n");
  return 0;
}

/// The whole standard input as the project; names of files are relative to the current folder.
void read_standard_input(trivet::engine::Source& source) {
  std::ostringstream text;
  text << std::cin.rdbuf();
  source = {trivet::engine::standard_input, text.str(), "."};
}

std::vector<std::string> names_of_kind(const trivet::engine::Session& session, const std::string& kind) {
  if (kind == "cases") return session.case_names();
  if (kind == "elements") return session.element_names();
  if (kind == "results") return trivet::engine::result_names(session);
  std::vector<std::string> paths = trivet::engine::number_paths(session);
  for (std::string& one : paths) one += "=";
  return paths;
}

/// Names of a kind in the project, a line each; nothing if it cannot be read.
int print_names(const CommandLine& line, const std::string& kind) {
  const auto session = trivet::engine::Session::open(line.source);
  if (!session) return wrong_input;
  std::string text;
  for (const std::string& name : names_of_kind(*session, kind))
    if (!name.empty()) text += name + "\n";
  return trivet::cli::write_output(text), 0;
}

/// Serves the page of a project until a signal ends the program; a wrong project, too, but not a missing one.
int serve_page(const CommandLine& line, const FurtherWords& words) {
  if (!line.source.name.empty())
    if (const auto text = trivet::engine::read_source(line.source.name); !text) {
      trivet::cli::write_error(trivet::engine::message_list(text.error()));
      return wrong_input;
    }
  trivet::server::ServeOptions options{.file = line.source.name, .port = words.port, .read_only = words.read_only};
  options.say = trivet::cli::write_output;
  options.log = trivet::cli::write_error;
  if (!words.no_browser) options.show = trivet::cli::show_page;
  try {
    trivet::server::serve(options);
  } catch (const trivet::foundation::InvalidInput& wrong) {
    trivet::cli::write_error("error: " + trivet::engine::on_one_line(wrong.what()) + "\n");
    return wrong_input;
  }
}

int exit_code_of(const CLI::App& app, CommandLine& line, const FurtherWords& words) {
  const std::string name = app.get_subcommands().front()->get_name();
  if (name == "new") return write_starter(words.starter);
  if (name == "serve") return serve_page(line, words);
  if (name == "schema") return trivet::cli::write_output(trivet::engine::project_schema()), 0;
  if (name == "man") return trivet::cli::write_output(trivet::cli::manual_page(trivet::cli::described_program(app))), 0;
  if (name == "completion")
    return trivet::cli::write_output(trivet::cli::completion_script(trivet::cli::described_program(app), words.shell)),
           0;
  if (name == "names") return print_names(line, words.kind);
  line.command = trivet::engine::find_command(name);
  line.request.command = name;
  line.request.before_keys = "--";
  line.paint = trivet::cli::has_colours(STDOUT_FILENO);
  line.paint_errors = trivet::cli::has_colours(STDERR_FILENO);
  if (line.source.name == "-") read_standard_input(line.source);
  return trivet::cli::run(std::move(line));
}

int run_program(int argc, char** argv) {
  CommandLine line;
  CLI::App app("Vibration of bodies on real elastic elements");
  app.set_version_flag("-V,--version", "trivet " + trivet::engine::version());
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 done, 1 something could not be computed, 2 the input is wrong, 128 + n ended by signal n, 141 the "
      "output pipe was closed; with --strict also 3 and 4, see run --help.");
  FurtherWords words;
  add_commands(app, line, words);
  try {
    app.parse(argc, argv);
  } catch (const CLI::RequiredError& error) {
    if (!app.get_subcommands().empty() || argc < 2 || argv[1][0] == '-') return said_by_parser(app, error);
    refuse_command(app, argv[1]);
    return wrong_input;
  } catch (const CLI::ExtrasError& error) {
    const auto commands = app.get_subcommands();
    return !commands.empty() && refuse_options(*commands.front()) ? wrong_input : said_by_parser(app, error);
  } catch (const CLI::ParseError& error) {
    return said_by_parser(app, error);
  }
  if (app.got_subcommand("help")) return print_help(app, words.helped);
  return trivet::cli::exit_code(exit_code_of(app, line, words));
}

}  // namespace

int trivet::cli::main_program(int argc, char** argv) {
  trivet::engine::keep_freed_memory();
  trivet::cli::occupy_closed_streams();
  trivet::cli::end_cleanly_on_signals();
  // OpenBLAS, which is loaded for large models, would start threads that wait actively although only one is used.
  setenv("OPENBLAS_NUM_THREADS", "1", 0);
  try {
    return run_program(argc, argv);
  } catch (const std::exception& error) {
    trivet::cli::write_error("error: " + trivet::engine::failure_words(error) + "\n");
    return static_cast<int>(trivet::engine::Outcome::not_computed);
  }
}
