// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/foundation/interruption.h"

namespace trivet::foundation {

/// While it exists, steps of this thread that are called without a Progress report to this one: those of opening a
/// project, of drawing a machine, and of the roots and the modes of peaks of curves, deep in which a question may end.
/// May be nested.
class ThreadProgress {
 public:
  /// @param progress  must outlive the object
  explicit ThreadProgress(const Progress& progress);
  ~ThreadProgress();
  ThreadProgress(const ThreadProgress&) = delete;
  ThreadProgress& operator=(const ThreadProgress&) = delete;

 private:
  const Progress* before_;
};

/// That of the innermost ThreadProgress of this thread; otherwise an empty one.
[[nodiscard]] const Progress& thread_progress();

}  // namespace trivet::foundation
