// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "trivet/foundation/leftovers.h"

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

}  // namespace trivet::foundation
