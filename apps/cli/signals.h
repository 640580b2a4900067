// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace trivet::cli {

/// From now on SIGINT (Ctrl-C), SIGTERM and SIGHUP end the program at any time and clean up: child processes are ended,
/// temporary folders and unfinished results removed. Only the exchange of a result folder (milliseconds) is completed
/// first. The exit code is 128 + the number of the signal, as shells report it. A second signal ends the program at
/// once. Call this first, before any thread exists. An ignored SIGHUP (nohup) stays ignored.
void end_cleanly_on_signals();

/// While it exists, the first SIGINT only asks a search to end with the best design so far; a second one ends the
/// program as above. At most one at a time.
class InterruptibleSearch {
 public:
  InterruptibleSearch();
  ~InterruptibleSearch();
  InterruptibleSearch(const InterruptibleSearch&) = delete;
  InterruptibleSearch& operator=(const InterruptibleSearch&) = delete;

  /// On any thread.
  [[nodiscard]] bool is_to_end() const;
};

}  // namespace trivet::cli
