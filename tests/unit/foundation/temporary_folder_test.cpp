// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/temporary_folder.h"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <system_error>

#include "trivet/foundation/child_process.h"

namespace temporary_folder_test {

namespace fs = std::filesystem;
using namespace trivet::foundation;

/// Makes a temporary folder in `parent` in a process that is then killed.
void leave_one_behind(const fs::path& parent) {
  const pid_t child = fork();
  if (child == 0) {
    const TemporaryFolder folder(parent);
    std::ofstream(folder.path() / "file") << "text";
    kill(getpid(), SIGKILL);
  }
  ASSERT_GT(child, 0);
  waitpid(child, nullptr, 0);
}

TEST(TemporaryFolders, AreRemovedAfterTheirProcessWasKilled) {
  const TemporaryFolder parent;
  leave_one_behind(parent.path());
  const auto count = [&] { return std::distance(fs::directory_iterator(parent.path()), fs::directory_iterator()); };
  EXPECT_EQ(count(), 2);  // the parent's mark and the remains
  const TemporaryFolder living(parent.path());
  EXPECT_EQ(count(), 2);
  EXPECT_TRUE(fs::exists(living.path()));
  const TemporaryFolder next(parent.path());
  EXPECT_TRUE(fs::exists(living.path())) << "its owner lives";
}

TEST(TemporaryFolders, AreRemovedOnlyIfTheyHaveTheMark) {
  const TemporaryFolder parent;
  const fs::path lookalike = parent.path() / ".trivet-aaaaaaaaaaaaaaaaaaaa",
                 linked = parent.path() / ".trivet-bbbbbbbbbbbbbbbbbbbb", elsewhere = parent.path() / "elsewhere";
  fs::create_directory(lookalike);
  std::ofstream(lookalike / "note") << "mine";
  fs::create_directory(elsewhere);
  std::ofstream(elsewhere / owner_mark);
  fs::create_symlink(elsewhere, linked);
  remove_abandoned_folders(parent.path());
  EXPECT_TRUE(fs::exists(lookalike / "note"));
  EXPECT_TRUE(fs::exists(elsewhere / owner_mark));
}

TEST(TemporaryFolders, AreRemovedWithoutFollowingLinks) {
  const TemporaryFolder outside;
  std::ofstream(outside.path() / "file") << "text";
  {
    const TemporaryFolder folder;
    fs::create_directory_symlink(outside.path(), folder.path() / "link");
  }
  EXPECT_TRUE(fs::exists(outside.path() / "file"));
}

TEST(TemporaryFolders, AreAccessibleToTheirOwnerOnly) {
  const TemporaryFolder folder;
  EXPECT_EQ(fs::status(folder.path()).permissions(), fs::perms::owner_all);
}

TEST(TemporaryFolders, NeedAPlace) { EXPECT_THROW(TemporaryFolder(fs::path("/no/such/folder")), std::system_error); }

TEST(ChildProcessOfAKilledOwner, EndsWithAllProcessesThatItStarted) {
  const TemporaryFolder folder;
  const pid_t owner = fork();
  if (owner == 0) {
    Command command{.program = "/bin/sh",
                    .arguments = {"-c", "sleep 1000 & echo $! > inner; echo $$ > outer; mv outer begun; sleep 1000"}};
    command.folder = folder.path();
    static_cast<void>(run(command));
    _exit(0);
  }
  ASSERT_GT(owner, 0);
  for (int waited = 0; !fs::exists(folder.path() / "begun") && waited < 20000; ++waited) usleep(1000);
  ASSERT_TRUE(fs::exists(folder.path() / "begun"));
  kill(owner, SIGKILL);
  waitpid(owner, nullptr, 0);
  for (const char* name : {"begun", "inner"}) {
    pid_t process = 0;
    std::ifstream(folder.path() / name) >> process;
    ASSERT_GT(process, 0);
    const auto lives = [&] {  // a zombie that init has not yet reaped has also ended
      std::ifstream status("/proc/" + std::to_string(process) + "/stat");
      std::string number, command, state;
      return static_cast<bool>(status >> number >> command >> state) && state != "Z" && state != "X";
    };
    int waited = 0;
    while (lives() && ++waited < 20000) usleep(1000);
    EXPECT_FALSE(lives()) << name;
  }
}

}  // namespace temporary_folder_test
