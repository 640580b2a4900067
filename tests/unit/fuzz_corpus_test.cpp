// SPDX-License-Identifier: BSD-3-Clause
// Replays what fuzzing found interesting: no input may crash, hang or leak.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "trivet/study/project.h"

namespace {

TEST(FuzzCorpus, EveryInputIsReadOrRefused) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(TRIVET_SOURCE_DIR) + "/tests/fuzz/corpus")) {
    std::ifstream stream(entry.path(), std::ios::binary);
    std::stringstream text;
    text << stream.rdbuf();
    const auto project = trivet::study::project_from_text(text.str(), "fuzz");
    EXPECT_TRUE(project.has_value() || project.error().has_errors()) << entry.path();
    ++files;
  }
  EXPECT_GT(files, 100);
}

}  // namespace
