// SPDX-License-Identifier: BSD-3-Clause
// Timing of several methods for one answer: CPU time of one thread, taken in turns, so that all methods meet the same
// machine; ratios are medians over the turns.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace trivet::benchmarks {

/// One method for the answers of a question.
struct Method {
  std::string name;
  std::function<double()> seconds;  ///< CPU time of one chunk, divided by its items
  double flops = 0;                 ///< additions and multiplications per item, counted; 0: unknown
  double goal = 0;                  ///< required speed of the first method relative to this one; 0: no goal
  std::string note = {};
};

/// Method that does work for `items` frequencies or designs in this process, repeated to chunks of at least 200 µs;
/// called once before each chunk, so that buffers are warm, unless one call takes 20 ms.
[[nodiscard]] Method in_process(std::string name, double items, std::function<void()> work, double flops = 0,
                                double goal = 0);

/// Question, size and unit of a table; the first method is Trivet.
struct Question {
  std::string name;          ///< "direct sweep of six coordinates"
  std::string size;          ///< "10,000 frequencies"
  std::string item;          ///< "frequency": times are reported per item
  double largest_error = 0;  ///< in the comparison of the answers; a failure voids the timing: see `compared`
};

/// Times all methods in turns and writes one JSON line for each to $TRIVET_BENCHMARK_JSON (and a line of text to the
/// standard output). Returns the median seconds per item of each method.
std::vector<double> measure(const Question& question, const std::vector<Method>& methods, int turns = 21);

/// Records a value that is not a time: an error, a slope, a bandwidth. `met` is recorded with it.
void record(const std::string& question, const std::string& name, double value, const std::string& unit,
            const std::string& goal, bool met);

/// Records the errors of one method on one case.
void record_errors(const std::string& question, const std::string& method, double forward, double backward,
                   const std::string& goal, bool met);

/// Ends the program with status 1 if an error exceeds its limit: wrong answers are not timed.
void compared(const std::string& what, double error, double limit);

/// CPU time of this thread [s].
[[nodiscard]] double thread_seconds();

/// Peak rate of multiply-adds in registers, counted as two, with the instruction set in use. One chunk takes about
/// 0.1 ms.
[[nodiscard]] double peak_flops();

/// The machine: "Intel(R) Xeon(R) …, 2 cores, GCC 12.2.0, AVX3". Written with each record.
[[nodiscard]] std::string machine();

/// Idle part of all cores, over half a second.
[[nodiscard]] double idle_part();

/// Factor on the goals of ratios: 1 with AVX-512, else 0.6.
[[nodiscard]] double goal_factor();

/// Binds this process and those it starts to one core during its lifetime.
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
