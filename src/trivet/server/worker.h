// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

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

/// One thread that does its tasks in their order.
class Worker {
 public:
  Worker();
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  void put(WorkerTask task);

 private:
  void run();

  std::mutex lock_;
  std::condition_variable is_changed_;
  std::deque<WorkerTask> waiting_;
  std::optional<std::string> running_client_;
  std::atomic<bool> is_replaced_ = false;  ///< the running task
  bool ends_ = false;
  std::thread thread_;
};

}  // namespace trivet::server
