// SPDX-License-Identifier: BSD-3-Clause
// How long does the program take from its start to its end? Peaks of the paper's example, and the map of a million
// designs on all cores.
#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "measure.h"

namespace {

using namespace trivet::benchmarks;

struct Run {
  double wall = 0, cpu = 0;
  double memory = 0;  ///< [byte], largest resident
};

/// One run of the program with its output discarded.
Run run(const std::vector<std::string>& words) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
  const auto from = std::chrono::steady_clock::now();
  pid_t process = 0;
  if (posix_spawn(&process, arguments[0], &actions, nullptr, arguments.data(), environ) != 0)
    throw std::runtime_error(words[0] + " cannot be started");
  int status = 0;
  rusage usage{};
  wait4(process, &status, 0, &usage);
  const auto to = std::chrono::steady_clock::now();
  posix_spawn_file_actions_destroy(&actions);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) throw std::runtime_error(words[0] + " " + words[1] + " failed");
  const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
  return {std::chrono::duration<double>(to - from).count(), seconds(usage.ru_utime) + seconds(usage.ru_stime),
          1024.0 * double(usage.ru_maxrss)};
}

/// The run of median wall time; only one run if it takes longer than ten seconds.
Run median(const std::vector<std::string>& words, int runs) {
  std::vector<Run> all = {run(words)};
  while (all[0].wall < 10 && static_cast<int>(all.size()) < runs) all.push_back(run(words));
  std::sort(all.begin(), all.end(), [](const Run& a, const Run& b) { return a.wall < b.wall; });
  return all[all.size() / 2];
}

}  // namespace

int main() {
  const std::string example = TRIVET_EXAMPLES, question = "whole program";
  const Run peaks = median({TRIVET_PROGRAM, "peaks", example + "/corrected.toml"}, 21);
  record(question, "`trivet peaks` of the paper's example, wall", 1e3 * peaks.wall, "ms", "≤ 20", peaks.wall <= 0.020);
  record(question, "… CPU", 1e3 * peaks.cpu, "ms", "", true);

  if (!std::filesystem::exists(example + "/map.toml")) return 0;
  const double before = idle_part();
  const Run map = median({TRIVET_PROGRAM, "map", example + "/map.toml", "--points", "1000x1000"}, 7);
  const bool idle = before >= 0.9 && idle_part() >= 0.9;
  const std::string which = "`trivet map` of 1,000,000 designs on all cores, wall";
  record(question, which + (idle ? "" : " (contended)"), map.wall, "s", "≤ 2", map.wall <= 2);
  record(question, "… CPU of all threads", map.cpu, "s", "", true);
  record(question, "… memory", map.memory / 1e6, "MB", "", true);
}
