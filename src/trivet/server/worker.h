// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/server/answer.h"

namespace trivet::server {

/// Work for an answer, away from the thread that serves connections.
struct WorkerTask {
  std::optional<std::string> client = {};  ///< a newer task of the same client ends this one; nullopt: none does
  std::function<Answer(const foundation::Progress&)> compute;
  std::function<void(Answer)> reply;                  ///< called once, on any thread
  std::shared_ptr<const std::atomic<bool>> has_left;  ///< true once nobody waits for the answer
};

/// What a client's task does now.
struct Doing {
  std::string task;     ///< as the progress last called it; empty: it has not reported anything
  double fraction = 0;  ///< 0 … 1
};

/// Threads that do tasks: those of one client one after the other, those of different clients side by side, so that a
/// long task of one client keeps no other one waiting. One thread does all tasks in their order.
class Worker {
 public:
  explicit Worker(std::size_t threads);
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  void put(WorkerTask task);
  /// None if no task of this client is under way.
  [[nodiscard]] std::optional<Doing> doing(const std::string& client);

 private:
  struct Running {
    std::optional<std::string> client;
    std::atomic<bool> is_replaced = false;
    Doing doing = {};
  };

  void run();
  /// Waits for a task that can begin. @returns false at the end
  [[nodiscard]] bool begin_next(WorkerTask& task, std::list<Running>::iterator& running);
  [[nodiscard]] Answer computed_answer(const WorkerTask& task, Running& running);

  std::mutex lock_;
  std::condition_variable is_changed_;
  std::deque<WorkerTask> waiting_;
  std::list<Running> running_;
  bool ends_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace trivet::server
