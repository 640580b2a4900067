// SPDX-License-Identifier: BSD-3-Clause
// Every file of tests/samples, at least one per element law, is read without errors and has its element.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "trivet/judging/read_project.h"
#include "trivet/project/elements/element_law.h"
#include "trivet/project/project.h"

namespace sample_projects_test {

namespace fs = std::filesystem;
using namespace trivet;

class SampleProject : public testing::TestWithParam<fs::path> {};

TEST_P(SampleProject, IsReadWithItsElement) {
  setenv("TRIVET_CACHE", "", 1);  // no results of earlier runs
  const auto project = judging::read_project(GetParam());
  std::string all;
  if (!project)
    for (const auto& problem : project.error().list()) all += foundation::message(problem) + "\n";
  ASSERT_TRUE(project.has_value()) << all;
  EXPECT_EQ(project->base().system.elements().size(), 1u);
}

std::vector<fs::path> files() {
  std::vector<fs::path> all;
  for (const auto& entry : fs::directory_iterator(std::string(TRIVET_SOURCE_DIR) + "/tests/samples"))
    if (entry.path().extension() == ".toml") all.push_back(entry.path());
  std::ranges::sort(all);
  return all;
}

TEST(SampleProjects, ContainEveryElementLaw) {
  std::string all;
  for (const fs::path& file : files()) {
    std::ifstream text(file);
    all.append(std::istreambuf_iterator<char>(text), {});
  }
  for (const project::ElementLaw* law : project::element_laws()) {
    const std::string type = law->type;
    EXPECT_THAT(all, testing::HasSubstr("type = \"" + type.substr(0, type.find(':')))) << "tests/samples has none";
  }
}

INSTANTIATE_TEST_SUITE_P(Files, SampleProject, testing::ValuesIn(files()),
                         [](const auto& info) { return info.param.stem().string(); });

}  // namespace sample_projects_test
