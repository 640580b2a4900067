// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/foundation/temporary_folder.h"

namespace trivet::foundation {

/// How a guarded program ended.
struct ProgramEnd {
  int start_error = 0;  ///< errno if it could not be started
  int status = 0;       ///< as returned by waitpid
};

/// A program in a separate process group, under a guard: a small intermediate process that kills the whole group when
/// the program has ended, when our process ends (even by SIGKILL), or when this object is destroyed. If the guard
/// itself is killed, the kernel kills the program.
class GuardedProgram {
 public:
  /// @param path, arguments, environment  as for execve  @param folder  working folder, may be null
  /// @param output  file descriptor of standard output and standard error
  /// @throws std::system_error if no process can be created
  GuardedProgram(const char* path, char* const* arguments, char* const* environment, const char* folder, int output);
  ~GuardedProgram();
  GuardedProgram(const GuardedProgram&) = delete;
  GuardedProgram& operator=(const GuardedProgram&) = delete;

  /// Has the program ended? If so, `end` is set.
  [[nodiscard]] bool has_ended(ProgramEnd& end);

 private:
  int report_ = -1;  ///< file descriptor on which the guard reports the end
  std::unique_ptr<RegisteredProgram> registered_;
};

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
