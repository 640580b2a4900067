// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/leftovers.h"

#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <cerrno>
#include <exception>
#include <system_error>

namespace trivet::foundation {
namespace {

namespace fs = std::filesystem;

/// Attempts: a thread that is still writing can add a file between the removal of the files and that of their folder.
constexpr int most_removals = 1000;
constexpr long pause_nanoseconds = 1'000'000;

struct Registry {
  std::recursive_mutex mutex;
  std::list<RegisteredFolder::Folder> folders;
  std::list<RegisteredProgram::Program> programs;
};

/// Never destroyed: a signal can arrive while the program ends.
Registry& registry() {
  static Registry* const all = new Registry;
  return *all;
}

void wait_for(pid_t guard) {
  while (waitpid(guard, nullptr, 0) < 0 && errno == EINTR) {
  }
}

void remove_insistently(const fs::path& folder) {
  for (int i = 0; i < most_removals && !remove_marked_folder(folder); ++i) {
    const timespec pause{0, pause_nanoseconds};
    nanosleep(&pause, nullptr);
  }
}

}  // namespace

RegisteredFolder::RegisteredFolder(const fs::path& path, Removal removal) {
  const Undisturbed step;
  place_ = registry().folders.insert(registry().folders.end(), {path, removal});
}

RegisteredFolder::~RegisteredFolder() {
  const Undisturbed step;
  registry().folders.erase(place_);
}

RegisteredProgram::RegisteredProgram(int guard, int lifeline) {
  const Undisturbed step;
  place_ = registry().programs.insert(registry().programs.end(), {guard, lifeline});
}

RegisteredProgram::~RegisteredProgram() {
  const Undisturbed step;
  close(place_->lifeline);
  wait_for(place_->guard);
  registry().programs.erase(place_);
}

Undisturbed::Undisturbed() : lock_(registry().mutex) {}

bool remove_marked_folder(const fs::path& folder) noexcept {
  try {
    std::error_code error;
    bool all_gone = true;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
      if (entry->path().filename() == owner_mark) continue;
      std::error_code kept;
      fs::remove_all(entry->path(), kept);
      all_gone = all_gone && !kept;
    }
    if (!error && all_gone) {
      fs::remove(folder / owner_mark, error);
      fs::remove(folder, error);
    }
    return !fs::exists(fs::symlink_status(folder, error));
  } catch (const std::exception&) {  // out of memory for a path
    return false;
  }
}

void remove_leftovers() noexcept {
  registry().mutex.lock();  // never unlocked: what is removed here must not be created again
  for (const auto& program : registry().programs) close(program.lifeline);
  for (const auto& program : registry().programs) wait_for(program.guard);
  for (auto folder = registry().folders.rbegin(); folder != registry().folders.rend(); ++folder)
    if (folder->removal == RegisteredFolder::Removal::with_contents) remove_insistently(folder->path);
    else rmdir(folder->path.c_str());
}

}  // namespace trivet::foundation
