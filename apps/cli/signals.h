// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace trivet::cli {

/// From now on SIGINT (Ctrl-C), SIGTERM and SIGHUP end the program, whatever it is doing, and leave nothing
/// behind: child processes are ended, temporary folders and unfinished results removed. Only the milliseconds in which
/// a result folder is exchanged are waited for. The exit code is 128 + the signal's number, as shells report it. A
/// second signal does not wait for that. To be called first, before any thread exists. An ignored SIGHUP (nohup) stays
/// ignored.
void end_cleanly_on_signals();

}  // namespace trivet::cli
