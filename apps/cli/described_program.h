// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

/// What the command line accepts, as completion and the manual page need it.
namespace trivet::cli {

struct DescribedOption {
  std::string name;        ///< "--case"; of a word without an option: "PROJECT"
  std::string short_name;  ///< "-o"; empty: none
  std::string value;       ///< "FILE", "FROM,TO"; empty: a flag
  std::string about;
  std::vector<std::string> choices;  ///< values that are known beforehand
  bool is_repeatable = false;
};

struct DescribedCommand {
  std::string name, about, group;
  std::vector<DescribedOption> words;  ///< without an option, in their order
  std::vector<DescribedOption> options;
  std::vector<std::string> examples;
  std::string file_keys;  ///< of its table in the project file; empty: none
};

struct DescribedProgram {
  std::string about, version, footer;
  std::vector<DescribedOption> options;
  std::vector<DescribedCommand> commands;
};

/// A script for "bash", "zsh" or "fish" that completes commands, options, their values, and files; names of cases and
/// elements come from the project file on the line.
[[nodiscard]] std::string completion_script(const DescribedProgram& program, const std::string& shell);

/// The manual page of the whole program, for man (roff).
[[nodiscard]] std::string manual_page(const DescribedProgram& program);

}  // namespace trivet::cli
