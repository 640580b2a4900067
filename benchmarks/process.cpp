// SPDX-License-Identifier: BSD-3-Clause
#include "process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <string>
#include <vector>

namespace trivet::benchmarks {
namespace {

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

}  // namespace

Run median(const std::vector<std::string>& words, int runs) {
  std::vector<Run> all = {run(words)};
  while (all[0].wall < 10 && static_cast<int>(all.size()) < runs) all.push_back(run(words));
  std::ranges::sort(all, {}, &Run::wall);
  return all[all.size() / 2];
}

}  // namespace trivet::benchmarks
