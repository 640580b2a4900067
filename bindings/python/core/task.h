// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nanobind/nanobind.h>

#include <functional>
#include <string>

#include "trivet/engine/program.h"

/// Long computations that leave Python running.
namespace trivet::python {

struct TaskOptions {
  int threads = 0;                               ///< 0: as many as the machine has
  nanobind::object progress = nanobind::none();  ///< called with (done, total, task), at the end with done == total
  std::string name = "";                         ///< the task, until the work names one
};

/// Does the work on another thread, without Python's lock. Meanwhile this thread shows the progress and looks for
/// signals: Ctrl-C ends the call at once, and the work at its next report. `work` must own all that it uses, because it
/// may outlive the call.
void run_task(const TaskOptions& options, std::function<void(const foundation::Progress&)> work);

/// Waits for interrupted work. @returns whether none is left
[[nodiscard]] bool wait_for_interrupted_work(double seconds);

}  // namespace trivet::python
