// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "trivet/foundation/interruption.h"

namespace trivet::foundation {

/// The file that PATH gives for a program's name, or nothing.
[[nodiscard]] std::optional<std::filesystem::path> program_on_path(const std::string& name);

/// What to run. No shell reads any of it: every argument reaches the program as it stands.
struct Command {
  std::filesystem::path program;
  std::vector<std::string> arguments = {};
  std::filesystem::path folder = {};          ///< working folder of the program; empty: ours
  std::vector<std::string> environment = {};  ///< "NAME=value", added to ours or in place of it
  double time_limit = 3600;                   ///< [s] > 0; then the program is ended
  std::string task = {};                      ///< what progress reports while it runs
};

struct CommandOutcome {
  enum class End { exited, signalled, time_limit, endless_output } end = End::exited;
  int code = 0;        ///< exit code, or number of the signal
  std::string output;  ///< standard output and standard error as they came, of a long output its end, 256 to 512 KiB
  [[nodiscard]] bool succeeded() const { return end == End::exited && code == 0; }
};

/// Runs a program to its end, without standard input. Progress is reported ten times a second, as the fraction 0
/// because a program does not say how far it is; if it throws, if the time is over, or if the program prints more than
/// 100 MB, the program and all that it started are ended first. They also end when this process ends, by SIGKILL too.
/// @throws std::system_error if the program cannot be started
[[nodiscard]] CommandOutcome run(const Command& command, const Progress& progress = {});

/// "exit code 1", "signal 11", "ended after 60 s": how a program that failed came to its end.
[[nodiscard]] std::string how_it_ended(const CommandOutcome& outcome, const Command& command);

}  // namespace trivet::foundation
