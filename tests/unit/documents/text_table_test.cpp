// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/documents/text_table.h"

#include <gmock/gmock.h>

namespace text_table_test {

using testing::ElementsAre;
using testing::IsEmpty;
using trivet::documents::FittedTable;
using trivet::documents::TextTable;

FittedTable fitted(std::size_t screen, std::vector<std::string> header, std::vector<std::string> row,
                   std::size_t together = 1) {
  const std::vector<bool> none(header.size(), false);
  TextTable table(std::move(header), together, screen);
  table.add(std::move(row));
  return table.fitted(none);
}

TEST(FittedTable, HasAllColumnsIfTheyFit) {
  // two characters before the first column, three between columns
  const FittedTable found = fitted(10, {"a", "b"}, {"12", "345"});
  EXPECT_EQ(found.text, "   a     b\n  12   345\n");
  EXPECT_THAT(found.left_out, IsEmpty());
}

TEST(FittedTable, LeavesOutColumnsFromTheRightAndNamesThem) {
  const FittedTable found = fitted(9, {"a", "b", "c"}, {"1", "2", "3"});
  EXPECT_EQ(found.text, "  a   b\n  1   2\n");
  EXPECT_THAT(found.left_out, ElementsAre("c"));
}

TEST(FittedTable, KeepsWordsInTheLastColumn) {
  const FittedTable found = fitted(18, {"a", "b", "c", "verdict"}, {"1", "2", "3", "VIOLATED"});
  EXPECT_EQ(found.text, "  a   b   verdict\n  1   2   VIOLATED\n");
  EXPECT_THAT(found.left_out, ElementsAre("c"));
}

TEST(FittedTable, DoesNotSeparateAmplitudeAndPhase) {
  EXPECT_THAT(fitted(17, {"f", "|x|", "phase", "|y|", "phase"}, {"1", "2", "3", "4", "5"}, 2).left_out,
              ElementsAre("|y|", "phase"));
  EXPECT_EQ(fitted(16, {"f", "|x|", "phase"}, {"1", "2", "3"}, 2).text, "  f: 1\n    |x|: 2\n    phase: 3\n");
}

TEST(FittedTable, IsABlockForEachRowIfNothingFitsBesideTheFirstColumn) {
  const FittedTable found = fitted(12, {"name", "remark"}, {"left", "a long remark"});
  EXPECT_EQ(found.text, "  name: left\n    remark: a long remark\n");
  EXPECT_THAT(found.left_out, IsEmpty());
}

TEST(FittedTable, CountsCharactersNotBytes) { EXPECT_THAT(fitted(10, {"ω", "φ"}, {"µµ", "πππ"}).left_out, IsEmpty()); }

}  // namespace text_table_test
