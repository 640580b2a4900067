// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace trivet::cli {

/// From now on SIGINT (Ctrl-C), SIGTERM, SIGHUP and SIGUSR1 (Slurm before the end of its time) end the program at any
/// time and clean up: child processes are ended, temporary folders and unfinished results removed. Only the exchange of
/// a result folder (milliseconds) is completed first. The exit code is 128 + the number of the signal, as shells report
/// it. A second signal ends the program at once. Call this first, before any thread exists. An ignored SIGHUP (nohup)
/// stays ignored.
void end_cleanly_on_signals();

/// While it exists, the first signal only asks a computation to end with what it has; a second one ends the program as
/// above. At most one at a time.
class Interruptible {
 public:
  enum class Kind {
    search,  ///< SIGINT asks it to end, and waits for as long as it takes
    study    ///< every signal asks it to end, within two seconds: what it has finished is in its folder then
  };
  explicit Interruptible(Kind kind);
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

  /// On any thread.
  [[nodiscard]] bool is_to_end() const;
  /// 128 + the signal that asked for the end; 0 if there was none.
  [[nodiscard]] int exit_code() const;
};

}  // namespace trivet::cli
