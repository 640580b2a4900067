// SPDX-License-Identifier: BSD-3-Clause
#include "cli/console.h"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string_view>

namespace trivet::cli {
namespace {

std::atomic<bool> interrupted = false;

}  // namespace

void write_output(const std::string& text) {
  errno = 0;
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (!written || std::fflush(stdout) != 0)
    throw std::runtime_error(fmt::format("standard output: {}", errno ? std::strerror(errno) : "not everything was written"));
}

void write_error(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stderr) == text.size()) std::fflush(stderr);
}

void write_problems(const foundation::Problems& problems) {
  for (const auto& problem : problems.list()) write_error(foundation::message(problem) + "\n");
}

void catch_interrupts() {
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, [](int) { interrupted = true; });
}

foundation::Progress progress() {
  const bool terminal = ::isatty(STDERR_FILENO) != 0;
  return [terminal](std::string_view task, double fraction) {
    if (interrupted) throw foundation::Interrupted();
    if (terminal) write_error(fmt::format("\r\033[K{} {:.0f} %{}", task, 100 * fraction, fraction >= 1 ? "\r\033[K" : ""));
  };
}

}  // namespace trivet::cli
