// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/csv_table.h"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>

namespace csv_table_test {

using namespace trivet;
using project::columns;
using project::csv_table;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

std::string first_message(const std::string& text) {
  const auto table = csv_table(text, "rig.csv");
  return table ? "a table" : foundation::message(table.error().list().front());
}

TEST(CsvTable, ReadsNumbersUnderTheirNames) {
  const auto table =
      csv_table("\xEF\xBB\xBF# made on the rig\r\nname, x ,\"F, z\"\r\n\r\nup,1e-3,-2.5\r\n# pause\r\ndown,+4,\r\n",
                "rig.csv")
          .value();
  EXPECT_THAT(table.columns, ElementsAre("x", "F, z"));
  EXPECT_THAT(table.names, ElementsAre("up", "down"));
  EXPECT_THAT(table.lines, ElementsAre(4, 6));
  EXPECT_EQ(table.values(0, 0), 1e-3);
  EXPECT_EQ(table.values(0, 1), -2.5);
  EXPECT_EQ(table.values(1, 0), 4);
  EXPECT_TRUE(std::isnan(table.values(1, 1)));
}

TEST(CsvTable, DetectsTheSeparatorInTheHeader) {
  for (const std::string separator : {",", ";", "\t"}) {
    const auto table = csv_table("x" + separator + "y\n1" + separator + "2\n3" + separator + "\n", "rig.csv");
    ASSERT_TRUE(table.has_value());
    EXPECT_EQ(table->values(0, 1), 2);
    EXPECT_TRUE(std::isnan(table->values(1, 1)));
  }
}

TEST(CsvTable, AMissingColumnIsReportedWithTheExistingOnes) {
  const auto table = csv_table("time,displacment,force\n0,0,0\n", "rig.csv").value();
  const auto found = columns(table, {"force", "displacement", "phase"});
  ASSERT_FALSE(found.has_value());
  ASSERT_THAT(found.error().list(), SizeIs(2));
  EXPECT_EQ(
      foundation::message(found.error().list()[0]),
      "rig.csv: error: no column displacement; the columns are: time, displacment, force; did you mean displacment?");
  EXPECT_EQ(columns(table, {"force", "time"})->cols(), 2);
}

TEST(CsvTable, BadRowsAreNamedByLineAllAtOnce) {
  const auto table = csv_table("x;y\n1;2\n1,5;2\n3\n4;5;6\n7;\"8\n1e999;0x10\n", "rig.csv");
  ASSERT_FALSE(table.has_value());
  const auto& list = table.error().list();
  ASSERT_THAT(list, SizeIs(6));
  EXPECT_THAT(foundation::message(list[0]),
              HasSubstr("rig.csv:3: error: x = \"1,5\"; a cell is a finite number with a decimal point"));
  EXPECT_THAT(foundation::message(list[1]), HasSubstr("rig.csv:4: error: 1 cells; the header has 2 columns"));
  EXPECT_THAT(foundation::message(list[2]), HasSubstr("rig.csv:5: error: 3 cells"));
  EXPECT_THAT(foundation::message(list[3]), HasSubstr("rig.csv:6: error: a quote is not closed"));
  EXPECT_THAT(foundation::message(list[4]), HasSubstr("x = \"1e999\""));
  EXPECT_THAT(foundation::message(list[5]), HasSubstr("y = \"0x10\""));
}

TEST(CsvTable, OfASpreadsheetOrADataFrameIsReadWithoutItsFrame) {
  const std::pair<const char*, std::size_t> cases[] = {{"x,y,\n1,2,\n3,4,\n,,\n", 0},
                                                       {"x;y;;\r\n1;2\r\n3;4;;\r\n", 0},
                                                       {",x,y\n0,1,2\n1,3,4\n", 1},
                                                       {"x y\n1 2\n 3  4\n", 0}};
  for (const auto& [text, warnings] : cases) {
    const auto table = csv_table(text, "rig.csv");
    ASSERT_TRUE(table.has_value()) << text << foundation::message(table.error().list().front());
    EXPECT_THAT(table->columns, ElementsAre("x", "y")) << text;
    EXPECT_EQ(table->values, (Eigen::MatrixXd(2, 2) << 1, 2, 3, 4).finished()) << text;
    EXPECT_THAT(table->warnings.list(), SizeIs(warnings)) << text;
  }
  EXPECT_THAT(first_message(",x,y\n7,1,2\n9,3,4\n"), HasSubstr("column 1 has no name"));
}

TEST(CsvTable, WithoutAHeaderIsReadIfItsColumnsAreKnown) {
  const std::vector<std::string> bare = {"time", "value"};
  const std::pair<const char*, double> cases[] = {{"0.00 5.0\n0.02 6.0\n", 0},
                                                  {"0,5\n1,6\n", 0},
                                                  {"0,1\n0.0,5.0\n0.1,6.0\n", 0},
                                                  {",0,1\n0,0.0,5.0\n1,0.1,6.0\n", 0},
                                                  {"-1\t5\n2\t6\n", -1}};
  for (const auto& [text, first] : cases) {
    const auto table = csv_table(text, "a.txt", 10, bare);
    ASSERT_TRUE(table.has_value()) << text << foundation::message(table.error().list().front());
    EXPECT_THAT(table->columns, ElementsAre("time", "value"));
    EXPECT_EQ(table->values.rows(), 2) << text;
    EXPECT_EQ(table->lines.size(), 2u) << text;
    EXPECT_EQ(table->values(0, 0), first) << text;
    EXPECT_EQ(table->values(1, 1), 6) << text;
    EXPECT_FALSE(table->warnings.list().empty()) << text;
  }
  for (const char* text : {"1,2\n0,3\n", "1,2,3\n4,5,6\n", "0,1\n0.5,2.5\n1.5,3.5\n"}) {
    const auto table = csv_table(text, "a.txt", 10, bare);
    ASSERT_FALSE(table.has_value()) << text;
    EXPECT_THAT(foundation::message(table.error().list().front()), HasSubstr("first row")) << text;
    EXPECT_THAT(foundation::message(table.error().list().front()), HasSubstr("time, value")) << text;
  }
}

TEST(CsvTable, NeedsAHeaderAndARow) {
  EXPECT_THAT(first_message(""), HasSubstr("the table is empty"));
  EXPECT_THAT(first_message("\xEF\xBB\xBF\n# only a comment\n"), HasSubstr("the table is empty"));
  EXPECT_THAT(first_message("x,y\n"), HasSubstr("no row below the header"));
  EXPECT_THAT(first_message("1,2\n3,4\n"), HasSubstr("rig.csv:1: error: the first row holds numbers"));
  EXPECT_THAT(first_message("x,x\n3,4\n"), HasSubstr("the column x appears twice"));
  EXPECT_THAT(first_message("x,\n3,4\n"), HasSubstr("column 2 has no name"));
  EXPECT_THAT(first_message("\"x,y\n3,4\n"), HasSubstr("a quote is not closed"));
}

TEST(CsvTable, AFileOfTheWrongKindGivesAtMostFortyMessages) {
  std::string text = "x,y\n";
  for (int i = 0; i < 1000; ++i) text += "a,b\nc\n";
  EXPECT_THAT(csv_table(text, "rig.csv").error().list(), SizeIs(40));
}

TEST(CsvTable, RejectsFilesThatAreNotText) {
  const std::string path = testing::TempDir() + "csv_table_test.csv";
  std::ofstream(path, std::ios::binary) << std::string("x,y\n1,\0\n", 8);
  EXPECT_THAT(foundation::message(project::read_csv_table(path).error().list().front()), HasSubstr("NUL bytes"));
  std::ofstream(path, std::ios::binary) << std::string("    -1\r\n    58b\r\n\0", 17);
  EXPECT_THAT(foundation::message(project::read_csv_table(path).error().list().front()),
              AllOf(HasSubstr("a universal file"), HasSubstr("`history` and `psd` of excitations")));
  std::ofstream(path, std::ios::binary) << "x,y\n1,2\n";
  EXPECT_EQ(project::read_csv_table(path)->values(0, 1), 2);
  std::filesystem::remove(path);
  EXPECT_THAT(foundation::message(project::read_csv_table(path).error().list().front()), HasSubstr("no such file"));
  EXPECT_THAT(foundation::message(project::read_csv_table(testing::TempDir()).error().list().front()),
              HasSubstr("not a file"));
}

TEST(CsvTable, RejectsTwoColumnsCalledName) {
  EXPECT_FALSE(project::csv_table("name,name\na,b\n", "t.csv").has_value());
}

TEST(CsvTable, HasAtMostTwoThousandColumns) {
  std::string header = "c0";
  for (int i = 1; i < 2001; ++i) header += ",c" + std::to_string(i);
  const auto refused = project::csv_table(header + "\n", "t.csv");
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().list().front().finding, "2001 columns");
}

TEST(CsvTable, HasAtMostTheRowsOfItsKind) {
  EXPECT_TRUE(project::csv_table("a\n1\n2\n", "t.csv", 2).has_value());
  const auto refused = project::csv_table("a\n1\n2\n3\n", "t.csv", 2);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().list().front().finding, "more than 2 rows");
}

TEST(CsvTable, HasNamesThatCanBePrinted) {
  const auto refused = project::csv_table("name,a\nM\xFCller,1\n", "t.csv");
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().list().front().finding, "a name holds the byte FC, which is not UTF-8");
  EXPECT_FALSE(project::csv_table("a\x1b\n1\n", "t.csv").has_value());
}

TEST(CsvTable, RejectsNumbersThatVanishInProducts) {
  EXPECT_FALSE(project::csv_table("a\n5e-324\n", "t.csv").has_value());
  EXPECT_FALSE(project::csv_table("a\n1e300\n", "t.csv").has_value());
  EXPECT_TRUE(project::csv_table("a\n1e-30\n", "t.csv").has_value());
}

}  // namespace csv_table_test
