// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/files/result_exchange.h"

#include <gmock/gmock.h>

#include <fstream>
#include <iterator>

#include "trivet/foundation/temporary_folder.h"
#include "trivet/results/files/users_files.h"

namespace result_exchange_test {

namespace fs = std::filesystem;
using namespace trivet::foundation;
using namespace trivet::results;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

/// An earlier result in "current", with files of the user, and the following result in "next".
class ResultExchangeTest : public ::testing::Test {
 protected:
  ResultExchangeTest() {
    for (const char* name : {"current/00-base", "current/01-gone", "current/mine/deep", "next/00-base", "next/02-new"})
      fs::create_directories(root_ / name);
    for (const char* path : {"00-base/modes.csv", "00-base/peaks.csv", "01-gone/modes.csv", "results.json"})
      write_ours("current", path, "old", ours_);
    for (const char* path : {"00-base/modes.csv", "02-new/modes.csv", "results.json"})
      write_ours("next", path, "new", next_ours_);
    write("current/manifest.json", ours_.text());
    write("next/manifest.json", next_ours_.text());
    write("current/note", "note");
    write("current/00-base/note", "inner note");
    write("current/00-base/modes.csv", "edited");
    write("current/mine/deep/data", "data");
    write("current/02-new", "a file where the next result has a folder");
    fs::create_symlink("/etc", root_ / "current/link");
  }

  void write(const std::string& path, const std::string& text) const { std::ofstream(root_ / path) << text; }
  [[nodiscard]] std::string text_of(const std::string& path) const {
    std::ifstream stream(root_ / path);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  }
  void write_ours(const std::string& folder, const std::string& path, const std::string& text,
                  ResultManifest& manifest) const {
    write(folder + "/" + path, text);
    manifest.add(path, text);
  }
  [[nodiscard]] std::vector<std::string> files_in(const std::string& folder) const {
    std::vector<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(root_ / folder))
      if (!entry.is_directory() || entry.is_symlink())
        files.push_back(entry.path().lexically_relative(root_ / folder).string());
    return files;
  }
  void expect_the_next_result_with_the_users_files() const {
    EXPECT_THAT(
        files_in("current"),
        UnorderedElementsAre("00-base/modes.csv", "00-base/modes.kept-1.csv", "00-base/note", "02-new/modes.csv",
                             "02-new.kept-1", "results.json", "manifest.json", "note", "mine/deep/data", "link"));
    EXPECT_EQ(text_of("current/00-base/modes.csv"), "new");
    EXPECT_EQ(text_of("current/00-base/modes.kept-1.csv"), "edited");
    EXPECT_EQ(text_of("current/00-base/note"), "inner note");
    EXPECT_EQ(text_of("current/manifest.json"), next_ours_.text());
    EXPECT_EQ(fs::read_symlink(root_ / "current/link"), "/etc");
    EXPECT_FALSE(fs::exists(root_ / "current/01-gone"));
  }

  const trivet::foundation::TemporaryFolder folder_;
  const fs::path root_ = folder_.path();
  ResultManifest ours_, next_ours_;
  std::vector<std::string> notes_;
};

TEST_F(ResultExchangeTest, InOneStepKeepsTheUsersFiles) {
  const FolderHandle place(root_), current(root_ / "current"), next(root_ / "next");
  ASSERT_TRUE(exchange_folders({current, ours_, next, next_ours_}, place, "next", place, "current", notes_))
      << "the file system of the test has no exchange of folders";
  expect_the_next_result_with_the_users_files();
  EXPECT_THAT(notes_,
              ElementsAre("00-base/modes.csv was changed since trivet wrote it; it is kept as 00-base/modes.kept-1.csv",
                          "02-new was not written by trivet, and its name was needed; it is kept as 02-new.kept-1"));
}

TEST_F(ResultExchangeTest, FileByFileGivesTheSame) {
  const FolderHandle current(root_ / "current"), next(root_ / "next");
  replace_one_by_one({current, ours_, next, next_ours_}, notes_);
  expect_the_next_result_with_the_users_files();
  EXPECT_EQ(notes_.size(), 2u);
}

TEST_F(ResultExchangeTest, FilesAddedMeanwhileAreMoved) {
  const FolderHandle current(root_ / "current"), next(root_ / "next");
  UsersFiles users(current, ours_);
  ASSERT_TRUE(users.link_into(next));
  fs::create_directories(root_ / "current/late/folder");
  write("current/late/folder/file", "late");
  write("current/01-gone/late", "late too");
  fs::remove(root_ / "current/note");
  write("current/note", "written again");
  EXPECT_TRUE(users.move_latecomers_into(next));
  EXPECT_EQ(text_of("next/late/folder/file"), "late");
  EXPECT_EQ(text_of("next/01-gone/late"), "late too");
  EXPECT_EQ(text_of("next/note"), "note");
  EXPECT_EQ(text_of("next/note.kept-1"), "written again");
  EXPECT_FALSE(fs::exists(root_ / "next/01-gone/modes.csv"));
}

TEST(ResultManifestTest, RejectsPathsThatLeaveTheFolder) {
  const trivet::foundation::TemporaryFolder folder;
  const auto read = [&](const std::string& path) {
    std::ofstream(folder.path() / manifest_name)
        << "{\"format\":\"trivet-manifest\",\"files\":[{\"path\":\"" + path + "\",\"size\":1,\"sha256\":\"0\"}]}";
    return ResultManifest::read(FolderHandle(folder.path()));
  };
  for (const char* path : {"../a", "/a", "a/../b", "a//b", "", ".", "..", "a/"}) EXPECT_FALSE(read(path)) << path;
  ASSERT_TRUE(read("00-base/a"));
  EXPECT_TRUE(read("00-base/a")->names_folder("00-base"));
  EXPECT_FALSE(read("00-base/a")->names_folder("00"));
}

}  // namespace result_exchange_test
