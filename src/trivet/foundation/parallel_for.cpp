// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/parallel_for.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "trivet/foundation/index.h"

namespace trivet::foundation {

namespace {

thread_local int thread_limit = 0;  // 0: none

}  // namespace

int thread_count(int wanted) {
  if (wanted > 0) return wanted;
  return thread_limit > 0 ? thread_limit : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

ThreadLimit::ThreadLimit(int most) : before_(thread_limit) { thread_limit = most; }
ThreadLimit::~ThreadLimit() { thread_limit = before_; }

void parallel_for(std::size_t count, const ParallelOptions& options,
                  const std::function<void(std::size_t, std::size_t)>& work) {
  const std::size_t size = std::max<std::size_t>(1, options.size), pieces = (count + size - 1) / size;
  std::atomic<std::size_t> next = 0, done = 0;
  std::exception_ptr failure;
  std::size_t failed = pieces;
  std::mutex failing;
  const auto work_through = [&](bool reports) {
    std::size_t piece = 0;
    try {
      for (piece = next++; piece < pieces; piece = next++) {
        work(piece * size, std::min(count, (piece + 1) * size));
        ++done;
        if (reports)
          report_progress(options.progress, options.task,
                          static_cast<double>(done.load()) / static_cast<double>(pieces));
      }
    } catch (...) {
      next = pieces;
      const std::lock_guard lock(failing);
      if (!failure || piece < failed) {
        failure = std::current_exception();
        failed = piece;
      }
    }
  };
  {
    const auto workers = std::min<std::size_t>(to_size(thread_count(options.threads)), pieces);
    std::vector<std::jthread> others;
    try {
      for (std::size_t k = 1; k < workers; ++k)
        others.emplace_back([&work_through, limit = thread_limit] {
          const ThreadLimit same_limit(limit);
          work_through(false);
        });
    } catch (const std::system_error&) {
      // No more threads are available: the existing ones do the work.
    }
    work_through(true);
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace trivet::foundation
