// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <atomic>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "trivet/foundation/invalid_input.h"
#include "trivet/study/shared/shared_work.h"

namespace trivet {
namespace shared_work_test {

namespace fs = std::filesystem;
using study::SharedWork;

const study::StudyIdentity identity = {{"command", "test"}, {"version", "1"}};

class Shared : public testing::Test {
 protected:
  Shared() { fs::remove_all(folder_); }
  ~Shared() override { fs::remove_all(folder_); }

  const fs::path folder_ = fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
};

std::string square(std::size_t item) { return std::to_string(item * item) + " of \"item\"\n"; }

/// Two loops, of which the second depends on the result of the first, as in a search.
std::vector<std::string> both_loops(SharedWork& work, std::size_t count,
                                    const std::function<void(std::size_t item)>& before) {
  const auto compute = [&](std::size_t item) {
    before(item);
    return square(item);
  };
  const std::vector<std::string> first = work.results(count, {.threads = 2, .task = "first"}, compute);
  return work.results(first.back().size() + count, {.threads = 2, .task = "second"}, compute);
}

std::vector<std::string> expected(std::size_t count) {
  std::vector<std::string> all;
  for (std::size_t item = 0; item < square(count - 1).size() + count; ++item) all.push_back(square(item));
  return all;
}

TEST_F(Shared, ProcessesComputeEachItemOnceAndAllEndWithEveryResult) {
  constexpr std::size_t count = 60;
  std::atomic<std::size_t> computed = 0;
  std::vector<std::vector<std::string>> found(3);
  {
    std::vector<std::jthread> processes;
    for (std::uint64_t k = 0; k < found.size(); ++k)
      processes.emplace_back([&, k] {
        SharedWork work(folder_, {k + 1, found.size()}, identity);
        found[k] = both_loops(work, count, [&](std::size_t) {
          ++computed;
          std::this_thread::sleep_for(std::chrono::milliseconds(20));
        });
      });
  }
  for (const std::vector<std::string>& one : found) EXPECT_EQ(one, expected(count));
  const std::size_t items = count + expected(count).size();
  EXPECT_GE(computed, items);
  EXPECT_LT(computed, 2 * items);  // three times without sharing; at the end of a loop some are computed twice
}

TEST_F(Shared, NoneWaitsForAProcessThatHasStopped) {
  SharedWork stopped(folder_, {2, 2}, identity);
  SharedWork work(folder_, {1, 2}, identity);
  EXPECT_EQ(both_loops(work, 9, [](std::size_t) {}), expected(9));
}

TEST_F(Shared, WorkThatWasEndedGoesOn) {
  constexpr std::size_t ends_at = 5, count = 30;
  std::size_t computed_before = 0;
  {
    SharedWork work(folder_, {1, 1}, identity);
    const auto compute = [&](std::size_t item) {
      if (item == ends_at) throw foundation::Interrupted();
      return square(item);
    };
    EXPECT_THROW(static_cast<void>(work.results(count, {.threads = 1, .task = "first"}, compute)),
                 foundation::Interrupted);
    computed_before = work.counts().computed;
    EXPECT_EQ(computed_before, ends_at);
  }
  SharedWork work(folder_, {1, 1}, identity);
  EXPECT_EQ(both_loops(work, count, [](std::size_t) {}), expected(count));
  EXPECT_EQ(work.counts().read, computed_before);
  EXPECT_EQ(work.counts().computed, count + expected(count).size() - computed_before);
}

TEST_F(Shared, ADamagedFileIsComputedAgain) {
  {
    SharedWork work(folder_, {1, 1}, identity);
    both_loops(work, 9, [](std::size_t) {});
  }
  {
    std::fstream file(folder_ / "part-1-of-1", std::ios::in | std::ios::out);
    file.seekp(200);
    file.put('#');
  }
  SharedWork work(folder_, {1, 1}, identity);
  EXPECT_EQ(both_loops(work, 9, [](std::size_t) {}), expected(9));
  EXPECT_EQ(work.counts().read, 0);
}

// Two processes whose first loops differ, as by round-off of different processors, have no common second loop.
TEST_F(Shared, LoopsAfterDifferentResultsAreDifferent) {
  {
    SharedWork work(folder_, {1, 2}, identity);
    static_cast<void>(work.results(4, {.task = "first"}, [](std::size_t item) { return square(item); }));
    static_cast<void>(work.results(4, {.task = "second"}, [](std::size_t item) { return square(item); }));
  }
  SharedWork other(folder_, {2, 2}, identity);
  static_cast<void>(other.results(5, {.task = "first"}, [](std::size_t item) { return square(item + 1); }));
  EXPECT_EQ(other.counts().read, 0);
  EXPECT_EQ(other.results(4, {.task = "second"}, [](std::size_t item) { return square(item + 2); }).front(), square(2));
  EXPECT_EQ(other.counts().read, 0);
}

TEST_F(Shared, APartHasOneProcessAndAFolderOneStudy) {
  const SharedWork work(folder_, {1, 2}, identity);
  EXPECT_THROW(SharedWork(folder_, {1, 2}, identity), foundation::InvalidInput);
  EXPECT_THROW(SharedWork(folder_, {1, 3}, identity), foundation::InvalidInput);
  EXPECT_THROW(SharedWork(folder_, {2, 2}, {{"command", "test"}, {"version", "2"}}), foundation::InvalidInput);
}

}  // namespace shared_work_test
}  // namespace trivet
