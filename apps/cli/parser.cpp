// SPDX-License-Identifier: BSD-3-Clause
#include "cli/parser.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "trivet/engine/program.h"

namespace trivet::cli {
namespace {

using engine::Command;
using engine::Key;
using engine::KeyKind;

constexpr const char* about_help = "Help and shell";

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
  option->type_name(engine::value_name(key));  // in place of the name that the check brings
}

void add_forms(CLI::App& app, const Command& command, CommandLine& line) {
  const auto form = [&line](Form chosen) { return [&line, chosen] { line.form = chosen; }; };
  CLI::Option* json = command.json ? app.add_flag_callback("--json", form(Form::json), "JSON, SI") : nullptr;
  CLI::Option* csv = command.csv ? app.add_flag_callback("--csv", form(Form::csv), "CSV, SI") : nullptr;
  if (json && csv) csv->excludes(json);
  const bool has_output =
      std::ranges::any_of(command.keys, [](const Key& key) { return std::string_view(key.name) == "output"; });
  if (!has_output) {
    CLI::Option* output =
        app.add_option("-o,--output", line.output,
                       "write the result to this file; its ending chooses the form: .json, .csv, .html or .txt")
            ->check(not_empty)
            ->type_name("FILE");
    for (CLI::Option* other : {json, csv})
      if (other) output->excludes(other);
  }
  if (!has_output || command.json || command.name == "run")
    app.add_flag("--open", line.is_shown, "show the page that is written in a browser: BROWSER, or xdg-open");
  const bool has_tables = command.json || command.name == "run";
  if (has_tables)
    app.add_flag("--full", line.full,
                 command.json ? "print every row and every column of tables, also on a narrow screen"
                              : "print the tables of all results, too");
  if (command.strict)
    app.add_flag(
        "--strict", line.strict,
        "exit code 3 if a limit, a rule or a wanted yield is violated, 4 if there are only warnings; the result "
        "is written in any case");
}

std::string examples_text(const std::vector<std::string>& examples) {
  std::string text = "Examples:\n";
  for (const std::string& example : examples) text += "  " + example + "\n";
  return text;
}

/// Below the options: examples, and the keys of the command's table in the project file.
std::string footer_of(const Command& command) {
  const std::string text = examples_text(command.examples), keys = engine::file_keys(command);
  return keys.empty() ? text : text + "\n" + keys;
}

void add_command(CLI::App& app, const Command& command, CommandLine& line) {
  CLI::App* added = app.add_subcommand(command.name, command.about)->group(heading(command.group));
  added->add_option("PROJECT", line.source.name, "project file (TOML); - for standard input")
      ->required(!engine::can_be_alone(command))
      ->type_name("FILE");
  added
      ->add_option(
          "--set", line.settings,
          "change a number: elements.front.scale=1.5 (repeatable), with a unit: excitations.rotor.service_speed='980 "
          "rpm'; without one it is in SI, a frequency in rad/s; overrides the file and its cases")
      ->allow_extra_args(false)
      ->type_name("PATH=VALUE");
  const std::string about_case = command.of_one_case ? "a case of the file instead of the base model"
      : !command.case_alone.empty()                  ? command.case_alone
                                                     : "refused: " + command.without_case;
  CLI::Option* one_case =
      added->add_option("--case", line.request.case_name, about_case)->check(not_empty)->type_name("NAME");
  if (!command.of_one_case && command.case_alone.empty() && command.without_case.empty()) one_case->group("");
  for (const Key& key : command.keys) add_key(*added, key, line);
  for (const Key& key : command.keys)
    if (*key.excludes != '\0')
      added->get_option(std::string("--") + key.name)->excludes(added->get_option(std::string("--") + key.excludes));
  add_forms(*added, command, line);
  added->footer([&command] { return footer_of(command); });
}

void add_serve(CLI::App& app, CommandLine& line, FurtherWords& words) {
  app.add_option("PROJECT", line.source.name, "project file (TOML); without it the page offers examples")
      ->type_name("FILE");
  app.add_option("--port", words.port, "port of 127.0.0.1; without it that of the last start, or a free one")
      ->check(CLI::Range(1, 65535))
      ->type_name("N");
  app.add_flag("--no-browser", words.no_browser, "print the address instead of opening it: BROWSER, or xdg-open");
  app.add_flag("--read-only", words.read_only, "the page cannot save");
}

/// Commands that are not in the engine's table.
void add_further_commands(CLI::App& app, CommandLine& line, FurtherWords& words) {
  const std::string files = engine::heading(engine::Group::data);
  const auto add = [&app](const char* name, const char* about, const std::string& group,
                          const std::vector<std::string>& examples) {
    CLI::App* added = app.add_subcommand(name, about)->group(group);
    added->footer(examples_text(examples));
    return added;
  };
  add("new", "a commented starter file", files, {"trivet new first.toml", "trivet new | trivet check -"})
      ->add_option("FILE", words.starter, "file to write; without it the text is printed")
      ->type_name("FILE");
  add_serve(*add("serve", "the page of a project in the browser of this machine: change numbers and see what moves",
                 files, {"trivet serve machine.toml", "trivet serve machine.toml --read-only --no-browser"}),
            line, words);
  add("schema", "the JSON Schema of the project file", files, {"trivet schema", "trivet schema > trivet.schema.json"});
  add("help", "help on a command", about_help, {"trivet help modes", "trivet help export"})
      ->add_option("COMMAND", words.helped, "its name")
      ->type_name("COMMAND");
  add("completion", "a script that completes commands, options, files and names in a shell", about_help,
      {"source <(trivet completion bash)", "trivet completion zsh > _trivet"})
      ->add_option("SHELL", words.shell, "the shell")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}))
      ->type_name("bash|zsh|fish");
  add("man", "the manual page (roff)", about_help, {"trivet man > trivet.1", "trivet man | man -l -"});
  CLI::App* names = app.add_subcommand("names", "names in a project, for completion")->group("");  // not in the help
  names->add_option("PROJECT", line.source.name, "project file (TOML)")->required();
  names->add_option("KIND", words.kind, "of names")
      ->required()
      ->check(CLI::IsMember({"cases", "elements", "results", "paths"}));
}

