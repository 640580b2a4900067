// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/parallel_for.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

namespace trivet::foundation {
namespace parallel_for_test {

TEST(Pieces, CoverEveryNumberOnceForAnyThreads) {
  for (const int threads : {1, 2, 16})
    for (const std::size_t count : {0u, 1u, 7u, 64u, 1000u}) {
      std::vector<std::atomic<int>> visits(count);
      parallel_for(count, {.size = 7, .threads = threads}, [&](std::size_t first, std::size_t last) {
        EXPECT_EQ(first % 7, 0u);
        EXPECT_LE(last - first, 7u);
        for (std::size_t i = first; i < last; ++i) ++visits[i];
      });
      for (const auto& v : visits) EXPECT_EQ(v, 1);
    }
}

TEST(Pieces, ThrowOnTheFirstFailureAndStop) {
  std::atomic<int> started = 0;
  EXPECT_THROW(parallel_for(100000, {.size = 1, .threads = 4},
                            [&](std::size_t first, std::size_t) {
                              ++started;
                              if (first == 3) throw std::runtime_error("piece 3");
                              std::this_thread::sleep_for(
                                  std::chrono::microseconds(20));  // else all may end before the failure is known
                            }),
               std::runtime_error);
  EXPECT_LT(started, 100000);
}

TEST(Pieces, ReportFromTheCallingThreadOnlyAndStopWhenInterrupted) {
  const auto caller = std::this_thread::get_id();
  int reports = 0;
  const Progress progress = [&](std::string_view task, double) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    EXPECT_EQ(task, "counting");
    if (++reports == 2) throw Interrupted();
  };
  EXPECT_THROW(parallel_for(1000, {.size = 1, .threads = 1, .progress = progress, .task = "counting"},
                            [](std::size_t, std::size_t) {}),
               Interrupted);
  EXPECT_EQ(reports, 2);
}

TEST(Pieces, StopAllThreadsWhenInterrupted) {
  std::atomic<int> finished = 0;
  const Progress progress = [](std::string_view, double) { throw Interrupted(); };
  EXPECT_THROW(parallel_for(100000, {.size = 1, .threads = 4, .progress = progress},
                            [&](std::size_t, std::size_t) {
                              ++finished;
                              std::this_thread::sleep_for(std::chrono::microseconds(20));
                            }),
               Interrupted);
  EXPECT_LT(finished, 100000);
}

}  // namespace parallel_for_test
}  // namespace trivet::foundation
