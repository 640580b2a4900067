// SPDX-License-Identifier: BSD-3-Clause
#include "cli/console.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <system_error>

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

std::size_t output_width() {
  constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max(), least = 40, most = 1000;
  const auto within = [&](std::size_t width) { return std::min(std::max(width, least), most); };
  if (const char* columns = std::getenv("COLUMNS")) {
    std::size_t width = 0;
    const std::string_view text = columns;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), width);
    if (error == std::errc() && end == text.data() + text.size() && width > 0) return within(width);
  }
  winsize size{};
  return ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? within(size.ws_col) : unlimited;
}

void write_error(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stderr) == text.size()) std::fflush(stderr);
}

}  // namespace trivet::cli
