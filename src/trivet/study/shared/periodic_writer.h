// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <thread>

namespace trivet::study {

/// Writes the file of a part again and again, more often at the start, on a thread of its own.
class PeriodicWriter {
 public:
  /// @param ends  once it is true, the file is written at once and no more; called on the thread of the writer; empty:
  /// never  @param most_between  time between two files: less in the beginning, more if they take long
  PeriodicWriter(std::function<void()> write, std::function<bool()> ends, std::chrono::milliseconds most_between);

  /// True once `ends` was, or a file could not be written. May be called on any thread.
  [[nodiscard]] bool is_to_end() const { return is_to_end_; }
  /// Ends the thread. @throws what `write` threw, each time
  void stop();

 private:
  void keep(const std::stop_token& over);

  std::function<void()> write_;
  std::function<bool()> ends_;
  std::chrono::milliseconds most_between_;
  std::atomic<bool> is_to_end_ = false;
  std::exception_ptr failure_;
  std::jthread thread_;
};

}  // namespace trivet::study
