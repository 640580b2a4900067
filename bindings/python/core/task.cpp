// SPDX-License-Identifier: BSD-3-Clause
#include "core/task.h"

#include <fmt/format.h>
#include <nanobind/stl/string.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>

namespace trivet::python {
namespace {

namespace nb = nanobind;
using namespace std::chrono_literals;

constexpr auto between_looks = 50ms;  // at signals and at the progress

/// What the two threads of a task share. Of `ended` and `abandoned` the first that is set under the lock decides
/// whether the result is taken.
struct Course {
  std::mutex lock;
  std::condition_variable changed;
  bool ended = false;      ///< set by the worker, when it needs nothing any more
  bool abandoned = false;  ///< set by the caller, who then does not wait
  std::exception_ptr failure;
  std::string task;
  double fraction = 0;
  std::atomic<bool> stopped = false;  ///< the next report ends the work

  void report(std::string_view now, double share) {
    if (stopped) throw foundation::Interrupted();
    const std::lock_guard guard(lock);
    task = now;
    fraction = share;
  }
};

/// Interrupted tasks that are not done yet.
class InterruptedTasks {
 public:
  void begin() { change(1); }
  void end() { change(-1); }
  [[nodiscard]] bool wait(double seconds) {
    std::unique_lock guard(lock_);
    return changed_.wait_for(guard, std::chrono::duration<double>(seconds), [this] { return left_ == 0; });
  }

 private:
  void change(int by) {
    {
      const std::lock_guard guard(lock_);
      left_ += by;
    }
    changed_.notify_all();
  }
  std::mutex lock_;
  std::condition_variable changed_;
  int left_ = 0;
};

InterruptedTasks& interrupted_tasks() {
  static auto* const tasks = new InterruptedTasks;  // never destroyed: a task may end after all statics
  return *tasks;
}

using Work = std::function<void(const foundation::Progress&)>;

void work_through(Course& course, Work work) {
  std::exception_ptr failure;
  try {
    work([&course](std::string_view task, double fraction) { course.report(task, fraction); });
  } catch (...) {
    failure = std::current_exception();
  }
  work = nullptr;  // what it owns is destroyed before the end is announced
  {
    const std::lock_guard guard(course.lock);
    course.failure = std::move(failure);
    course.ended = true;
    if (course.abandoned) interrupted_tasks().end();
  }
  course.changed.notify_all();
}

/// Leaves the work to itself, unless it has ended. @returns whether it had not
bool abandon(Course& course) {
  const std::lock_guard guard(course.lock);
  if (course.ended) return false;
  interrupted_tasks().begin();
  course.abandoned = true;
  course.stopped = true;
  return true;
}

/// Shows the progress if it has changed. Needs Python's lock. @throws nb::python_error of the callback
void show(Course& course, const nb::object& progress, double& shown) {
  std::string task;
  double fraction = 0;
  {
    const std::lock_guard guard(course.lock);
    task = course.task;
    fraction = course.fraction;
  }
  if (progress.is_none() || task.empty() || fraction == shown || fraction >= 1) return;  // show_the_end shows 1
  shown = fraction;
  progress(fraction, 1.0, task);
}

/// The end of work without a failure is shown too.
void show_the_end(const Course& course, const TaskOptions& options) {
  if (!options.progress.is_none()) options.progress(1.0, 1.0, course.task.empty() ? options.name : course.task);
}

/// Waits until the work has ended, a signal arrives, or the callback raises an error.
void look_on(Course& course, const nb::object& progress) {
  double shown = -1;
  for (;;) {
    {
      const nb::gil_scoped_release released;
      std::unique_lock guard(course.lock);
      if (course.changed.wait_for(guard, between_looks, [&] { return course.ended; })) return;
    }
    if (PyErr_CheckSignals() != 0) throw nb::python_error();
    show(course, progress, shown);
  }
}

}  // namespace

void run_task(const TaskOptions& options, Work work) {
  if (options.threads < 0)
    throw foundation::InvalidInput(
        fmt::format("threads: {}; a number ≥ 1, or 0 for all of the machine", options.threads));
  const auto course = std::make_shared<Course>();
  interrupted_tasks();
  std::thread thread;
  try {
    thread = std::thread([course, own = std::move(work)]() mutable { work_through(*course, std::move(own)); });
  } catch (const std::system_error&) {
    throw std::runtime_error("no thread can be started for the computation; end other programs or raise the limit");
  }
  try {
    look_on(*course, options.progress);
  } catch (...) {
    if (abandon(*course)) thread.detach();
    else thread.join();
    throw;
  }
  {
    const nb::gil_scoped_release released;
    thread.join();
  }
  if (course->failure) std::rethrow_exception(course->failure);
  show_the_end(*course, options);
}

bool wait_for_interrupted_work(double seconds) {
  const nb::gil_scoped_release released;
  return interrupted_tasks().wait(seconds);
}

}  // namespace trivet::python
