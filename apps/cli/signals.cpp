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

// Of Interruptible: shared with the thread that waits for signals.
constexpr int nothing = 0, a_search = 1, a_study = 2;
std::atomic<int> may_end = nothing;
std::atomic<int> is_asked_by = 0;  ///< number of the signal
std::atomic<bool> study_runs = false;

constexpr timespec most_of_study = {.tv_sec = 2, .tv_nsec = 0};

void say(std::string_view words) { static_cast<void>(!write(STDERR_FILENO, words.data(), words.size())); }

/// Asks what runs to end with what it has. False if the signal ends the program.
bool ask_to_end(int number) {
  int kind = may_end;
  if (kind == nothing || (kind == a_search && number != SIGINT)) return false;
  if (!may_end.compare_exchange_strong(kind, nothing)) return false;
  is_asked_by = number;
  say(kind == a_search ? "\nthe search ends with the best design so far; interrupt again to end at once\n"
                       : "\nthe study ends with what is finished\n");
  return true;
}

/// Waits for the end of a study that was asked to end. @returns the signal that ends the program at once: a second
/// one, or the first again if the study takes too long; 0 if it has ended
int signal_to_end_study(const sigset_t& signals, int first) {
  const int second = sigtimedwait(&signals, nullptr, &most_of_study);
  if (second > 0) return second;
  return study_runs ? first : 0;
}

void wait_and_end(sigset_t signals) {
  int number = 0;
  for (;;) {
    if (sigwait(&signals, &number) != 0) return;
    if (!ask_to_end(number)) break;
    if (!study_runs) continue;
    number = signal_to_end_study(signals, number);
    if (number != 0) break;
  }
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);  // a second signal ends the program by default
  engine::remove_leftovers();
  say(study_runs ? "\ninterrupted; the study folder has what was finished, and the same command goes on\n"
                 : "\ninterrupted; unfinished results are removed, and earlier files are as they were\n");
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
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGUSR1}) {
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

Interruptible::Interruptible(Kind kind) {
  is_asked_by = 0;
  study_runs = kind == Kind::study;
  may_end = study_runs ? a_study : a_search;
}

Interruptible::~Interruptible() {
  may_end = nothing;
  study_runs = false;
}

bool Interruptible::is_to_end() const { return is_asked_by != 0; }

int Interruptible::exit_code() const { return is_asked_by == 0 ? 0 : 128 + is_asked_by; }

}  // namespace trivet::cli
