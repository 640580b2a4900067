// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/server/worker.h"

#include <exception>
#include <string_view>
#include <utility>
#include <vector>

#include "trivet/engine/program.h"

namespace trivet::server {
namespace {

Answer replaced_answer() { return error_answer(409, "a newer question of this page replaced this one"); }

Answer computed_answer(const WorkerTask& task, const std::atomic<bool>& is_replaced) {
  try {
    return task.compute([&](std::string_view, double) {
      if (is_replaced || *task.has_left) throw foundation::Interrupted();
    });
  } catch (const foundation::Interrupted&) {
    return replaced_answer();
  } catch (const foundation::InvalidInput& wrong) {
    return error_answer(400, wrong.what());
  } catch (const std::exception& failure) {
    return error_answer(500, engine::failure_words(failure));
  }
}

}  // namespace

Worker::Worker() : thread_([this] { run(); }) {}

Worker::~Worker() {
  {
    const std::scoped_lock guard(lock_);
    ends_ = true;
    is_replaced_ = true;
  }
  is_changed_.notify_one();
  thread_.join();
}

void Worker::put(WorkerTask task) {
  std::vector<WorkerTask> replaced;
  {
    const std::scoped_lock guard(lock_);
    if (task.client && running_client_ == task.client) is_replaced_ = true;
    for (auto one = waiting_.begin(); one != waiting_.end();) {
      if (!task.client || one->client != task.client) {
        ++one;
        continue;
      }
      replaced.push_back(std::move(*one));
      one = waiting_.erase(one);
    }
    waiting_.push_back(std::move(task));
  }
  is_changed_.notify_one();
  for (const WorkerTask& one : replaced) one.reply(replaced_answer());
}

void Worker::run() {
  for (;;) {
    WorkerTask task;
    {
      std::unique_lock guard(lock_);
      is_changed_.wait(guard, [this] { return ends_ || !waiting_.empty(); });
      if (ends_) return;
      task = std::move(waiting_.front());
      waiting_.pop_front();
      running_client_ = task.client;
      is_replaced_ = false;
    }
    Answer answer = *task.has_left ? replaced_answer() : computed_answer(task, is_replaced_);
    {
      const std::scoped_lock guard(lock_);
      running_client_.reset();
    }
    task.reply(std::move(answer));
  }
}

}  // namespace trivet::server
