// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "cli/described_program.h"

namespace trivet::cli {
namespace {

/// In single quotes of a shell.
std::string quoted_for_shell(std::string_view text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// What completes a value: known words, names in the project, files, or nothing.
enum class Source { nothing, choices, cases, elements, results, paths, files };
Source source_of(const DescribedOption& option) {
  if (!option.choices.empty()) return Source::choices;
  if (option.name == "--case") return Source::cases;
  if (option.name == "NAME") return Source::elements;
  if (option.name == "--of") return Source::results;
  if (option.name == "--set") return Source::paths;
  return option.value.starts_with("FILE") ? Source::files : Source::nothing;
}

std::vector<std::string> spellings(const DescribedOption& option) {
  return option.short_name.empty() ? std::vector{option.name} : std::vector{option.short_name, option.name};
}

// ---- bash

std::string bash_value(const DescribedOption& option) {
  switch (source_of(option)) {
    case Source::choices:
      return fmt::format("_trivet_words {}", quoted_for_shell(fmt::format("{}", fmt::join(option.choices, "\n"))));
    case Source::cases:
      return "_trivet_words \"$(_trivet_names cases)\"";
    case Source::elements:
      return "_trivet_words \"$(_trivet_names elements)\"";
    case Source::results:
      return "_trivet_words \"$(_trivet_names results)\"";
    case Source::paths:
      return "compopt -o nospace 2>/dev/null; _trivet_words \"$(_trivet_names paths)\"";
    case Source::files:
      return "_trivet_files";
    case Source::nothing:
      return "return";
  }
  return "return";
}

std::string bash_command(const DescribedCommand& command) {
  std::string options, values, words;
  for (const DescribedOption& option : command.options) {
    for (const std::string& spelling : spellings(option)) options += (options.empty() ? "" : "\n") + spelling;
    if (!option.value.empty())
      values += fmt::format("        {}) {}; return ;;\n", fmt::join(spellings(option), "|"), bash_value(option));
  }
  for (std::size_t i = 0; i < command.words.size(); ++i)
    words += fmt::format("        {}) {} ;;\n", i, bash_value(command.words[i]));
  return fmt::format(
      "    {})\n      case $previous in\n{}        --) ;;\n      esac\n"
      "      if [[ $current == -* ]]; then _trivet_words {}; return; fi\n"
      "      case $place in\n{}        *) ;;\n      esac ;;\n",
      command.name, values, quoted_for_shell(options), words);
}

/// Options that take a value, of all commands: the word after one is none of the words without an option.
std::string options_with_values(const DescribedProgram& program) {
  std::vector<std::string> all;
  for (const DescribedCommand& command : program.commands)
    for (const DescribedOption& option : command.options)
      if (!option.value.empty())
        for (const std::string& spelling : spellings(option)) all.push_back(spelling);
  std::ranges::sort(all);
  const auto repeated = std::ranges::unique(all);
  all.erase(repeated.begin(), repeated.end());
  return fmt::format("{}", fmt::join(all, "|"));
}

constexpr const char* bash_begin = R"(# bash completion of trivet: source it, or put it into the folder of completions.
_trivet_words() {
  local typed=${current#[\"\']} word quote=
  [[ $current == [\"\']* ]] && quote=${current:0:1}
  typed=${typed//\\/}
  while IFS= read -r word; do
    [[ -n $word && $word == "$typed"* ]] || continue
    [[ -n $quote ]] || printf -v word %q "$word"
    COMPREPLY+=("$word")
  done <<<"$1"
}
_trivet_files() {
  compopt -o filenames 2>/dev/null
  local file
  while IFS= read -r file; do COMPREPLY+=("$file"); done < <(compgen -f -- "$current")
}
_trivet_names() {
  local file=$project
  [[ -z $file || $file == *[\`\$]* ]] && return  # nothing of the line is run
  file=${file#[\"\']} file=${file%[\"\']}
  file=${file//\\/}
  [[ $file == "~/"* ]] && file=$HOME/${file:2}
  trivet names "$file" "$1" 2>/dev/null
}
_trivet() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} place=0 project= i
  COMPREPLY=()
  for ((i = 2; i < COMP_CWORD; i++)); do
    case ${COMP_WORDS[i]} in
      @VALUES@) ((i++)) ;;
      -?* | [\<\>\|\&=]*) ;;
      *)
        ((place == 0)) && project=${COMP_WORDS[i]}
        ((place++))
        ;;
    esac
  done
  if ((COMP_CWORD == 1)); then
    _trivet_words @COMMANDS@
    return
  fi
  case ${COMP_WORDS[1]} in
)";

std::string replaced(std::string text, std::string_view mark, std::string_view by) {
  return text.replace(text.find(mark), mark.size(), by);
}

std::string bash_script(const DescribedProgram& program) {
  std::string names, commands;
  for (const DescribedCommand& command : program.commands) {
    names += (names.empty() ? "" : "\n") + command.name;
    commands += bash_command(command);
  }
  for (const DescribedOption& option : program.options)
    for (const std::string& spelling : spellings(option)) names += "\n" + spelling;
  return replaced(replaced(bash_begin, "@VALUES@", options_with_values(program)), "@COMMANDS@",
                  quoted_for_shell(names)) +
      commands + "  esac\n}\ncomplete -F _trivet trivet\n";
}

// ---- zsh

/// In a specification of _arguments: brackets and colons end its parts.
std::string zsh_text(const std::string& text) {
  std::string escaped;
  for (const char c : first_line(text)) escaped += (c == '[' || c == ']' || c == ':' ? "\\" : "") + std::string(1, c);
  return escaped;
}

std::string zsh_value(const DescribedOption& option) {
  switch (source_of(option)) {
    case Source::choices:
      return fmt::format("({})", fmt::join(option.choices, " "));
    case Source::cases:
      return "->cases";
    case Source::elements:
      return "->elements";
    case Source::results:
      return "->results";
    case Source::paths:
      return "->paths";
    case Source::files:
      return "_files";
    case Source::nothing:
      break;
  }
  return " ";
}

std::string zsh_option(const DescribedOption& option) {
  const std::string value = option.value.empty() ? "" : ":" + zsh_text(option.value) + ":" + zsh_value(option);
  const std::string about = quoted_for_shell("[" + zsh_text(option.about) + "]" + value);
  const std::string excludes =
      option.is_repeatable ? "'*'" : quoted_for_shell(fmt::format("({})", fmt::join(spellings(option), " ")));
  if (option.short_name.empty()) return fmt::format("        {}{}{}", excludes, option.name, about);
  return fmt::format("        {}{{{},{}}}{}", excludes, option.short_name, option.name, about);
}

std::string zsh_command(const DescribedCommand& command) {
  std::string arguments;
  for (const DescribedOption& option : command.options) arguments += " \\\n" + zsh_option(option);
  for (std::size_t i = 0; i < command.words.size(); ++i)
    arguments += " \\\n        " +
        quoted_for_shell(fmt::format("{}:{}:{}", i + 1, zsh_text(command.words[i].name), zsh_value(command.words[i])));
  return fmt::format("    {})\n      _arguments{} ;;\n", command.name, arguments.empty() ? " ':'" : arguments);
}

std::string zsh_script(const DescribedProgram& program) {
  std::string script =
      "#compdef trivet\n# zsh completion of trivet: a file _trivet in a folder of $fpath.\n_trivet() {\n"
      "  local -a commands found\n  local state\n  commands=(\n";
  for (const DescribedCommand& command : program.commands)
    script += "    " + quoted_for_shell(command.name + ":" + zsh_text(command.about)) + "\n";
  script +=
      "  )\n  if ((CURRENT == 2)); then\n    _describe command commands\n    return\n  fi\n"
      "  local project=${(Q)words[3]}\n  shift words\n  ((CURRENT--))\n  case $words[1] in\n";
  for (const DescribedCommand& command : program.commands) script += zsh_command(command);
  return script +
      "  esac\n  case $state in\n    cases|elements|results|paths)\n"
      "      found=(\"${(@f)$(trivet names $project $state 2>/dev/null)}\")\n"
      "      if [[ $state == paths ]]; then compadd -S '' -- $found; else compadd -- $found; fi ;;\n  esac\n}\n_trivet "
      "\"$@\"\n";
}

// ---- fish

std::string fish_option(const DescribedCommand& command, const DescribedOption& option) {
  std::string line =
      fmt::format("complete -c trivet -n '__fish_seen_subcommand_from {}' -l {}", command.name, option.name.substr(2));
  if (!option.short_name.empty()) line += " -s " + option.short_name.substr(1);
  const Source source = source_of(option);
  if (!option.value.empty()) line += source == Source::files ? " -r" : " -x";
  if (source == Source::choices) line += " -a " + quoted_for_shell(fmt::format("{}", fmt::join(option.choices, " ")));
  if (source == Source::cases) line += " -a '(__trivet_names cases)'";
  if (source == Source::results) line += " -a '(__trivet_names results)'";
  if (source == Source::paths) line += " -a '(__trivet_names paths)'";
  return line + " -d " + quoted_for_shell(first_line(option.about)) + "\n";
}

std::string fish_script(const DescribedProgram& program) {
  std::string script =
      "# fish completion of trivet: a file trivet.fish in ~/.config/fish/completions.\n"
      "function __trivet_names\n  set -l words (commandline -opc)\n"
      "  test (count $words) -ge 3; and trivet names $words[3] $argv[1] 2>/dev/null\nend\n"
      "complete -c trivet -n __fish_use_subcommand -f\n";
  for (const DescribedCommand& command : program.commands) {
    script += fmt::format("complete -c trivet -n __fish_use_subcommand -a {} -d {}\n", command.name,
                          quoted_for_shell(first_line(command.about)));
    for (const DescribedOption& option : command.options) script += fish_option(command, option);
    for (const DescribedOption& word : command.words) {
      const std::string condition = fmt::format("complete -c trivet -n '__fish_seen_subcommand_from {}'", command.name);
      if (source_of(word) == Source::choices)
        script +=
            fmt::format("{} -f -a {}\n", condition, quoted_for_shell(fmt::format("{}", fmt::join(word.choices, " "))));
      if (source_of(word) == Source::elements) script += condition + " -a '(__trivet_names elements)'\n";
    }
  }
  return script;
}

}  // namespace

std::string completion_script(const DescribedProgram& program, const std::string& shell) {
  return shell == "bash" ? bash_script(program) : shell == "zsh" ? zsh_script(program) : fish_script(program);
}

}  // namespace trivet::cli
