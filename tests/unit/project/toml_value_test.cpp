// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <stdexcept>

#include "trivet/project/text/document.h"
#include "trivet/project/text/toml_text.h"

namespace toml_value_test {

using namespace trivet;
using testing::ElementsAre;

project::Node parsed(const std::string& text) {
  const auto node = project::parse_toml(text, "test");
  if (!node) throw std::runtime_error(text + ": " + foundation::message(node.error().list().front()));
  return *node;
}

TEST(TomlValue, IsReadBackWithAllDigits) {
  for (const std::string text :
       {"1", "0.1", "1e+300", "0.30000000000000004", "true", R"("3 kN/m")", R"(["a", [1, 2.5]])",
        R"({loss_factor = 0.1, "two words" = {x = 1}})", "inf", "nan", R"("a \"quote\"\\")"}) {
    const project::Node value = parsed("v = " + text).items.front();
    EXPECT_EQ(project::toml_value(value), text);
  }
}

TEST(SettingWords, AreOneLinePerValueWithTablesInBracesWhole) {
  const project::Node changes =
      parsed("elements.\"front left\".scale = 1.5\nelements.a.damping = {loss_factor = 0.1}\n");
  EXPECT_THAT(project::setting_words({changes}),
              ElementsAre("elements.\"front left\".scale = 1.5", "elements.a.damping = {loss_factor = 0.1}"));
}

}  // namespace toml_value_test
