// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cctype>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "cli/described_program.h"

namespace trivet::cli {
namespace {

/// A text in roff: a backslash and a hyphen stand for themselves, and no line is a request.
std::string roff_text(std::string_view text) {
  std::string escaped;
  bool at_line = true;
  for (const char c : text) {
    if (at_line && (c == '.' || c == '\'')) escaped += "\\&";
    if (c == '\\') escaped += "\\e";
    else if (c == '-') escaped += "\\-";
    else escaped += c;
    at_line = c == '\n';
  }
  return escaped;
}

/// Each line of a text as it stands.
std::string roff_lines(const std::string& text) {
  std::string lines = ".nf\n";
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines += (line.empty() ? ".sp" : roff_text(line)) + "\n";
  return lines + ".fi\n";
}

/// A description; its further lines, as those of a list of formats, stay lines.
std::string roff_about(const std::string& text) {
  std::string lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin == std::string::npos) continue;
    lines += (lines.empty() ? "" : ".br\n") + roff_text(line.substr(begin)) + "\n";
  }
  return lines.empty() ? "\\&\n" : lines;
}

std::string option_entry(const DescribedOption& option) {
  const std::string spelling = (option.short_name.empty() ? "" : option.short_name + ", ") + option.name;
  std::string entry = ".TP\n\\fB" + roff_text(spelling) + "\\fR";
  if (!option.value.empty() && option.value != option.name) entry += " \\fI" + roff_text(option.value) + "\\fR";
  return entry + "\n" + roff_about(option.about);
}

std::string synopsis(const DescribedCommand& command) {
  std::string text = "\\fBtrivet " + roff_text(command.name) + "\\fR";
  for (const DescribedOption& word : command.words) text += " \\fI" + roff_text(word.name) + "\\fR";
  return text + (command.options.empty() ? "" : " [\\fIOPTIONS\\fR]");
}

std::string command_part(const DescribedCommand& command) {
  std::string text =
      ".SS " + roff_text(command.name) + "\n" + synopsis(command) + "\n.PP\n" + roff_about(command.about);
  for (const DescribedOption& word : command.words) text += option_entry(word);
  for (const DescribedOption& option : command.options)
    if (option.name != "--help") text += option_entry(option);
  if (!command.file_keys.empty()) text += ".PP\n" + roff_lines(command.file_keys);
  if (command.examples.empty()) return text;
  text += ".PP\n";
  std::string lines = "Examples:\n";
  for (const std::string& example : command.examples) lines += "  " + example + "\n";
  return text + roff_lines(lines);
}

std::string in_capitals(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

constexpr const char* surroundings = R"(.SH ENVIRONMENT
.TP
.B NO_COLOR
if it is set and not empty, nothing is in colour.
.TP
.B COLUMNS
width of a line, in place of that of the terminal.
.TP
.B BROWSER
the program that shows a page with \-\-open.
.TP
.B TRIVET_CACHE
folder in which meshed mounts are kept.
)";

}  // namespace

std::string manual_page(const DescribedProgram& program) {
  std::string page = fmt::format(".TH TRIVET 1 \"\" \"trivet {}\" \"User Commands\"\n", roff_text(program.version)) +
      ".SH NAME\ntrivet \\- " + roff_text(program.about) +
      "\n.SH SYNOPSIS\n\\fBtrivet\\fR \\fICOMMAND\\fR "
      "\\fIPROJECT\\fR [\\fIOPTIONS\\fR]\n.SH OPTIONS\n";
  for (const DescribedOption& option : program.options) page += option_entry(option);
  std::string group;
  for (const DescribedCommand& command : program.commands) {
    if (command.group != group) page += ".SH \"" + roff_text(in_capitals(command.group)) + "\"\n";
    group = command.group;
    page += command_part(command);
  }
  return page + ".SH EXIT STATUS\n" + roff_about(program.footer) + surroundings;
}

}  // namespace trivet::cli
