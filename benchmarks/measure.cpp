// SPDX-License-Identifier: BSD-3-Clause
#include "measure.h"

#include <sched.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "trivet/numerics/lanes/instruction_set.h"

namespace trivet::benchmarks {
namespace {

using nlohmann::json;

struct Spread {
  double median, lowest, highest;
};

Spread spread(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return {values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2, values.front(), values.back()};
}

void write(json line) {
  line["machine"] = machine();
  if (const char* file = std::getenv("TRIVET_BENCHMARK_JSON"))
    std::ofstream(file, std::ios::app) << line.dump() << '\n';
}

std::vector<double> processor_ticks() {
  std::ifstream file("/proc/stat");
  std::string label;
  file >> label;
  std::vector<double> ticks(8);
  for (double& t : ticks) file >> t;
  return ticks;
}

}  // namespace

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Method in_process(std::string name, double items, std::function<void()> work, double flops, double goal) {
  constexpr double chunk = 200e-6, long_enough_to_be_warm = 20e-3;
  const auto run = [work = std::move(work)](int times) {
    const double from = thread_seconds();
    for (int i = 0; i < times; ++i) work();
    return thread_seconds() - from;
  };
  int repeats = 1;
  run(1);
  while (run(repeats) < chunk) repeats *= 2;
  const auto seconds = [run, repeats, items] {
    const double first = run(1);  // fills the caches that the others emptied
    return (first > long_enough_to_be_warm ? first : run(repeats) / repeats) / items;
  };
  return {std::move(name), seconds, flops, goal};
}

std::vector<double> measure(const Question& question, const std::vector<Method>& methods, int turns) {
  std::vector<std::vector<double>> seconds(methods.size());
  std::vector<double> peak;
  for (int turn = 0; turn < turns; ++turn) {
    peak.push_back(peak_flops());
    for (std::size_t w = 0; w < methods.size(); ++w) seconds[w].push_back(methods[w].seconds());
  }
  std::printf("%s, %s: ns per %s (%d turns), largest error %.1e\n", question.name.c_str(), question.size.c_str(),
              question.item.c_str(), turns, question.largest_error);
  std::vector<double> medians;
  for (std::size_t w = 0; w < methods.size(); ++w) {
    std::vector<double> ratios, parts;
    for (std::size_t t = 0; t < peak.size(); ++t) {
      ratios.push_back(seconds[w][t] / seconds[0][t]);
      parts.push_back(methods[w].flops / seconds[w][t] / peak[t]);
    }
    const Spread time = spread(seconds[w]), ratio = spread(ratios), part = spread(parts);
    const double goal = methods[w].goal * (methods[w].goal > 1 ? goal_factor() : 1);
    medians.push_back(time.median);
    std::printf("  %-44s %12.2f   x %-9.3g [%.3g … %.3g]", methods[w].name.c_str(), 1e9 * time.median, ratio.median,
                ratio.lowest, ratio.highest);
    if (methods[w].flops > 0)
      std::printf("  %.1f GFLOP/s, %.0f %% of %.1f", 1e-9 * methods[w].flops / time.median, 100 * part.median,
                  1e-9 * spread(peak).median);
    if (goal > 0) std::printf("  goal %.3g: %s", goal, ratio.median >= goal ? "met" : "NOT MET");
    std::printf("%s%s\n", methods[w].note.empty() ? "" : "  ", methods[w].note.c_str());
    json line{{"kind", "time"},
              {"question", question.name},
              {"size", question.size},
              {"item", question.item},
              {"error", question.largest_error},
              {"way", methods[w].name},
              {"ns", 1e9 * time.median},
              {"ns_lowest", 1e9 * time.lowest},
              {"ns_highest", 1e9 * time.highest},
              {"ratio", ratio.median},
              {"ratio_lowest", ratio.lowest},
              {"ratio_highest", ratio.highest},
              {"turns", turns},
              {"peak_gflops", 1e-9 * spread(peak).median},
              {"ours", w == 0},
              {"note", methods[w].note}};
    if (methods[w].flops > 0)
      line["gflops"] = 1e-9 * methods[w].flops / time.median, line["part_of_peak"] = part.median;
    if (goal > 0) line["goal"] = goal, line["met"] = ratio.median >= goal;
    write(line);
  }
  std::fflush(stdout);
  return medians;
}

void record(const std::string& question, const std::string& name, double value, const std::string& unit,
            const std::string& goal, bool met) {
  std::printf("%s: %s %.4g %s%s\n", question.c_str(), name.c_str(), value, unit.c_str(),
              goal.empty() ? "" : ("  goal " + goal + (met ? ": met" : ": NOT MET")).c_str());
  std::fflush(stdout);
  write({{"kind", "figure"},
         {"question", question},
         {"way", name},
         {"value", value},
         {"unit", unit},
         {"goal", goal},
         {"met", met}});
}

void record_errors(const std::string& question, const std::string& method, double forward, double backward,
                   const std::string& goal, bool met) {
  write({{"kind", "errors"},
         {"question", question},
         {"way", method},
         {"forward", forward},
         {"backward", backward},
         {"goal", goal},
         {"met", met}});
}

void compared(const std::string& what, double error, double limit) {
  if (error <= limit) return;
  std::printf("WRONG: %s: error %.2e, at most %.1e is allowed; nothing is timed\n", what.c_str(), error, limit);
  std::exit(1);
}

std::string machine() {
  std::string model = "unknown processor";
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) {
      model = line.substr(line.find(':') + 2);
      break;
    }
  std::ostringstream text;
#ifdef __clang__
  text << model << ", " << std::thread::hardware_concurrency() << " cores, Clang " << __clang_version__;
#else
  text << model << ", " << std::thread::hardware_concurrency() << " cores, GCC " << __VERSION__;
#endif
  text << ", " << numerics::instruction_set();
  return text.str();
}

double idle_part() {
  const std::vector<double> before = processor_ticks();
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  const std::vector<double> after = processor_ticks();
  double all = 0;
  for (std::size_t i = 0; i < after.size(); ++i) all += after[i] - before[i];
  return all > 0 ? (after[3] - before[3] + after[4] - before[4]) / all : 0;
}

double goal_factor() { return numerics::instruction_set().starts_with("AVX3") ? 1 : 0.6; }

OneCore::OneCore() {
  cpu_set_t set;
  sched_getaffinity(0, sizeof set, &set);
  for (int core = 0; core < CPU_SETSIZE; ++core)
    if (CPU_ISSET(core, &set)) cores_.push_back(core);
  CPU_ZERO(&set);
  CPU_SET(cores_.back(), &set);
  sched_setaffinity(0, sizeof set, &set);
}

OneCore::~OneCore() {
  cpu_set_t set;
  CPU_ZERO(&set);
  for (const int core : cores_) CPU_SET(core, &set);
  sched_setaffinity(0, sizeof set, &set);
}

}  // namespace trivet::benchmarks