DescribedOption described_option(const CLI::Option& option, const Command* command) {
  DescribedOption described;
  const std::vector<std::string>&long_names = option.get_lnames(), &short_names = option.get_snames();
  const std::string key = long_names.empty() ? "" : long_names.front();
  described.name = long_names.empty() ? option.get_name(true, false) : "--" + key;
  if (!short_names.empty()) described.short_name = "-" + short_names.front();
  const std::string value = option.get_type_name();  // "bash|zsh:{bash,zsh}" with a check
  if (option.get_items_expected_max() > 0) described.value = value.substr(0, value.find(':'));
  described.about = option.get_description();
  described.is_repeatable = !option.get_allow_extra_args() && key == "set";
  if (command)
    for (const Key& one : command->keys)
      if (one.name == key) {
        described.choices = one.choices;
        described.is_repeatable = one.repeatable;
      }
  if (described.choices.empty() && described.value.find('|') != std::string::npos)
    described.choices = CLI::detail::split(described.value, '|');
  return described;
}

DescribedCommand described_command(const CLI::App& app) {
  DescribedCommand described{.name = app.get_name(), .about = app.get_description(), .group = app.get_group()};
  const Command* command = engine::find_command(described.name);
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;
    auto& list = option->get_lnames().empty() ? described.words : described.options;
    list.push_back(described_option(*option, command));
  }
  if (command) {
    described.examples = command->examples;
    described.file_keys = engine::file_keys(*command);
  }
  return described;
}

}  // namespace

void add_commands(CLI::App& app, CommandLine& line, FurtherWords& words) {
  for (const Command& command : engine::commands())
    if (!command.for_programs) add_command(app, command, line);
  add_further_commands(app, line, words);
}

DescribedProgram described_program(const CLI::App& app) {
  DescribedProgram program{.about = app.get_description(), .version = engine::version(), .footer = app.get_footer()};
  for (const CLI::Option* option : app.get_options()) program.options.push_back(described_option(*option, nullptr));
  for (const CLI::App* command : app.get_subcommands([](const CLI::App* one) { return !one->get_group().empty(); }))
    program.commands.push_back(described_command(*command));
  return program;
}

}  // namespace trivet::cli
