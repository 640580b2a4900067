// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <system_error>

namespace trivet::foundation {
namespace {

constexpr int group_poll_milliseconds = 10;  // if the kernel has no file descriptors of processes

void require(bool success, const char* what) {
  if (!success) throw std::system_error(errno, std::generic_category(), what);
}

struct Program {
  const char* path;
  char* const* arguments;
  char* const* environment;
  const char* folder;
};

/// Descriptors that the guard keeps open, and `ends_of_owner`, which it must close to detect the end of its owner. All
/// others are closed too, because they would keep pipes of other threads open.
struct Descriptors {
  int output, report, lifeline;
  std::array<int, 2> ends_of_owner;
};

// From here to `guard`, only functions that are safe between fork and exec in a process with threads are allowed (man 7
// signal-safety).

void close_others(const Descriptors& kept) {
  std::array<int, 3> sorted{kept.output, kept.report, kept.lifeline};
  std::ranges::sort(sorted);
  for (const int descriptor : kept.ends_of_owner) close(descriptor);
  unsigned int from = 0;
  bool closed = true;
  for (const int descriptor : sorted) {
    const unsigned int number = static_cast<unsigned int>(descriptor);
    if (number > from) closed = syscall(SYS_close_range, from, number - 1, 0) == 0 && closed;
    from = number + 1;
  }
  closed = syscall(SYS_close_range, from, ~0u, 0) == 0 && closed;
  if (closed) return;
  constexpr int most_descriptors = 4096;  // for kernels before 5.9 and sandboxes without the call
  for (int descriptor = 0; descriptor < most_descriptors; ++descriptor)
    if (!std::ranges::binary_search(sorted, descriptor)) close(descriptor);
}

[[noreturn]] void become(const Program& program, const Descriptors& open_ones, pid_t guard) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != guard) _exit(127);  // the guard was killed before the line above
  // Numbers above the standard descriptors, which may have been closed when we were started.
  const int output = fcntl(open_ones.output, F_DUPFD_CLOEXEC, 3), report = fcntl(open_ones.report, F_DUPFD_CLOEXEC, 3);
  close(0);
  bool ready =
      output >= 0 && report >= 0 && open("/dev/null", O_RDONLY) == 0 && dup2(output, 1) == 1 && dup2(output, 2) == 2;
  if (ready && program.folder) ready = chdir(program.folder) == 0;
  if (ready) {
    for (int number = 1; number < NSIG; ++number) signal(number, SIG_DFL);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    execve(program.path, program.arguments, program.environment);
  }
  const ProgramEnd end{.start_error = errno};
  static_cast<void>(!write(report, &end, sizeof end));
  _exit(127);
}

/// Waits for the end of the program or of its owner. Does not reap the program, so that its number is not reused.
void wait_for_either(pid_t program, int lifeline) {
  const int handle = static_cast<int>(syscall(SYS_pidfd_open, program, 0));
  for (;;) {
    std::array<pollfd, 2> ends{pollfd{lifeline, POLLIN, 0}, pollfd{handle, POLLIN, 0}};
    poll(ends.data(), ends.size(), handle < 0 ? group_poll_milliseconds : -1);
    siginfo_t info{};
    if (ends[0].revents != 0) return;
    if (waitid(P_PID, static_cast<id_t>(program), &info, WEXITED | WNOHANG | WNOWAIT) != 0 || info.si_pid == program)
      return;
  }
}

[[noreturn]] void guard(const Program& program, const Descriptors& open_ones) {
  setpgid(0, 0);             // a signal to our group (Ctrl-C, a time limit) must not end the guard first
  signal(SIGCHLD, SIG_DFL);  // if it was ignored, the kernel would reap the program and its exit code would be lost
  close_others(open_ones);
  const pid_t own = getpid();
  const pid_t child = fork();
  if (child == 0) become(program, open_ones, own);
  ProgramEnd end{.start_error = child < 0 ? errno : 0};
  close(open_ones.output);
  if (child > 0) {
    setpgid(child, child);  // also here: whichever process runs first
    wait_for_either(child, open_ones.lifeline);
    kill(-child, SIGKILL);
    kill(child, SIGKILL);
    while (waitpid(child, &end.status, 0) < 0 && errno == EINTR) {
    }
  }
  static_cast<void>(!write(open_ones.report, &end, sizeof end));
  _exit(0);
}

/// Blocks all signals to the guard: it must outlive us until it has killed the program.
class BlockedSignals {
 public:
  BlockedSignals() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~BlockedSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  BlockedSignals(const BlockedSignals&) = delete;
  BlockedSignals& operator=(const BlockedSignals&) = delete;

 private:
  sigset_t before_;
};

}  // namespace

GuardedProgram::GuardedProgram(const char* path, char* const* arguments, char* const* environment, const char* folder,
                               int output) {
  std::array<int, 2> report, lifeline;
  require(pipe2(report.data(), O_CLOEXEC) == 0, "pipe");
  if (pipe2(lifeline.data(), O_CLOEXEC) != 0) {
    const int reason = errno;
    for (const int descriptor : report) close(descriptor);
    throw std::system_error(reason, std::generic_category(), "pipe");
  }
  const Undisturbed step;
  pid_t child = 0;
  {
    const BlockedSignals blocked;
    child = fork();
    if (child == 0)
      guard({path, arguments, environment, folder}, {output, report[1], lifeline[0], {report[0], lifeline[1]}});
  }
  const int reason = errno;
  close(report[1]);
  close(lifeline[0]);
  if (child < 0) {
    close(report[0]);
    close(lifeline[1]);
    throw std::system_error(reason, std::generic_category(), "fork");
  }
  fcntl(report[0], F_SETFL, O_NONBLOCK);
  report_ = report[0];
  registered_ = std::make_unique<RegisteredProgram>(child, lifeline[1]);
}

GuardedProgram::~GuardedProgram() {
  registered_.reset();
  close(report_);
}

bool GuardedProgram::has_ended(ProgramEnd& end) {
  ProgramEnd found;
  const ssize_t count = read(report_, &found, sizeof found);
  if (count < 0 && (errno == EAGAIN || errno == EINTR)) return false;
  // Without a report the guard itself was killed, and the kernel has killed the program.
  end = count == static_cast<ssize_t>(sizeof found) ? found : ProgramEnd{.status = SIGKILL};
  return true;
}

}  // namespace trivet::foundation
