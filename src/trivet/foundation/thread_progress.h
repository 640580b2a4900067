// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/foundation/interruption.h"

namespace trivet::foundation {

/// While it exists, steps of this thread that are called without a Progress report to this one: those of opening a
/// project and of drawing a machine, whose readers of keys and drawings have no business with it. May be nested.
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
