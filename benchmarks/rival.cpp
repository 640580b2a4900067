// SPDX-License-Identifier: BSD-3-Clause
#include "rival.h"
#include "trivet/foundation/index.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <complex>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace trivet::benchmarks {

void write_numbers(const std::filesystem::path& file, const double* values, std::size_t count) {
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(values), static_cast<std::streamsize>(count * sizeof(double)));
}

Rival::Rival(const std::string& script, const std::filesystem::path& folder) : script_(script), folder_(folder) {
  setenv("OPENBLAS_NUM_THREADS", "1", 1);
  setenv("OMP_NUM_THREADS", "1", 1);
  const std::string file = std::string(TRIVET_RIVALS) + "/" + script, problem = folder.string();
  const bool octave = script.ends_with(".m");
  std::vector<const char*> arguments = {TRIVET_PYTHON};
  if (octave) arguments = {"octave-cli", "--norc", "--quiet", "--no-history"};
  arguments.insert(arguments.end(), {file.c_str(), problem.c_str(), nullptr});
  int requests[2], replies[2];
  if (pipe(requests) != 0 || pipe(replies) != 0) throw std::runtime_error("no pipe");
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, requests[0], 0);
  posix_spawn_file_actions_adddup2(&actions, replies[1], 1);
  for (const int end : {requests[0], requests[1], replies[0], replies[1]})
    posix_spawn_file_actions_addclose(&actions, end);
  const int failed =
      posix_spawnp(&process_, arguments[0], &actions, nullptr, const_cast<char* const*>(arguments.data()), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(requests[0]);
  close(replies[1]);
  to_ = fdopen(requests[1], "w");
  from_ = fdopen(replies[0], "r");
  if (failed != 0)
    throw std::runtime_error(std::string(arguments[0]) + " cannot be started: scripts/packages benchmarks installs it");
  read();
}

void Rival::read() {
  names_.clear();
  std::istringstream words(ask("names"));
  for (std::string word; words >> word;) names_.insert(word);
}

Rival::~Rival() {
  std::fclose(to_);  // the script ends when its input does
  std::fclose(from_);
  int status = 0;
  waitpid(process_, &status, 0);
}

std::string Rival::ask(const std::string& request) {
  std::fprintf(to_, "%s\n ", request.c_str());  // Octave reads the character after a line before it returns the line
  std::fflush(to_);
  std::string reply;
  for (int c; (c = std::fgetc(from_)) != '\n';) {
    if (c == EOF) throw std::runtime_error(script_ + " ended at '" + request + "'");
    reply += static_cast<char>(c);
  }
  return reply;
}

std::vector<std::complex<double>> Rival::answers(const std::string& name) {
  ask("answer " + name);
  std::ifstream file(folder_ / (name + ".answer"), std::ios::binary | std::ios::ate);
  std::vector<std::complex<double>> values(to_size(file.tellg()) / sizeof(std::complex<double>));
  file.seekg(0);
  file.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(values.size() * sizeof(values[0])));
  return values;
}

Method Rival::method(const std::string& name, std::string label, double items, double goal) {
  ask("time " + name);
  return {std::move(label), [this, name, items] { return std::stod(ask("time " + name)) / items; }, 0, goal};
}

}  // namespace trivet::benchmarks
