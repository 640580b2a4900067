// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/temporary_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

namespace trivet::foundation {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz234567";  // 32: five random bits choose one
constexpr std::size_t random_letters = 20;                                // 100 bits
constexpr int most_attempts = 100;

std::string random_name() {
  std::array<std::uint8_t, random_letters> bytes;
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw std::system_error(errno, std::generic_category(), "no random numbers");
  std::string name(temporary_name_start);
  for (const std::uint8_t byte : bytes) name += letters[byte % letters.size()];
  return name;
}

bool is_such_a_name(const std::string& name) {
  return name.size() == temporary_name_start.size() + random_letters && name.starts_with(temporary_name_start) &&
      name.find_first_not_of(letters, temporary_name_start.size()) == std::string::npos;
}

/// Opens the mark inside a folder that is not a link and, if `must_be_ours`, belongs to this user. Returns -1 with
/// errno on failure.
int open_mark(const fs::path& folder, int flags, bool must_be_ours) {
  const int opened = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (opened < 0) return -1;
  struct stat status;
  const bool ours = fstat(opened, &status) == 0 && (!must_be_ours || status.st_uid == geteuid());
  const int mark = ours ? openat(opened, owner_mark, O_RDWR | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK | flags, 0600) : -1;
  const int reason = ours ? errno : EPERM;
  close(opened);
  errno = reason;
  return mark;
}

/// Another process may have removed the folder as abandoned before its owner had the lock.
bool still_there(int mark) {
  struct stat status;
  return fstat(mark, &status) == 0 && status.st_nlink > 0;
}

void remove_if_abandoned(const fs::path& folder) {
  const int mark = open_mark(folder, 0, true);
  if (mark < 0) {
    if (errno == ENOENT) rmdir(folder.c_str());  // killed before it made its mark; removes only an empty folder
    return;
  }
  struct stat status;
  if (fstat(mark, &status) == 0 && S_ISREG(status.st_mode) && flock(mark, LOCK_EX | LOCK_NB) == 0 && still_there(mark))
    remove_marked_folder(folder);
  close(mark);
}

/// Creates the folder and its mark. Returns -1 if another name must be tried.
int make(const fs::path& folder) {
  if (mkdir(folder.c_str(), 0700) != 0) {
    if (errno == EEXIST) return -1;
    throw std::system_error(errno, std::generic_category(), folder.parent_path().string());
  }
  const int mark = open_mark(folder, O_CREAT | O_EXCL, false);  // some file systems assign it to another user
  if (mark < 0) {
    if (errno == ENOENT) return -1;
    const int reason = errno;
    rmdir(folder.c_str());
    throw std::system_error(reason, std::generic_category(), folder.parent_path().string());
  }
  // On a file system without locks the folder works, but remains if this process is killed.
  const bool taken = flock(mark, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  if (!taken && still_there(mark)) return mark;
  close(mark);
  return -1;
}

fs::path system_place() {
  const char* given = std::getenv("TMPDIR");
  std::error_code ignored;
  const fs::path place = given && *given ? given : "/tmp";
  const fs::path absolute = fs::absolute(place, ignored);
  return absolute.empty() ? place : absolute;
}

}  // namespace

void remove_abandoned_folders() { remove_abandoned_folders(system_place()); }

void remove_abandoned_folders(const fs::path& parent) {
  std::error_code error;
  for (fs::directory_iterator entry(parent, error), end; !error && entry != end; entry.increment(error))
    if (is_such_a_name(entry->path().filename().string())) remove_if_abandoned(entry->path());
}

TemporaryFolder::TemporaryFolder() try : TemporaryFolder(system_place()) {
} catch (const std::system_error& error) {
  throw std::runtime_error(
      fmt::format("cannot create a temporary folder in {}: {}; set TMPDIR to a folder with write permission",
                  system_place().string(), error.code().message()));
}

TemporaryFolder::TemporaryFolder(const fs::path& parent) {
  remove_abandoned_folders(parent);
  for (int i = 0; mark_ < 0; ++i) {
    if (i == most_attempts) throw std::system_error(EEXIST, std::generic_category(), parent.string());
    const Undisturbed step;
    path_ = parent / random_name();
    mark_ = make(path_);
    if (mark_ >= 0) registered_.emplace(path_, RegisteredFolder::Removal::with_contents);
  }
}

TemporaryFolder::~TemporaryFolder() {
  const Undisturbed step;
  remove_marked_folder(path_);
  close(mark_);
}

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
