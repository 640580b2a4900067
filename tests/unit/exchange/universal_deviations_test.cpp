// SPDX-License-Identifier: BSD-3-Clause
// Universal files that deviate from the standard: what is read with a warning, and what is an error.
#include <gtest/gtest.h>

#include <complex>
#include <limits>

#include "trivet/exchange/text/file_bytes.h"
#include "unit/exchange/universal_texts.h"

namespace trivet::test {
namespace universal_deviations_test {

using exchange::UniversalFunction;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using Complex = std::complex<double>;

const std::vector<double> four_numbers{1, -2, 3, 4};

void expect_four_numbers(const std::string& text, double unit = 1) {
  const UniversalFunction function = function_of(text);
  EXPECT_THAT(function.values, ElementsAre(unit * Complex(1, -2), unit * Complex(3, 4)));
}

std::string with_crlf(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '\n' ? std::string("\r\n") : std::string(1, c);
  return result;
}

TEST(UniversalText, MayHaveLineEndsOfWindowsAndNumbersOfFortran) {
  const std::string text = universal({.values = " 1.0D0 -.2D+01 3.0 40.0-001\n"});
  for (const std::string& each : {text, with_crlf(text)}) {
    expect_four_numbers(each);
    EXPECT_EQ(warnings(each), "");
  }
}

TEST(UniversalText, MayHaveNumbersWithoutBlanksInColumns) {
  const std::string glued = universal({.values = "1.00000E+0000-2.0000E+0000 3.00000E+000 4.00000E+000\n"});
  expect_four_numbers(glued);
  EXPECT_THAT(warnings(glued), HasSubstr("f:14: warning: set 1 (type 58), values: numbers without blanks"));
  const std::string small = universal({.form = "         6         1         0          0.0          0.0          0.0",
                                       .values = "  1.00000E+01-1.234567890123E-101-1.234567890123E-102\n"});
  EXPECT_EQ(function_of(small).values.at(0), Complex(-1.234567890123e-101, -1.234567890123e-102));
  const std::string without_e = universal({.values = "  1.0000-0101  -2.0000+001       3.0000    4.0000000\n"});
  EXPECT_EQ(function_of(without_e).values.at(0), Complex(1e-101, -20));
}

TEST(UniversalText, MayHaveAnyNumberOfValuesPerLineAndZerosAfterTheLast) {
  expect_four_numbers(universal({.values = "1\n-2\n\n3 4\n"}));
  expect_four_numbers(universal({.values = "            1.0\n           -2.0\n            3.0\n            4.0\n"}));
  const std::string filled = universal({.values = "1. -2. 3. 4. 0. 0.\n"});
  expect_four_numbers(filled);
  EXPECT_THAT(warnings(filled), HasSubstr("2 zeros too many"));
}

TEST(UniversalText, MayLackIdLines) {
  const std::string three = universal({.ids = "Receptance\nNONE\n28-Jan-21 14:01:42\n"});
  expect_four_numbers(three, 1e-6);
  EXPECT_THAT(warnings(three), HasSubstr("id lines: 3 of 5"));
  EXPECT_EQ(function_of(three).ids[2], "28-Jan-21 14:01:42");
  EXPECT_EQ(function_of(universal({.ids = ""})).ids[0], "");
  const std::string blank = universal({.ids = "a\n\n\n      \nb\n"});
  EXPECT_THAT(function_of(blank).ids, ElementsAre("a", "", "", "", "b"));
  EXPECT_THAT(warnings(blank), HasSubstr("f:4: warning: set 1 (type 58), blank id line"));
  EXPECT_THAT(warnings(blank), Not(HasSubstr("f:5:")));  // once per kind and set
}

TEST(UniversalText, MayHaveALongNameOfAnEntity) {
  const std::string shifted =
      universal({.place = "    4        25    1         0 PF-I-0301y1        12  -3       NONE         7   3"});
  EXPECT_EQ(function_of(shifted).response.entity, "PF-I-0301y1");
  EXPECT_EQ(function_of(shifted).response.node, 12);
  EXPECT_EQ(function_of(shifted).reference.direction, 3);
  EXPECT_THAT(warnings(shifted), HasSubstr("read by the blanks between them"));
  const std::string node_in_wrong_columns =
      universal({.place = "    4        25    1         0 PF-I-0301y1         2   3 NONE               7   3"});
  EXPECT_EQ(function_of(node_in_wrong_columns).response.node, 2);
  EXPECT_EQ(function_of(node_in_wrong_columns).reference.node, 7);
  const std::string name_of_two_words =
      universal({.place = "    4         1    0         0 MOTOR  1          12  -3 RIG                7   3"});
  EXPECT_EQ(function_of(name_of_two_words).response.entity, "MOTOR  1");
  EXPECT_EQ(warnings(name_of_two_words), "");
}

TEST(UniversalText, MayHaveTextsInOtherAlphabets) {
  const UniversalFunction utf8 =
      function_of(universal({.numerator = "         8    0    0    0 Größe µm²            mm"}));
  EXPECT_EQ(utf8.numerator.label, "Größe µm²");
  EXPECT_EQ(utf8.numerator.stated.label, "mm");
  const UniversalFunction full =
      function_of(universal({.numerator = "         8    0    0    0 Größe der Höhe x y z mm"}));
  EXPECT_EQ(full.numerator.label, "Größe der Höhe x y z");
  EXPECT_EQ(full.numerator.stated.label, "mm");
  const UniversalFunction latin = function_of(universal({.ids = "Gr\xF6\xDF"
                                                                "e\tA\nNONE\nNONE\nNONE\nNONE\n"}));
  EXPECT_EQ(latin.ids[0], "Größe A");
}

TEST(UniversalSets, MayHaveDelimitersInOtherColumns) {
  const std::string text = universal({.end = "-1\n"}) + "  -1\n    58" + universal({}).substr(13);
  const auto read = read_text(text);
  ASSERT_TRUE(read) << complaint(read);
  EXPECT_EQ(read->file.functions.size(), 2u);
  EXPECT_THAT(warnings(text),
              AllOf(HasSubstr("f:15: warning: set 1 (type 58), delimiter: -1 is in other columns"),
                    HasSubstr("f:16: warning: set 2 (type 58), delimiter")));
}

TEST(UniversalSets, OfCoordinateSystemsMayHaveDelimitersInOtherColumns) {
  const std::string node = universal_set(15, "  5  0  0  0  1. 2. 3.\n");
  for (const auto& [type, lines] :
       {std::pair{18, "         7         0         0         8         1\nS\n  0. 0. 0. 0. 0. 1.\n -1. 0. 0.\n"},
        {2420, "         1\nPart\n         7         0         2\nS\n  1 0 0\n  0 1 0\n  0 0 1\n  0 0 0\n"}}) {
    const std::string text = fmt::format("    -1\n{:6d}\n{}-1\n", type, lines) + node;
    EXPECT_EQ(content(text).nodes.size(), 1u) << type;
    EXPECT_THAT(warnings(text), HasSubstr(fmt::format("warning: set 1 (type {}), delimiter", type)));
  }
}

TEST(UniversalSets, MayLackADelimiter) {
  const std::string one_between = universal({.end = ""}) + universal({});
  EXPECT_EQ(content(one_between).functions.size(), 2u);
  EXPECT_THAT(warnings(one_between), HasSubstr("set 2 (type 58): one line with -1 before it"));
  const std::string no_end = universal({.end = ""});
  expect_four_numbers(no_end, 1e-6);
  EXPECT_THAT(warnings(no_end), HasSubstr("f:2: warning: set 1 (type 58), end: no closing line with -1"));
  const std::string nodes = "    -1\n    15\n         1         0         0         0  1.0  2.0  3.0\n";
  EXPECT_EQ(content(nodes).nodes.size(), 1u);
  EXPECT_THAT(warnings(nodes), HasSubstr("was the file cut off?"));
}

TEST(UniversalSets, OfOtherTypesEndWithADelimiterLikeTheirFirst) {
  const std::string text = "   -1\n  2499\n      -1\nx\n   -1\n" + universal({});
  EXPECT_EQ(content(text).functions.size(), 1u);
  EXPECT_THAT(warnings(text), HasSubstr("f:5: warning: set 1 (type 2499), delimiter"));
}

TEST(UniversalSets, OfOtherTypesAndCommentsAreIgnoredWithOneWarningEach) {
  const std::string text = "comment\n" + universal_set(2499, "         1\n        -1\n") + universal_set(19, "x\n") +
      universal_set(19, "") + "another\n" + universal({});
  EXPECT_EQ(content(text).functions.size(), 1u);
  EXPECT_THAT(warnings(text),
              AllOf(HasSubstr("f: warning: sets: 19 (2×), 2499; sets 15, 18"),
                    HasSubstr("f:1: warning: lines between sets: \"comment\""), Not(HasSubstr("another"))));
}

TEST(UniversalSets, OfGeometryMayDeviateHarmlessly) {
  const std::string more = universal_set(82, "         1         2         0\nNONE\n         1         2         3\n");
  EXPECT_THAT(content(more).lines.at(0).nodes, ElementsAre(1, 2, 3));
  EXPECT_THAT(warnings(more), HasSubstr("2 announced, 3 found"));
  const std::string glued =
      universal_set(15, "         1         0         0         1-1.00000E-010-2.00000E-010-3.00000E-010\n");
  EXPECT_EQ(content(glued).nodes.at(0).position, Eigen::Vector3d(-1e-10, -2e-10, -3e-10));
  EXPECT_FALSE(content(universal_set(15, "  5  3  0  0  1. 2. 3.\n")).nodes.at(0).position_known);
}

/// Set 58b with the four numbers in double precision, and what follows them.
std::string binary(const std::string& type, const std::string& end, const std::string& bytes) {
  return universal({.type = type,
                    .form = "         6         2         1  5.00000E+00  5.00000E-01  0.00000E+00",
                    .values = bytes,
                    .end = end});
}

TEST(UniversalBinary, MayHaveBothByteOrdersAndPrecisions) {
  for (const bool big : {false, true}) {
    const std::string doubles = bytes_of<double>(four_numbers, big);
    expect_four_numbers(binary(binary_type(big ? 2 : 1, 2, 32), "    -1\n", doubles));
    EXPECT_EQ(warnings(binary(binary_type(big ? 2 : 1, 2, 32), "    -1\n", doubles)), "");
    const std::string floats =
        universal({.type = binary_type(big ? 2 : 1, 2, 16), .values = bytes_of<float>(four_numbers, big)});
    expect_four_numbers(floats);
  }
}

TEST(UniversalBinary, MayEndInSeveralWays) {
  const std::string bytes = bytes_of<double>(four_numbers);
  const std::string next = universal({.values = "1 2 3 4\n"});
  for (const char* end : {"    -1\n", "    -1\r\n", "    -1                    \n"}) {
    EXPECT_EQ(content(binary(binary_type(1, 2, 32), end, bytes) + next).functions.size(), 2u);
    EXPECT_EQ(warnings(binary(binary_type(1, 2, 32), end, bytes)), "");
  }
  for (const char* end : {"\n    -1\n", "\n-1\n"}) {
    EXPECT_EQ(content(binary(binary_type(1, 2, 32), end, bytes) + next).functions.size(), 2u);
    EXPECT_THAT(warnings(binary(binary_type(1, 2, 32), end, bytes)), HasSubstr("delimiter"));
  }
  for (const char* end : {"    -1", "", "\r\n"}) expect_four_numbers(binary(binary_type(1, 2, 32), end, bytes));
  // The head ends its lines with LF; the end mark stands between CRLF.
  for (const char* end : {"\r\n    -1\r\n", "    -1\r\n"})
    EXPECT_EQ(content(binary(binary_type(1, 2, 32), end, bytes) + next).functions.size(), 2u);
  // A lost byte of CRLF, or of the values, is noticed.
  EXPECT_FALSE(read_text(binary(binary_type(1, 2, 32), "\r\n    -1\r\n", bytes.substr(1))));
  EXPECT_THAT(warnings(binary(binary_type(1, 2, 32), "", bytes)), HasSubstr("no closing line with -1"));
}

TEST(UniversalBinary, FindsItsEndByTheNumberOfPointsOrOfBytes) {
  const std::string bytes = bytes_of<double>(four_numbers);
  for (const std::size_t stated : {0u, 16u, 31u, 4096u}) {
    const std::string text = binary(binary_type(1, 2, stated), "    -1\n", bytes);
    expect_four_numbers(text);
    EXPECT_THAT(warnings(text), HasSubstr(fmt::format("bytes: {} stated; 2 points have 32 bytes", stated)));
  }
  expect_four_numbers(binary("    58b     1     2          11", "    -1\n", bytes));
  for (const int points : {1, 3, 1000000000}) {
    const std::string text =
        universal({.type = binary_type(1, 2, 32),
                   .form = fmt::format("{:10d}{:10d}{:10d}{:13.5E}{:13.5E}{:13.5E}", 6, points, 1, 5.0, 0.5, 0.0),
                   .values = bytes});
    expect_four_numbers(text);
    EXPECT_THAT(warnings(text), HasSubstr(fmt::format("points: {} announced", points)));
  }
}

TEST(UniversalBinary, MayHaveUpperCaseInItsType) {
  std::string type = binary_type(1, 2, 32);
  type[6] = 'B';
  expect_four_numbers(binary(type, "    -1\n", bytes_of<double>(four_numbers)));
  EXPECT_THAT(warnings(binary(type, "    -1\n", bytes_of<double>(four_numbers))), HasSubstr("read as 58b"));
}

TEST(UniversalBinary, HasAbscissasInSinglePrecision) {
  const std::string text = universal({.type = binary_type(1, 2, 24),
                                      .form = "         5         2         0          0.0          0.0          0.0",
                                      .values = bytes_of<float>({10.1, 1, 2, 33.3, 3, 4})});
  EXPECT_THAT(abscissa_values(function_of(text)), ElementsAre(10.1f, 33.3f));
}

struct WrongFile {
  std::string text;
  const char* complaint;
};

std::string form(int type, double points, int spacing, double step) {
  return fmt::format("{:10d}{:10.0f}{:10d}{:13.5E}{:13.5E}{:13.5E}", type, points, spacing, 5.0, step, 0.0);
}

TEST(UniversalErrors, NameTheFileTheSetAndTheLine) {
  const WrongFile cases[] = {
      {"", "f: error: universal file: no line with -1"},
      {"hello\nworld\n", "f: error: universal file: no line with -1"},
      {"    -1\n", "no set after a line with -1"},
      {"    -1\nhello\n    -1\n", "f:2: error: set 1: \"hello\""},
      {universal({.form = form(3, 2, 1, 0.5)}), "f:9: error: set 1 (type 58), ordinate type: 3"},
      {universal({.form = form(5, 2, 1, 0)}),
       "f:9: error: set 1 (type 58), step: 0; the step of an even abscissa is > 0"},
      {universal({.form = form(5, 2, 1, -0.5)}), "step: -0.5"},
      {universal({.form = form(5, 2, 2, 0.5)}), "f:9: error: set 1 (type 58), record 7"},
      {universal({.form = form(5, 0, 1, 0.5)}), "points: 0"},
      {universal({.form = form(5, -2, 1, 0.5)}), "points: -2"},
      {universal({.form = form(5, 1e9, 1, 0.5)}),
       "f:9: error: set 1 (type 58), points: 1000000000 announced; the set has"},
      {universal({.form = form(5, 3, 1, 0.5)}), "values: 4 numbers; 3 points with 2 numbers each are announced"},
      {universal({.form = form(5, 1, 1, 0.5)}), "values: more than announced"},
      {universal({.form = form(5, 2, 1, 0.5) + "nan"}), "record 7"},
      {universal({.place = "    4 x"}), "f:8: error: set 1 (type 58), record 6"},
      {universal({.numerator = "         8    0   99    0"}), "f:11: error: set 1 (type 58), record 9"},
      {universal({.values = " 1.0 2.0 3.0 nan\n"}), "f:14: error: set 1 (type 58), values: \"nan\""},
      {universal({.values = " 1.0 2.0 3.0 ****\n"}), "f:14: error: set 1 (type 58), values: \"****\""},
      {universal({.values = " 1.0 2.0 3.0 1.0E+999\n"}), "values: \"1.0E+999\""},
      {universal({.form = form(2, 2, 0, 0), .values = " 2.0 1.0 2.0 1.0\n"}),
       "f:9: error: set 1 (type 58), abscissa: 2 at point 2 after 2; times and frequencies increase"},
      {universal({.values = " 1.0 2.0\n", .end = ""}),
       "values: 2 numbers; 2 points with 2 numbers each are announced; was the file"},
      {universal({.values = " 1.0 2.0 3.0000000\n", .end = ""}), "values: 3 numbers; 2 points with 2 numbers each"},
      {universal({.values = " 1.0 2.0 3.0 4.0", .end = ""}),
       "f:2: error: set 1 (type 58), end: the file ends within a"},
      {"    -1\n    58\na\nb\n", "head: 2 lines; eleven lines precede the values; was the file cut off?"},
      {universal_set(15, "         1         0         0         0  1.0  2.0\n"), "f:3: error: set 1 (type 15), node"},
      {universal_set(15, "        -1         0         0         0  1.0  2.0 3.0\n"), "set 1 (type 15), node"},
      {universal_set(15, "         1         0         0         0  1.0  2.0 inf\n"), "set 1 (type 15), node"},
      {universal_set(82, "         1         3         0\nNONE\n         1         2\n"),
       "nodes: 3 announced, 2 found"},
      {universal_set(82, "         1         3         0\nNONE\n         1        -2\n"),
       "f:5: error: set 1 (type 82)"},
      {universal_set(82, "x\n"), "f:3: error: set 1 (type 82), trace line"},
      {units_set(9, 0, 1), "f:4: error: set 1 (type 164), factors"},
      {units_set(9, -1, 1), "set 1 (type 164), factors: -1, 1, 1, 273.15"},
      {units_set(9, 1, 1e300), "factors"},
      {universal_set(164, "         1SI\n"), "factors"},
  };
  for (const WrongFile& wrong : cases)
    EXPECT_THAT(complaint(read_text(wrong.text)), HasSubstr(wrong.complaint)) << wrong.text;
}

TEST(UniversalErrors, OfModesNameTheRecord) {
  const std::string ids = "NONE\nNONE\nNONE\nNONE\nNONE\n";
  const std::string definition = "         1         2         2         8         2         3\n";
  const std::string numbers = "         2         4         0         1\n", values = " 1. 2. 0.1 0.\n";
  const WrongFile cases[] = {
      {ids + "x\n", "f:8: error: set 1 (type 55), record 6: \"x\""},
      {ids, "record 6"},
      {ids + definition + "x\n", "f:9: error: set 1 (type 55), record 7"},
      {ids + definition + "         2        99\n", "record 7"},
      {ids + definition + numbers, "record 8: 0 numbers; 4 are announced"},
      {ids + definition + numbers + " 1. nan 0. 0.\n", "f:10: error: set 1 (type 55), values: \"nan\""},
      {ids + definition + numbers + values + "x\n", "f:11: error: set 1 (type 55), node: \"x\""},
      {ids + definition + numbers + values + "         7\n 1. 2.\n", "node 7: 2 numbers; 3 are announced"},
      {ids + definition + numbers + values + "         7\n 1. 2. 3. 4.\n", "node 7: 4 numbers; 3 are announced"},
  };
  for (const WrongFile& wrong : cases)
    EXPECT_THAT(complaint(read_text(universal_set(55, wrong.text))), HasSubstr(wrong.complaint)) << wrong.text;
}

TEST(UniversalErrors, OfBinarySetsAreClear) {
  const std::string bytes = bytes_of<double>(four_numbers);
  const WrongFile cases[] = {
      {binary(binary_type(1, 1, 32), "    -1\n", bytes),
       "f:2: error: set 1 (type 58b), number format: numbers of a VAX"},
      {binary(binary_type(1, 3, 32), "    -1\n", bytes), "numbers of an IBM mainframe"},
      {binary(binary_type(7, 2, 32), "    -1\n", bytes), "byte order"},
      {binary("    58b", "    -1\n", bytes), "number format"},
      {binary("    55b", "    -1\n", bytes), "only set 58 has a binary form"},
      {binary(binary_type(1, 2, 32), "    -1\n", bytes.substr(1)),
       "points: 2 announced, 32 bytes stated; a closing line"},
      {binary(binary_type(1, 2, 32), "", bytes.substr(0, 20)),
       "the file ends after at most 1 points; was the file cut"},
      {universal({.type = binary_type(1, 2, 32), .form = form(6, 1e9, 1, 0.5), .values = bytes.substr(1)}),
       "f:9: error: set 1 (type 58b), points: 1000000000 announced, 32 bytes stated"},
      {binary(binary_type(1, 2, 32), "    -1\n", bytes_of<double>({1, 2, std::numeric_limits<double>::infinity(), 4})),
       "values: point 2 is inf; every number is finite"},
  };
  for (const WrongFile& wrong : cases) EXPECT_THAT(complaint(read_text(wrong.text)), HasSubstr(wrong.complaint));
}

TEST(UniversalErrors, SayWhichFileCannotBeRead) {
  EXPECT_THAT(complaint(exchange::read_universal("/no/such/file.unv")), HasSubstr("universal file: no such file"));
  EXPECT_THAT(complaint(exchange::read_universal(TRIVET_SOURCE_DIR)), HasSubstr("this is a directory"));
}

TEST(UniversalReader, SurvivesEveryTruncationAndEveryChangedByte) {
  for (const char* name : {"inch_units.unv", "pyuff_binary.unv", "without_blanks.unv", "big_endian_wrong_bytes.unv"}) {
    const auto whole = exchange::file_bytes(std::string(TRIVET_SOURCE_DIR) + "/tests/data/universal/" + name);
    ASSERT_TRUE(whole);
    for (std::size_t at = 0; at < whole->size(); ++at) {
      std::string changed = *whole;
      changed[at] = static_cast<char>(changed[at] ^ 0x15);
      static_cast<void>(read_text(whole->substr(0, at)));
      static_cast<void>(read_text(changed));
    }
  }
}

}  // namespace universal_deviations_test
}  // namespace trivet::test
