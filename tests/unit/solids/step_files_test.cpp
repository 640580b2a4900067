// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <cstdlib>
#include <fstream>

#include "support/step_shapes.h"
#include "support/stl_shapes.h"
#include "trivet/foundation/temporary_folder.h"
#include "trivet/solids/rigid_solid.h"
#include "trivet/solids/step_file.h"

namespace step_files_test {

using namespace trivet;
using namespace trivet::solids;
using ::testing::AllOf;
using ::testing::HasSubstr;

/// Puts all temporary folders into one folder, where they can be counted.
class StepFile : public ::testing::Test {
 protected:
  StepFile() { setenv("TMPDIR", temporary_.c_str(), 1); }
  ~StepFile() override { unsetenv("TMPDIR"); }

  [[nodiscard]] std::string message_of(const std::filesystem::path& file) const {
    const auto volumes = step_volumes(file);
    EXPECT_TRUE(std::filesystem::is_empty(temporary_)) << "something was left behind";
    return volumes ? "" : message(volumes.error().list().front());
  }

  const foundation::TemporaryFolder folder_;
  const std::filesystem::path temporary_ = [this] {
    std::filesystem::create_directory(folder_.path() / "temporary");
    return folder_.path() / "temporary";
  }();
};

TEST_F(StepFile, RejectsOtherFilesWithoutTraces) {
  test::write_file(folder_.path() / "text.step", "hello, this is not a part\n");
  EXPECT_THAT(message_of(folder_.path() / "text.step"),
              AllOf(HasSubstr("text.step: is not a STEP file"), HasSubstr("ISO-10303-21")));
  test::write_file(folder_.path() / "empty.step", "");
  EXPECT_THAT(message_of(folder_.path() / "empty.step"), HasSubstr("is not a STEP file"));
  EXPECT_THAT(message_of(folder_.path() / "missing.step"), HasSubstr("missing.step: cannot be read"));
  EXPECT_THAT(message_of(folder_.path()), HasSubstr("cannot be read"));
  ASSERT_EQ(mkfifo((folder_.path() / "pipe.step").c_str(), 0600), 0);
  EXPECT_THAT(message_of(folder_.path() / "pipe.step"), HasSubstr("cannot be read"));
}

TEST_F(StepFile, RejectsATruncatedFileInTheWordsOfGmsh) {
  const std::filesystem::path file = folder_.path() / "part.step";
  test::write_step(file, "Cylinder(1) = {0, 0, 0, 0, 0, 25, 25};");
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  EXPECT_THAT(message_of(file),
              AllOf(HasSubstr("part.step: gmsh failed (exit code 1)"), HasSubstr("Could not read file")));
}

TEST_F(StepFile, HasNoSolidIfItHasOnlySurfaces) {
  const std::filesystem::path file = folder_.path() / "part.step";
  test::write_step(file, "Rectangle(1) = {0, 0, 0, 10, 20};");
  EXPECT_THAT(message_of(file), HasSubstr("contains no solid"));
}

TEST_F(StepFile, ReportsThatGmshIsMissing) {
  const std::filesystem::path file = folder_.path() / "part.step";
  test::write_file(file, "ISO-10303-21;\n");
  const std::string path = std::getenv("PATH");
  setenv("PATH", "/nowhere", 1);
  const std::string message = message_of(file);
  setenv("PATH", path.c_str(), 1);
  EXPECT_THAT(message, AllOf(HasSubstr("gmsh is not installed"), HasSubstr("Debian package gmsh")));
}

TEST_F(StepFile, IsReadWithShellCharactersInItsName) {
  const std::filesystem::path file = folder_.path() / "a part\"; Exit; \" $(id) ü.STP";
  test::write_step(file, "Box(1) = {0, 0, 0, 10, 20, 30};");
  EXPECT_EQ(message_of(file), "");
}

TEST_F(StepFile, IsInterruptedWithoutTraces) {
  const std::filesystem::path file = folder_.path() / "part.step";
  test::write_step(file, "Box(1) = {0, 0, 0, 10, 20, 30};");
  EXPECT_THROW((void)step_volumes(file, [](std::string_view, double) { throw foundation::Interrupted(); }),
               foundation::Interrupted);
  EXPECT_TRUE(std::filesystem::is_empty(temporary_));
}

TEST_F(StepFile, GivesItsSolidsByNumber) {
  const std::filesystem::path file = folder_.path() / "parts.step";
  test::write_step(file, "Box(1) = {0, 0, 0, 10, 20, 30};\nBox(2) = {100, 0, 0, 1, 1, 1};");
  const auto second = rigid_solid({{"small", StepSolid{file, {2}}, 1e6}});
  ASSERT_TRUE(second);
  constexpr double round_off = 1e-15;  // [kg] 1e-12 of a box of 1 mm
  EXPECT_NEAR(second->properties.mass, 1e-3, round_off);
  const auto third = rigid_solid({{"none", StepSolid{file, {3}}, 1e6}});
  ASSERT_FALSE(third);
  EXPECT_THAT(message(third.error().list().front()),
              AllOf(HasSubstr("none.solids: 3"), HasSubstr("numbered from 1 to 2")));
  const auto twice = rigid_solid({{"twice", StepSolid{file, {1, 1}}, 1e6}});
  ASSERT_FALSE(twice);
  EXPECT_THAT(message(twice.error().list().front()), HasSubstr("twice.solids: 1 is named twice"));
}

}  // namespace step_files_test
