// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

#include "trivet/foundation/interruption.h"

namespace trivet::foundation {

/// Number of threads: `wanted`; if that is 0, the limit of this thread (ThreadLimit), or the number of the machine.
[[nodiscard]] int thread_count(int wanted);

/// While it exists, work that this thread starts takes at most so many threads. May be nested.
class ThreadLimit {
 public:
  /// @param most  0: as many as the machine has
  explicit ThreadLimit(int most);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  int before_;
};

struct ParallelOptions {
  std::size_t size = 1;        ///< of a piece; independent of the number of threads, so that results are too
  int threads = 0;             ///< 0: number of threads of the machine
  Progress progress = {};      ///< called only on the calling thread
  std::string_view task = "";  ///< name of the task in progress reports
};

/// Calls work(first, last) for all pieces [first, last) of [0, count), on several threads, each piece once, in any
/// order. If each call writes only the results of its piece, they are identical for 1 or 16 threads. The first
/// exception stops the other threads and is rethrown.
void parallel_for(std::size_t count, const ParallelOptions& options,
                  const std::function<void(std::size_t first, std::size_t last)>& work);

}  // namespace trivet::foundation
