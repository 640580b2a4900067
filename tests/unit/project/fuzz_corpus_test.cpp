// SPDX-License-Identifier: BSD-3-Clause
// Replays inputs that fuzzing found interesting: none may crash, hang or leak.
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string_view>

#include "fuzz/exercise.h"

namespace fuzz_corpus_test {

TEST(FuzzCorpus, NoInputThrows) {
  int files = 0;
  std::set<std::string> roles;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(TRIVET_SOURCE_DIR) + "/tests/fuzz/corpus")) {
    std::ifstream stream(entry.path(), std::ios::binary);
    std::stringstream text;
    text << stream.rdbuf();
    if (text.str().starts_with("#role ")) roles.insert(text.str().substr(6, text.str().find('\n') - 6));
    EXPECT_NO_THROW(trivet::fuzz::exercise(text.str())) << entry.path();
    ++files;
  }
  EXPECT_GT(files, 100);
  for (const std::string_view role : trivet::fuzz::roles())
    if (role != "project") {
      EXPECT_TRUE(roles.contains(std::string(role))) << "the corpus has no " << role;
    }
}

}  // namespace fuzz_corpus_test
