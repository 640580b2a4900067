// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "cli/colours.h"
#include "cli/command_line.h"
#include "cli/console.h"
#include "cli/main_program.h"
#include "cli/signals.h"
#include "trivet/engine/program.h"

namespace {

using trivet::cli::CommandLine;
using trivet::cli::Form;
using trivet::engine::Command;
using trivet::engine::Key;
using trivet::engine::KeyKind;

constexpr int wrong_input = static_cast<int>(trivet::engine::Outcome::wrong_input);

std::string not_empty(const std::string& text) { return text.empty() ? "an empty text; omit the option" : ""; }

std::string at_least_one(const std::string& text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() && number >= 1
      ? ""
      : "\"" + text + "\": must be a whole number ≥ 1";
}

std::string is_svg(const std::string& path) {
  return std::filesystem::path(path).extension() == ".svg"
      ? ""
      : (path.empty() ? "\"\"" : path) + ": pictures are SVG; name a file that ends in .svg";
}

void add_check(const Key& key, CLI::Option& option) {
  if (key.kind == KeyKind::count) option.check(at_least_one);
  else if (key.kind == KeyKind::choice) option.check(CLI::IsMember(key.choices));
  else if (std::string(key.name) == "picture") option.check(is_svg);
  else option.check(not_empty);
}

std::string upper_case(std::string name) {
  for (char& letter : name) letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  return name;
}

void add_key(CLI::App& app, const Key& key, CommandLine& line) {
  const std::string name = key.name;
  if (key.kind == KeyKind::flag) {
    app.add_flag_callback("--" + name, [&line, name] { line.request.keys.emplace_back(name, true); }, key.about);
    return;
  }
  const auto take = [&line, name](const std::vector<std::string>& texts) {
    for (const std::string& text : texts) line.request.keys.emplace_back(name, text);
  };
  std::string spelling = key.positional ? upper_case(name) : "--" + name;
  if (*key.short_name != '\0') spelling = std::string("-") + key.short_name + "," + spelling;
  CLI::Option* option = app.add_option_function<std::vector<std::string>>(spelling, take, key.about);
  option->required(key.required)->type_size(1);
  if (key.repeatable) option->allow_extra_args(false);
  else option->expected(1);
  if (*key.by_default != '\0') option->default_str(key.by_default);
  add_check(key, *option);
  option->type_name(trivet::engine::value_name(key));  // in place of the name that the check brings
}

void add_forms(CLI::App& app, const Command& command, CommandLine& line) {
  const auto form = [&line](Form chosen) { return [&line, chosen] { line.form = chosen; }; };
  CLI::Option* json = command.json ? app.add_flag_callback("--json", form(Form::json), "JSON, SI") : nullptr;
  CLI::Option* csv = command.csv ? app.add_flag_callback("--csv", form(Form::csv), "CSV, SI") : nullptr;
  if (json && csv) csv->excludes(json);
  const bool has_full =
      std::ranges::any_of(command.keys, [](const Key& key) { return std::string_view(key.name) == "full"; });
  if (!has_full && command.json)
    app.add_flag("--full", line.full, "print every row and every column of tables, also on a narrow screen");
  if (command.strict)
    app.add_flag("--strict", line.strict,
                 "exit code 3 if a limit or a rule is violated, 4 if there are only warnings; the result is written in "
                 "any case");
}

/// Below the options: examples, and the keys of the command's table in the project file.
std::string footer_of(const Command& command) {
  std::string text = "Examples:\n";
  for (const std::string& example : command.examples) text += "  " + example + "\n";
  const std::string keys = trivet::engine::file_keys(command);
  return keys.empty() ? text : text + "\n" + keys;
}

void add_command(CLI::App& app, const Command& command, CommandLine& line) {
  CLI::App* added = app.add_subcommand(command.name, command.about)->group(heading(command.group));
  added->add_option("PROJECT", line.source.name, "project file (TOML); - for standard input")
      ->required()
      ->type_name("FILE");
  added
      ->add_option("--set", line.settings,
                   "change a number: elements.front.scale=1.5 (repeatable); overrides the file and its cases")
      ->allow_extra_args(false)
      ->type_name("PATH=VALUE");
  CLI::Option* one_case =
      added->add_option("--case", line.request.case_name, "a case of the file instead of the base model")
          ->check(not_empty)
          ->type_name("NAME");
  if (!command.of_one_case) one_case->group("");  // refused with the reason
  for (const Key& key : command.keys) add_key(*added, key, line);
  for (const Key& key : command.keys)
    if (*key.excludes != '\0')
      added->get_option(std::string("--") + key.name)->excludes(added->get_option(std::string("--") + key.excludes));
  add_forms(*added, command, line);
  added->footer([&command] { return footer_of(command); });
}

/// Reports a word that is not a command.
void refuse_command(CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  const std::string guess = trivet::foundation::nearest_name(word, names);
  trivet::cli::write_error("error: " + trivet::engine::quoted(word) + " is not a command; " +
                           (guess.empty() ? "trivet --help lists them" : "did you mean \"" + guess + "\"?") + "\n");
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
  source = {"standard input", text.str(), "."};
}

int exit_code_of(const CLI::App& app, CommandLine& line, const std::string& starter) {
  const std::string name = app.get_subcommands().front()->get_name();
  if (name == "new") return write_starter(starter);
  if (name == "schema") return trivet::cli::write_output(trivet::engine::project_schema()), 0;
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
  for (const Command& command : trivet::engine::commands())
    if (!command.for_programs) add_command(app, command, line);
  const std::string files = heading(trivet::engine::Group::data);
  std::string starter, helped;
  app.add_subcommand("new", "a commented starter file")
      ->group(files)
      ->add_option("FILE", starter, "file to write; without it the text is printed")
      ->type_name("");
  app.add_subcommand("help", "help on a command")
      ->group(files)
      ->add_option("COMMAND", helped, "its name")
      ->type_name("");
  app.add_subcommand("schema", "the JSON Schema of the project file")->group(files);
  try {
    app.parse(argc, argv);
  } catch (const CLI::RequiredError& error) {
    if (!app.get_subcommands().empty() || argc < 2 || argv[1][0] == '-') return said_by_parser(app, error);
    refuse_command(app, argv[1]);
    return wrong_input;
  } catch (const CLI::ParseError& error) {
    return said_by_parser(app, error);
  }
  if (app.got_subcommand("help")) return print_help(app, helped);
  return trivet::cli::exit_code(exit_code_of(app, line, starter));
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
