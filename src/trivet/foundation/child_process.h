// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "trivet/foundation/interruption.h"

namespace trivet::foundation {

/// Executable of this name in PATH, or nullopt.
[[nodiscard]] std::optional<std::filesystem::path> program_on_path(const std::string& name);

/// Program to run. No shell is involved: every argument reaches the program unchanged.
struct Command {
  std::filesystem::path program;
  std::vector<std::string> arguments = {};
  std::filesystem::path folder = {};          ///< working folder of the program; empty: that of this process
  std::vector<std::string> environment = {};  ///< "NAME=value", added to our environment or replacing an entry of it
  double time_limit = 3600;                   ///< [s] > 0; after it the program is killed
  std::string task = {};                      ///< name of the task in progress reports
};

struct CommandOutcome {
  enum class End { exited, signalled, time_limit, endless_output } end = End::exited;
  int code = 0;        ///< exit code, or number of the signal
  std::string output;  ///< standard output and error in order of arrival; of a long output the last 256 to 512 KiB
  [[nodiscard]] bool succeeded() const { return end == End::exited && code == 0; }
};

/// Runs a program to its end, without standard input. Progress is reported ten times a second, always as fraction 0
/// because the true progress is unknown. If the callback throws, the time limit passes or the program prints more than
/// 100 MB, the program and all that it started are killed first; also when this process ends, even by SIGKILL.
/// @throws std::system_error if the program cannot be started
[[nodiscard]] CommandOutcome run(const Command& command, const Progress& progress = {});

/// Reason why a failed program ended: "exit code 1", "signal 11", "ended after 60 s".
[[nodiscard]] std::string how_it_ended(const CommandOutcome& outcome, const Command& command);

}  // namespace trivet::foundation
