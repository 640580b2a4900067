// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <system_error>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"

extern char** environ;

namespace trivet::foundation {
namespace {

constexpr std::size_t output_kept = std::size_t{256} * 1024;
constexpr double most_output = 100e6;   // [bytes]; gmsh prints a few kilobytes, at most one line per element
constexpr int poll_milliseconds = 100;  // ten progress reports per second
constexpr int ending_milliseconds = 2;  // between the end of the output and the end of the program

void require(int error, const std::string& what) {
  if (error != 0) throw std::system_error(error, std::generic_category(), what);
}

/// Closes a file descriptor.
struct Descriptor {
  int number = -1;
  ~Descriptor() { close(); }
  void close() {
    if (number >= 0) ::close(number);
    number = -1;
  }
};

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> list;
  for (std::string& text : texts) list.push_back(text.data());
  list.push_back(nullptr);
  return list;
}

std::vector<std::string> merged_environment(const std::vector<std::string>& added) {
  std::vector<std::string> merged = added;
  for (char** entry = environ; *entry; ++entry) {
    const std::string_view text(*entry);
    const std::string_view name = text.substr(0, text.find('=') + 1);
    bool replaced = false;
    for (const std::string& other : added) replaced = replaced || std::string_view(other).starts_with(name);
    if (!replaced) merged.emplace_back(text);
  }
  return merged;
}

/// Starts a program with its arguments and environment.
std::unique_ptr<GuardedProgram> start(const Command& command, int output) {
  std::vector<std::string> arguments{command.program.string()};
  arguments.insert(arguments.end(), command.arguments.begin(), command.arguments.end());
  std::vector<std::string> environment = merged_environment(command.environment);
  return std::make_unique<GuardedProgram>(command.program.c_str(), pointers(arguments).data(),
                                          pointers(environment).data(),
                                          command.folder.empty() ? nullptr : command.folder.c_str(), output);
}

/// Appends the available output. Returns the bytes read; 0 at the end of the output, < 0 if none is available yet.
ssize_t read_some(int descriptor, std::string& output) {
  std::array<char, 16384> block;
  const ssize_t count = read(descriptor, block.data(), block.size());
  if (count > 0) output.append(block.data(), to_size(count));
  if (output.size() > 2 * output_kept) output.erase(0, output.size() - output_kept);
  return count;
}

}  // namespace

std::optional<std::filesystem::path> program_on_path(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::string_view rest = path ? path : "";
  while (!rest.empty()) {
    const std::string_view folder = rest.substr(0, rest.find(':'));
    rest.remove_prefix(std::min(rest.size(), folder.size() + 1));
    std::filesystem::path file = std::filesystem::path(folder) / name;
    std::error_code ignored;
    if (file.is_absolute() && std::filesystem::is_regular_file(file, ignored) && access(file.c_str(), X_OK) == 0)
      return file;
  }
  return std::nullopt;
}

CommandOutcome run(const Command& command, const Progress& progress) {
  if (!(command.time_limit > 0)) throw InvalidInput(fmt::format("time_limit = {} s; must be > 0", command.time_limit));
  int ends[2];
  require(pipe2(ends, O_CLOEXEC | O_NONBLOCK) == 0 ? 0 : errno, "pipe");
  Descriptor reading{ends[0]}, writing{ends[1]};
  fcntl(writing.number, F_SETFL, 0);  // blocking: the program may expect that it can always write
  const std::unique_ptr<GuardedProgram> program = start(command, writing.number);
  writing.close();

  using clock = std::chrono::steady_clock;
  const clock::time_point begin = clock::now();
  CommandOutcome outcome;
  ProgramEnd end;
  double printed = 0;
  while (!program->has_ended(end)) {
    report_progress(progress, command.task, 0);
    if (std::chrono::duration<double>(clock::now() - begin).count() > command.time_limit)
      outcome.end = CommandOutcome::End::time_limit;
    if (printed > most_output) outcome.end = CommandOutcome::End::endless_output;
    if (outcome.end != CommandOutcome::End::exited) return outcome;
    pollfd waiting{reading.number, POLLIN, 0};
    const bool open = reading.number >= 0;
    if (poll(&waiting, 1, open ? poll_milliseconds : ending_milliseconds) <= 0) continue;
    const ssize_t count = read_some(reading.number, outcome.output);
    if (count == 0) reading.close();
    printed += static_cast<double>(std::max<ssize_t>(0, count));
  }
  if (end.start_error != 0)
    throw std::system_error(end.start_error, std::generic_category(),
                            fmt::format("cannot start {}", command.program.string()));
  while (reading.number >= 0 && read_some(reading.number, outcome.output) > 0) {
  }
  outcome.end = WIFSIGNALED(end.status) ? CommandOutcome::End::signalled : CommandOutcome::End::exited;
  outcome.code = WIFSIGNALED(end.status) ? WTERMSIG(end.status) : WEXITSTATUS(end.status);
  return outcome;
}

std::string how_it_ended(const CommandOutcome& outcome, const Command& command) {
  switch (outcome.end) {
    case CommandOutcome::End::exited:
      return fmt::format("exit code {}", outcome.code);
    case CommandOutcome::End::signalled:
      return fmt::format("signal {}", outcome.code);
    case CommandOutcome::End::endless_output:
      return fmt::format("ended after {:.0f} MB of messages", most_output / 1e6);
    case CommandOutcome::End::time_limit:
      return fmt::format("ended after {:.4g} s", command.time_limit);
  }
  return {};
}

}  // namespace trivet::foundation
