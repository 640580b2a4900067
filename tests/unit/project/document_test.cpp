// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/document.h"

#include <gmock/gmock.h>

#include "trivet/project/text/toml_text.h"

namespace document_test {

using namespace trivet;

TEST(Deepest, FindsNamesWithDots) {
  const auto document =
      project::parse_toml("[elements.a]\nscale = 1\n\n[elements.\"a.b\"]\nscale = 2\n", "machine.toml");
  ASSERT_TRUE(document);
  EXPECT_EQ(project::deepest(*document, "elements.a.scale").origin.line, 2);
  EXPECT_EQ(project::deepest(*document, "elements.a.b.scale").origin.line, 5);
  EXPECT_EQ(project::deepest(*document, "elements.a.b.at").origin.line, 4);
  EXPECT_EQ(project::deepest(*document, "elements.a.c").origin.line, 1);
}

}  // namespace document_test
