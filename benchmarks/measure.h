// SPDX-License-Identifier: BSD-3-Clause
// How ways to one answer are timed against each other: CPU time of one thread, taken in turns, so that all ways meet
// the same machine; ratios are medians over the turns.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace trivet::benchmarks {

/// One way to the answers of a question.
struct Way {
  std::string name;
  std::function<double()> seconds;  ///< CPU time of one chunk, divided by its items
  double flops = 0;                 ///< additions and multiplications per item, counted; 0: not told
  double goal = 0;                  ///< the first way shall be this many times as fast as this one; 0: no goal
  std::string note = {};
};

/// Work for `items` frequencies or designs in this process, repeated to chunks of at least 200 µs; called once before
/// each chunk, so that buffers are warm, unless one call takes 20 ms.
[[nodiscard]] Way here(std::string name, double items, std::function<void()> work, double flops = 0, double goal = 0);

/// Question, size and unit of a table; the first way is ours.
struct Question {
  std::string name;          ///< "direct sweep of six coordinates"
  std::string size;          ///< "10,000 frequencies"
  std::string item;          ///< "frequency": times are told per item
  double largest_error = 0;  ///< found when the answers were compared; a failure voids the timing: see `compared`
};

/// Times all ways in turns and writes one JSON line for each to $TRIVET_BENCHMARK_JSON (and a line of text to the
/// standard output). Returns the median seconds per item of each way.
std::vector<double> measure(const Question& question, const std::vector<Way>& ways, int turns = 21);

/// A figure that is no time: an error, a slope, a bandwidth. `met` is told with it.
void record(const std::string& question, const std::string& name, double value, const std::string& unit,
            const std::string& goal, bool met);

/// Errors of one way on one case.
void record_errors(const std::string& question, const std::string& way, double forward, double backward,
                   const std::string& goal, bool met);

/// Ends the program with status 1 if an answer misses its limit: what is wrong is not timed.
void compared(const std::string& what, double error, double limit);

/// CPU time of this thread [s].
[[nodiscard]] double thread_seconds();

/// Multiply-adds in registers, counted as two, with the instruction set in use, and stores past the caches: one chunk
/// of about 0.1 ms or 10 ms.
[[nodiscard]] double peak_flops();
[[nodiscard]] double streaming_store_bandwidth();

/// "Intel(R) Xeon(R) …, 2 cores, GCC 12.2.0, AVX3". Written with each record.
[[nodiscard]] std::string machine();

/// Part of all cores that is idle, over half a second.
[[nodiscard]] double idle_part();

/// Goals of ratios are those of AVX-512; with less they are 0.6 of it.
[[nodiscard]] double goal_factor();

/// Keeps this process and those it starts on one core for as long as it lives.
class OneCore {
 public:
  OneCore();
  ~OneCore();
  OneCore(const OneCore&) = delete;
  OneCore& operator=(const OneCore&) = delete;

 private:
  std::vector<int> cores_;
};

}  // namespace trivet::benchmarks
