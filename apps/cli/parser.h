// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "cli/command_line.h"
#include "cli/described_program.h"

namespace CLI {
class App;
}

namespace trivet::cli {

/// Words of the commands that ask nothing of a project.
struct FurtherWords {
  std::string starter;      ///< file of `new`
  std::string helped;       ///< command of `help`
  std::string shell;        ///< of `completion`
  std::string kind;         ///< of `names`: "cases", "elements"
  std::uint16_t port = 0;   ///< of `serve`; 0: any free one
  bool no_browser = false;  ///< `serve` prints its address instead
  bool read_only = false;   ///< of `serve`
};

/// The commands of the engine's table, and those that ask nothing of a project. What is parsed goes to the two, which
/// outlive the parser.
void add_commands(CLI::App& app, CommandLine& line, FurtherWords& words);

/// What the parser accepts; its hidden commands and options are left out.
[[nodiscard]] DescribedProgram described_program(const CLI::App& app);

}  // namespace trivet::cli
