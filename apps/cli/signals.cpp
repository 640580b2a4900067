// SPDX-License-Identifier: BSD-3-Clause
#include "cli/signals.h"

#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <string_view>
#include <system_error>
#include <thread>

#include "trivet/engine/program.h"

namespace trivet::cli {
namespace {

// Of InterruptibleSearch: shared with the thread that waits for signals.
std::atomic<bool> search_may_end = false, search_is_to_end = false;

void say(std::string_view words) { static_cast<void>(!write(STDERR_FILENO, words.data(), words.size())); }

void wait_and_end(sigset_t signals) {
  int number = 0;
  for (;;) {
    if (sigwait(&signals, &number) != 0) return;
    if (number != SIGINT || !search_may_end.exchange(false)) break;
    search_is_to_end = true;
    say("\nthe search ends with the best design so far; interrupt again to end at once\n");
  }
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);  // a second signal ends the program by default
  engine::remove_leftovers();
  say("\ninterrupted; unfinished results are removed, and earlier files are as they were\n");
  _exit(128 + number);
}

bool is_ignored(int number) {
  struct sigaction now;
  return sigaction(number, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

}  // namespace

void end_cleanly_on_signals() {
  for (const int number : {SIGPIPE, SIGXFSZ})
    signal(number, SIG_IGN);  // a closed pipe and a full quota are detected when writing
  sigset_t signals;
  sigemptyset(&signals);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    if (number == SIGHUP && is_ignored(number)) continue;
    signal(number, SIG_DFL);
    sigaddset(&signals, number);
  }
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);  // in every thread started from now on
  try {
    std::thread(wait_and_end, signals).detach();
  } catch (const std::system_error&) {  // no thread available: a signal then ends the program by default, and the next
                                        // run cleans up
    pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
  }
}

InterruptibleSearch::InterruptibleSearch() {
  search_is_to_end = false;
  search_may_end = true;
}
InterruptibleSearch::~InterruptibleSearch() { search_may_end = false; }

bool InterruptibleSearch::is_to_end() const { return search_is_to_end; }

}  // namespace trivet::cli
