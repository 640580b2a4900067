// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <fstream>
#include <system_error>

#include "trivet/foundation/child_process.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/temporary_folder.h"

namespace child_process_test {

using namespace trivet::foundation;
using ::testing::HasSubstr;

Command shell(const std::string& script) { return {.program = "/bin/sh", .arguments = {"-c", script}}; }

TEST(ChildProcess, ReturnsTheOutputOfBothStreamsAndTheExitCode) {
  const CommandOutcome outcome = run(shell("echo said; echo complained >&2; exit 7"));
  EXPECT_EQ(outcome.end, CommandOutcome::End::exited);
  EXPECT_EQ(outcome.code, 7);
  EXPECT_FALSE(outcome.succeeded());
  EXPECT_EQ(outcome.output, "said\ncomplained\n");
}

TEST(ChildProcess, ArgumentsReachTheProgramUnchanged) {
  const Command command{.program = "/bin/echo", .arguments = {"$(id) ; rm -rf 'x y' \"*\"", "ü"}};
  EXPECT_EQ(run(command).output, "$(id) ; rm -rf 'x y' \"*\" ü\n");
}

TEST(ChildProcess, RunsInItsFolderWithItsEnvironmentAndWithoutInput) {
  const TemporaryFolder folder;
  Command command = shell("pwd; echo $COLOUR; cat; echo end");
  command.folder = folder.path();
  command.environment = {"COLOUR=green"};
  EXPECT_EQ(run(command).output, folder.path().string() + "\ngreen\nend\n");
}

TEST(ChildProcess, ALongOutputKeepsItsEnd) {
  const CommandOutcome outcome =
      run(shell("i=0; while [ $i -lt 20000 ]; do echo 'a line of fifty letters, one of very many lines....'; "
                "i=$((i+1)); done; echo last"));
  EXPECT_TRUE(outcome.succeeded());
  EXPECT_LE(outcome.output.size(), 512u * 1024u);
  EXPECT_TRUE(outcome.output.ends_with("last\n"));
}

TEST(ChildProcess, ASignalIsNotAnExitCode) {
  const CommandOutcome outcome = run(shell("kill -SEGV $$"));
  EXPECT_EQ(outcome.end, CommandOutcome::End::signalled);
  EXPECT_EQ(outcome.code, 11);
}

TEST(ChildProcess, WaitsForAProgramThatClosedItsOutput) {
  EXPECT_EQ(run(shell("exec >/dev/null 2>&1; sleep 0.2; exit 3")).code, 3);
}

TEST(ChildProcess, IsEndedAtItsTimeLimit) {
  Command command = shell("sleep 1000");
  command.time_limit = 0.2;
  EXPECT_EQ(run(command).end, CommandOutcome::End::time_limit);
  command.time_limit = 0;
  EXPECT_THROW((void)run(command), InvalidInput);
}

TEST(ChildProcess, IsEndedIfItPrintsForEver) {
  const Command command{.program = "/bin/sh", .arguments = {"-c", "yes"}};
  const CommandOutcome outcome = run(command);
  EXPECT_EQ(outcome.end, CommandOutcome::End::endless_output);
  EXPECT_LE(outcome.output.size(), 512u * 1024u);
  EXPECT_EQ(how_it_ended(outcome, command), "ended after 100 MB of messages");
}

TEST(ChildProcess, AnInterruptionEndsTheProgramAndWhatItStarted) {
  const TemporaryFolder folder;
  Command command = shell("(sleep 0.5; touch survived) & echo begun > begun; sleep 1000");
  command.folder = folder.path();
  const auto stop_once_begun = [&](std::string_view, double) {
    if (std::filesystem::exists(folder.path() / "begun")) throw Interrupted();
  };
  EXPECT_THROW((void)run(command, stop_once_begun), Interrupted);
  EXPECT_EQ(run(shell("sleep 0.8")).code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "survived"));
}

TEST(ChildProcess, AMissingProgramIsReported) {
  EXPECT_FALSE(program_on_path("no-such-program-of-trivet"));
  EXPECT_TRUE(program_on_path("sh"));
  EXPECT_THROW((void)run({.program = "/no/such/program"}), std::system_error);
}

TEST(TemporaryFolder, IsRemovedWithItsContentsAfterAnException) {
  std::filesystem::path kept;
  try {
    const TemporaryFolder folder;
    kept = folder.path();
    std::ofstream(kept / "file") << "text";
    throw Interrupted();
  } catch (const Interrupted&) {
  }
  EXPECT_FALSE(kept.empty());
  EXPECT_FALSE(std::filesystem::exists(kept));
}

}  // namespace child_process_test
