// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/shared/periodic_writer.h"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <utility>

namespace trivet::study {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds between_looks(50);
constexpr int shares_of_writing = 20;  ///< at most one of them of the time is spent on writing

}  // namespace

PeriodicWriter::PeriodicWriter(std::function<void()> write, std::function<bool()> ends,
                               std::chrono::milliseconds most_between)
    : write_(std::move(write)),
      ends_(std::move(ends)),
      most_between_(most_between),
      thread_([this](const std::stop_token& over) { keep(over); }) {}

void PeriodicWriter::stop() {
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();
  if (failure_) std::rethrow_exception(failure_);
}

void PeriodicWriter::keep(const std::stop_token& over) {
  Clock::time_point written = Clock::now();
  Clock::duration between_files = between_looks;
  std::mutex waiting;
  std::unique_lock lock(waiting);
  std::condition_variable_any wake;
  try {
    while (!over.stop_requested() && !is_to_end_) {
      wake.wait_for(lock, over, between_looks, [] { return false; });
      is_to_end_ = ends_ && ends_();
      if (!is_to_end_ && Clock::now() - written < between_files) continue;
      const Clock::time_point begin = Clock::now();
      write_();
      written = Clock::now();
      between_files = std::max<Clock::duration>(std::min<Clock::duration>(2 * between_files, most_between_),
                                                shares_of_writing * (written - begin));
    }
  } catch (...) {
    failure_ = std::current_exception();
    is_to_end_ = true;
  }
}

}  // namespace trivet::study
