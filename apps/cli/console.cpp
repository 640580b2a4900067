// SPDX-License-Identifier: BSD-3-Clause
#include "cli/console.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string_view>

namespace trivet::cli {
namespace {

constexpr int reader_left = 141;

bool reader_has_left = false;

}  // namespace

void occupy_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0)
      static_cast<void>(open("/dev/null", O_RDONLY));  // gets the lowest free descriptor: this one
}

void write_output(std::string_view text) {
  if (reader_has_left) return;
  errno = 0;
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (written && std::fflush(stdout) == 0) return;
  reader_has_left = errno == EPIPE;
  if (!reader_has_left)
    throw std::runtime_error(fmt::format("standard output: {}", errno ? std::strerror(errno) : "incomplete output"));
}

int exit_code(int code) { return reader_has_left ? reader_left : code; }

void write_error(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stderr) == text.size()) std::fflush(stderr);
}

}  // namespace trivet::cli
