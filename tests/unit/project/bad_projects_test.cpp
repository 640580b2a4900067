// SPDX-License-Identifier: BSD-3-Clause
// Every file of tests/bad is rejected with the messages in its .expected file.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "trivet/judging/read_project.h"
#include "trivet/project/project.h"

namespace bad_projects_test {

namespace fs = std::filesystem;
using namespace trivet;

class BadProject : public testing::TestWithParam<fs::path> {};

TEST_P(BadProject, IsRejectedWithTheExpectedMessages) {
  setenv("TRIVET_CACHE", "", 1);  // no results of earlier runs
  const auto refused = judging::read_project(GetParam());
  ASSERT_FALSE(refused.has_value()) << "it was accepted";
  std::vector<std::string> messages;
  int errors = 0;
  std::string all;
  for (const auto& problem : refused.error().list()) {
    std::string text = foundation::message(problem);
    const std::size_t folder = text.find(GetParam().parent_path().string() + "/");
    if (folder == 0) text = text.substr(GetParam().parent_path().string().size() + 1);
    errors += problem.severity == foundation::Severity::error;
    all += text + "\n";
    messages.push_back(text);
    EXPECT_FALSE(problem.rule.empty()) << text;
    EXPECT_FALSE(problem.remedy.empty()) << text;
    EXPECT_FALSE(problem.origin.source.empty()) << text;
  }
  std::ifstream expected(fs::path(GetParam()).replace_extension(".expected"));
  ASSERT_TRUE(expected) << "no .expected file next to " << GetParam();
  int lines = 0;
  for (std::string line; std::getline(expected, line);) {
    if (line.empty()) continue;
    ++lines;
    if (line.starts_with("errors: ")) {
      EXPECT_EQ(errors, std::stoi(line.substr(8))) << all;
      continue;
    }
    EXPECT_TRUE(std::ranges::any_of(messages, [&](const std::string& m) { return m.find(line) != std::string::npos; }))
        << "no message holds: " << line << "\nmessages:\n"
        << all;
  }
  EXPECT_GE(lines, 2);
}

std::vector<fs::path> files() {
  std::vector<fs::path> all;
  for (const auto& entry : fs::directory_iterator(std::string(TRIVET_SOURCE_DIR) + "/tests/bad"))
    if (entry.path().extension() == ".toml") all.push_back(entry.path());
  std::ranges::sort(all);
  return all;
}

INSTANTIATE_TEST_SUITE_P(Files, BadProject, testing::ValuesIn(files()), [](const auto& info) {
  std::string name = info.param.stem().string();
  std::ranges::replace_if(name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  return name;
});

TEST(BadProjects, AreAtLeastThreeHundred) { EXPECT_GE(files().size(), 300u); }

}  // namespace bad_projects_test
