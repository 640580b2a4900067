// SPDX-License-Identifier: BSD-3-Clause
#include "cli/shown_page.h"

#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>

namespace trivet::cli {

std::string show_page(const std::string& file) {
  const char* chosen = std::getenv("BROWSER");
  std::string program = chosen && *chosen != '\0' ? chosen : "xdg-open", path = file;
  posix_spawnattr_t attributes;
  sigset_t none, ours;
  sigemptyset(&none);
  sigemptyset(&ours);
  for (const int number : {SIGPIPE, SIGXFSZ}) sigaddset(&ours, number);
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setsigmask(&attributes, &none);  // this program blocks and ignores signals for itself alone
  posix_spawnattr_setsigdefault(&attributes, &ours);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  char* words[] = {program.data(), path.data(), nullptr};
  pid_t child = 0;
  const int failure = posix_spawnp(&child, program.c_str(), nullptr, &attributes, words, environ);
  posix_spawnattr_destroy(&attributes);
  if (failure != 0)
    return program + ": " + std::strerror(failure) + (chosen ? "" : "; set BROWSER to the program that shows pages");
  int state = 0;
  while (waitpid(child, &state, 0) < 0)
    if (errno != EINTR) return program + ": " + std::strerror(errno);
  if (WIFEXITED(state) && WEXITSTATUS(state) == 0) return "";
  return program + " failed" + (chosen ? "" : "; set BROWSER to the program that shows pages");
}

}  // namespace trivet::cli
