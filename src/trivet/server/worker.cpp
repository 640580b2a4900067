// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/server/worker.h"

#include <algorithm>
#include <exception>
#include <string_view>
#include <utility>

#include "trivet/engine/program.h"

namespace trivet::server {
namespace {

Answer replaced_answer() { return error_answer(409, "a newer question of this page replaced this one"); }

}  // namespace

Worker::Worker(std::size_t threads) {
  for (std::size_t i = 0; i < threads; ++i) threads_.emplace_back([this] { run(); });
}

Worker::~Worker() {
  {
    const std::scoped_lock guard(lock_);
    ends_ = true;
    for (Running& one : running_) one.is_replaced = true;
  }
  is_changed_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void Worker::put(WorkerTask task) {
  std::vector<WorkerTask> replaced;
  {
    const std::scoped_lock guard(lock_);
    for (Running& one : running_)
      if (task.client && one.client == task.client) one.is_replaced = true;
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
  is_changed_.notify_all();
  for (const WorkerTask& one : replaced) one.reply(replaced_answer());
}

std::optional<Doing> Worker::doing(const std::string& client) {
  const std::scoped_lock guard(lock_);
  for (const Running& one : running_)
    if (one.client == client) return one.doing;
  const bool waits = std::ranges::any_of(waiting_, [&](const WorkerTask& one) { return one.client == client; });
  return waits ? std::optional(Doing{"waiting for other pages"}) : std::nullopt;
}

bool Worker::begin_next(WorkerTask& task, std::list<Running>::iterator& running) {
  const auto can_begin = [this](const WorkerTask& one) {
    return !one.client ||
        std::ranges::none_of(running_, [&](const Running& other) { return other.client == one.client; });
  };
  std::unique_lock guard(lock_);
  auto next = waiting_.end();
  is_changed_.wait(guard, [&] {
    next = std::ranges::find_if(waiting_, can_begin);
    return ends_ || next != waiting_.end();
  });
  if (ends_) return false;
  task = std::move(*next);
  waiting_.erase(next);
  running = running_.emplace(running_.end());
  running->client = task.client;
  return true;
}

Answer Worker::computed_answer(const WorkerTask& task, Running& running) {
  try {
    return task.compute([&](std::string_view what, double fraction) {
      if (running.is_replaced || *task.has_left) throw foundation::Interrupted();
      const std::scoped_lock guard(lock_);
      running.doing.task = what;
      running.doing.fraction = fraction;
    });
  } catch (const foundation::Interrupted&) {
    return replaced_answer();
  } catch (const foundation::InvalidInput& wrong) {
    return error_answer(400, wrong.what());
  } catch (const std::exception& failure) {
    return error_answer(500, engine::failure_words(failure));
  }
}

void Worker::run() {
  WorkerTask task;
  std::list<Running>::iterator running;
  while (begin_next(task, running)) {
    Answer answer = *task.has_left ? replaced_answer() : computed_answer(task, *running);
    {
      const std::scoped_lock guard(lock_);
      running_.erase(running);
    }
    is_changed_.notify_all();  // another task of this client can begin
    task.reply(std::move(answer));
    task = {};  // holds nothing of the connection while it waits
  }
}

}  // namespace trivet::server
