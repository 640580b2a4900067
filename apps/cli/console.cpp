// SPDX-License-Identifier: BSD-3-Clause
#include "cli/console.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "trivet/foundation/message_list.h"
#include "trivet/foundation/plain_text.h"

namespace trivet::cli {
namespace {

bool reader_has_left = false;

}  // namespace

void occupy_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0)
      static_cast<void>(open("/dev/null", O_RDONLY));  // gets the lowest free descriptor: this one
}

void write_output(const std::string& text) {
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

void write_problems(const foundation::Problems& problems) { write_error(foundation::message_list(problems)); }

void write_failure(const std::exception& failure) {
  std::string words = failure.what();
  if (const auto* of_file = dynamic_cast<const std::filesystem::filesystem_error*>(&failure))
    words = of_file->path1().string() + (of_file->path1().empty() ? "" : ": ") + of_file->code().message();
  else if (const auto* of_system = dynamic_cast<const std::system_error*>(&failure))
    words = of_system->code().message();
  else if (dynamic_cast<const std::bad_alloc*>(&failure) || dynamic_cast<const std::length_error*>(&failure))
    words = "not enough memory; request fewer points, results or cases at once";
  write_error("error: " + foundation::on_one_line(words) + "\n");
}

}  // namespace trivet::cli
