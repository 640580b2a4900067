// SPDX-License-Identifier: BSD-3-Clause
#include "cli/progress_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include "cli/console.h"

namespace trivet::cli {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

std::string time_words(double seconds) {
  if (seconds < 90) return fmt::format("{:.0f} s", seconds);
  if (seconds < 90 * 60) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

class ProgressLine {
 public:
  ProgressLine() = default;
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine() {
    if (last_ < 1 && !task_.empty()) write_error(clear);
  }

  void show(std::string_view task, double fraction) {
    const std::lock_guard lock(showing_);
    if (task != task_ || fraction < last_) {  // another task, or the same for the next case
      task_ = task;
      first_ = fraction;
      start_ = Clock::now();
    } else if (fraction < 1 && seconds_since(shown_) < between_lines) {
      return;
    }
    last_ = fraction;
    shown_ = Clock::now();
    write_error(fraction >= 1 ? clear
                              : fmt::format("{}{} {:.0f} %{}", clear, task, 100 * fraction, time_left(fraction)));
  }

 private:
  static constexpr const char* clear = "\r\033[K";
  static constexpr double between_lines = 0.1, known_after = 2;  // [s]
  static constexpr double least_share = 0.01;                    // done, for an estimate

  /// Time left at the speed so far.
  [[nodiscard]] std::string time_left(double fraction) const {
    const double elapsed = seconds_since(start_), share = fraction - first_;
    if (elapsed < known_after || share < least_share) return "";
    return ", about " + time_words(elapsed * (1 - fraction) / share) + " left";
  }

  std::mutex showing_;
  std::string task_;
  double first_ = 0, last_ = 0;  ///< fractions of the task that were shown
  Clock::time_point start_, shown_;
};

/// On a pipe or in a file: a whole line, but only of what takes longer than half a minute.
class ProgressLog {
 public:
  void show(std::string_view task, double fraction) {
    const std::lock_guard lock(showing_);
    if (task != task_ || fraction < last_) {
      task_ = task;
      first_ = fraction;
      start_ = Clock::now();
    }
    last_ = fraction;
    if (seconds_since(shown_) < between_lines || fraction >= 1) return;
    shown_ = Clock::now();
    const double share = fraction - first_;
    write_error(fmt::format(
        "{} {:.0f} %{}\n", task, 100 * fraction,
        share > 0 ? ", about " + time_words(seconds_since(start_) * (1 - fraction) / share) + " left" : ""));
  }

 private:
  static constexpr double between_lines = 30;  // [s]
  std::mutex showing_;
  std::string task_;
  double first_ = 0, last_ = 0;
  Clock::time_point start_, shown_ = Clock::now();
};

}  // namespace

foundation::Progress progress() {
  if (::isatty(STDERR_FILENO) == 0)
    return
        [log = std::make_shared<ProgressLog>()](std::string_view task, double fraction) { log->show(task, fraction); };
  return
      [line = std::make_shared<ProgressLine>()](std::string_view task, double fraction) { line->show(task, fraction); };
}

}  // namespace trivet::cli
