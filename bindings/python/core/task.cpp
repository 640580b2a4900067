// SPDX-License-Identifier: BSD-3-Clause
#include "core/task.h"

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

#include "trivet/foundation/parallel_for.h"

namespace trivet::python {
namespace {

namespace nb = nanobind;
using namespace std::chrono_literals;

constexpr auto between_looks = 50ms;  // at signals and at the progress

/// What the two threads of a task share.
struct Course {
  std::mutex lock;
  std::condition_variable changed;
  bool done = false;
  std::exception_ptr failure;
  std::string task;
  double fraction = 0;
  std::atomic<bool> stopped = false;

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

void work_through(Course& course, int threads, const std::function<void(const foundation::Progress&)>& work) {
  std::exception_ptr failure;
  try {
    const foundation::ThreadLimit limit(threads);
    work([&course](std::string_view task, double fraction) { course.report(task, fraction); });
  } catch (...) {
    failure = std::current_exception();
  }
  {
    const std::lock_guard guard(course.lock);
    course.failure = failure;
    course.done = true;
  }
  course.changed.notify_all();
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
  if (progress.is_none() || task.empty() || fraction == shown) return;
  shown = fraction;
  progress(fraction, 1.0, task);
}

/// Waits until the work is done, a signal arrives, or the callback raises an error.
void look_on(Course& course, const nb::object& progress) {
  double shown = -1;
  for (;;) {
    {
      const nb::gil_scoped_release released;
      std::unique_lock guard(course.lock);
      if (course.changed.wait_for(guard, between_looks, [&] { return course.done; })) return;
    }
    if (PyErr_CheckSignals() != 0) throw nb::python_error();
    show(course, progress, shown);
  }
}

}  // namespace

void run_task(const TaskOptions& options, std::function<void(const foundation::Progress&)> work) {
  const auto course = std::make_shared<Course>();
  interrupted_tasks();
  std::thread thread;
  try {
    thread = std::thread([course, threads = options.threads, own = std::move(work)]() mutable {
      work_through(*course, threads, own);
      own = nullptr;  // what it owns is destroyed before the end is announced
      if (course->stopped) interrupted_tasks().end();
    });
  } catch (const std::system_error&) {
    throw std::runtime_error("no thread can be started for the computation; end other programs or raise the limit");
  }
  try {
    look_on(*course, options.progress);
  } catch (...) {
    interrupted_tasks().begin();
    course->stopped = true;
    thread.detach();
    throw;
  }
  {
    const nb::gil_scoped_release released;
    thread.join();
  }
  if (course->failure) std::rethrow_exception(course->failure);
}

bool wait_for_interrupted_work(double seconds) {
  const nb::gil_scoped_release released;
  return interrupted_tasks().wait(seconds);
}

}  // namespace trivet::python
