// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/documents/text_table.h"

#include <gmock/gmock.h>

namespace text_table_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;
using trivet::documents::FittedTable;
using trivet::documents::TextTable;

FittedTable fitted(std::size_t screen, const std::vector<std::string>& header, const std::vector<std::string>& row,
                   std::size_t together = 1, std::size_t rows = 1) {
  TextTable table(header, together, screen);
  for (std::size_t i = 0; i < rows; ++i) table.add(row);
  return table.fitted(std::vector<bool>(header.size(), false));
}
constexpr std::size_t many = 50;  // more than are shown in parts below each other

TEST(FittedTable, HasAllColumnsIfTheyFit) {
  // two characters before the first column, three between columns
  const FittedTable found = fitted(10, {"a", "b"}, {"12", "345"});
  EXPECT_EQ(found.text, "   a     b\n  12   345\n");
  EXPECT_THAT(found.left_out, IsEmpty());
}

TEST(FittedTable, ShowsOtherColumnsBelowIfThatTakesFewLines) {
  const FittedTable found = fitted(11, {"a", "b", "c", "d", "e"}, {"1", "2", "3", "4", "5"});
  EXPECT_EQ(found.text, "  a   b   c\n  1   2   3\n\n  a   d   e\n  1   4   5\n");
  EXPECT_THAT(found.left_out, IsEmpty());
}

TEST(FittedTable, IsABlockForEachRowIfTheFirstColumnDoesNotNameIt) {
  TextTable table({"force", "along", "isolation"}, 1, 18);
  table.add({"rotor", "y", "0.9"});
  table.add({"rotor", "z", "0.8"});
  EXPECT_EQ(table.fitted({false, false, false}).text,
            "  force: rotor\n    along: y\n    isolation: 0.9\n  force: rotor\n    along: z\n    isolation: 0.8\n");
}

TEST(FittedTable, LeavesOutColumnsFromTheRightAndNamesThem) {
  const FittedTable found = fitted(9, {"a", "b", "c"}, {"1", "2", "3"}, 1, many);
  EXPECT_THAT(found.text, StartsWith("  a   b\n  1   2\n"));
  EXPECT_THAT(found.text, Not(HasSubstr("3")));
  EXPECT_THAT(found.left_out, ElementsAre("c"));
}

TEST(FittedTable, KeepsWordsInTheLastColumn) {
  const std::vector<std::string> header = {"a", "b", "c", "verdict"}, row = {"1", "2", "3", "VIOLATED"};
  EXPECT_EQ(fitted(18, header, row).text, "  a   b   verdict\n  1   2   VIOLATED\n\n  a   c\n  1   3\n");
  const FittedTable found = fitted(18, header, row, 1, many);
  EXPECT_THAT(found.text, StartsWith("  a   b   verdict\n  1   2   VIOLATED\n  1 "));
  EXPECT_THAT(found.left_out, ElementsAre("c"));
}

TEST(FittedTable, DoesNotSeparateAmplitudeAndPhase) {
  const std::vector<std::string> header = {"f", "|x|", "phase", "|y|", "phase"}, row = {"1", "2", "3", "4", "5"};
  EXPECT_THAT(fitted(17, header, row, 2, many).left_out, ElementsAre("|y|", "phase"));
  EXPECT_THAT(fitted(17, header, row, 2).text, HasSubstr("\n\n  f   |y|   phase\n  1     4       5\n"));
  EXPECT_EQ(fitted(16, {"f", "|x|", "phase"}, {"1", "2", "3"}, 2).text, "  f: 1\n    |x|: 2\n    phase: 3\n");
}

TEST(FittedTable, DoesNotSeparateAValueAndItsCase) {
  const std::vector<std::string> header = {"name", "least", "in", "largest", "in"},
                                 row = {"x", "-1", "cold", "2", "hot"};
  EXPECT_EQ(fitted(24, header, row, 2).text,
            "  name   least   in\n  x         -1   cold\n\n  name   largest   in\n  x            2   hot\n");
}

TEST(FittedTable, IsABlockForEachRowIfNothingFitsBesideTheFirstColumn) {
  const FittedTable found = fitted(12, {"name", "remark"}, {"left", "a long remark"});
  EXPECT_EQ(found.text, "  name: left\n    remark: a long remark\n");
  EXPECT_THAT(found.left_out, IsEmpty());
}

TEST(FittedTable, CountsCharactersNotBytes) { EXPECT_THAT(fitted(10, {"ω", "φ"}, {"µµ", "πππ"}).left_out, IsEmpty()); }

}  // namespace text_table_test
