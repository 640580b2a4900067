// SPDX-License-Identifier: BSD-3-Clause
// Matrix Market, NumPy and CSV files, written by SciPy and NumPy and by hand.
#include <gtest/gtest.h>

#include "support/matchers.h"
#include "support/matrix_files.h"
#include "trivet/exchange/matrix_formats.h"
#include "trivet/exchange/text/file_bytes.h"
#include "trivet/exchange/text/text_lines.h"

namespace trivet::test {
namespace matrix_files_test {

using exchange::NamedMatrix;
using testing::AllOf;
using testing::HasSubstr;

/// The other program computed the entries with some operations in a different order.
constexpr double round_off = 8 * epsilon;
/// The Matrix Market files have 16 decimals.
constexpr double printed = 1e-15;

std::string file_content(const std::string& name) {
  return *exchange::file_bytes(std::string(TRIVET_SOURCE_DIR) + "/tests/data/matrices/" + name);
}

void expect_bar(const foundation::Expected<NamedMatrix>& read, double tolerance,
                const Eigen::MatrixXd& added = Eigen::MatrixXd::Zero(12, 12)) {
  ASSERT_TRUE(read) << complaint(read);
  const Eigen::MatrixXd wanted = bernoulli() + added;
  EXPECT_THAT(read->values, NearInUnits(wanted, entry_scale(bernoulli()), tolerance));
  EXPECT_TRUE(read->labels.empty());
}

/// Ones on and above the diagonal: shows an exchange of rows and columns.
Eigen::MatrixXd upper_ones() { return Eigen::MatrixXd::Ones(12, 12).triangularView<Eigen::Upper>(); }

TEST(MatrixMarket, IsReadInAllFormsThatScipyWrites) {
  expect_bar(exchange::read_matrix_market(file_content("beam_coordinate_symmetric.mtx"), "f"), printed);
  expect_bar(exchange::read_matrix_market(file_content("beam_coordinate_general.mtx"), "f"), printed);
  expect_bar(exchange::read_matrix_market(file_content("beam_array_symmetric.mtx"), "f"), printed);
  expect_bar(exchange::read_matrix_market(file_content("beam_array_general.mtx"), "f"), printed, upper_ones());
}

/// One matrix in all forms that its symmetry allows, by hand.
TEST(MatrixMarket, IsReadInAllLegalForms) {
  struct Form {
    const char* text;
    Eigen::Matrix2d real, imaginary;
  };
  const auto matrix = [](double a, double b, double c, double d) { return Eigen::Matrix2d{{a, b}, {c, d}}; };
  const Form forms[] = {
      {"coordinate real general\n2 2 3\n1 1 1\n2 1 2\n1 2 3\n", matrix(1, 3, 2, 0), {}},
      {"coordinate double symmetric\n2 2 2\n1 1 1.5D+03\n2 1 -2.5d-1\n", matrix(1500, -0.25, -0.25, 0), {}},
      {"coordinate unsigned-integer symmetric\n% a\n\n2 2 1\n  %b\n2\t1 +7  \n\n", matrix(0, 7, 7, 0), {}},
      {"coordinate real skew-symmetric\n2 2 1\n2 1 4\n", matrix(0, -4, 4, 0), {}},
      {"coordinate real hermitian\n2 2 2\n1 1 1\n2 1 4\n", matrix(1, 4, 4, 0), {}},
      {"coordinate complex hermitian\n2 2 2\n1 1 1 0\n2 1 4 5\n", matrix(1, 4, 4, 0), matrix(0, -5, 5, 0)},
      {"coordinate complex symmetric\n2 2 2\n1 1 1 2\n2 1 4 5\n", matrix(1, 4, 4, 0), matrix(2, 5, 5, 0)},
      {"coordinate complex skew-symmetric\n2 2 1\n2 1 4 5\n", matrix(0, -4, 4, 0), matrix(0, -5, 5, 0)},
      {"array real general\n2 2\n1\n2\n3\n4\n", matrix(1, 3, 2, 4), {}},
      {"array integer symmetric\n2 2\n1\n2\n4\n", matrix(1, 2, 2, 4), {}},
      {"array real skew-symmetric\n2 2\n1.D0\n", matrix(0, -1, 1, 0), {}},
      {"array complex hermitian\n2 2\n1 0\n2 3\n4 0\n", matrix(1, 2, 2, 4), matrix(0, -3, 3, 0)},
  };
  for (const Form& form : forms) {
    const auto read = exchange::read_matrix_market(std::string("%%MatrixMarket matrix ") + form.text, "f");
    ASSERT_TRUE(read.has_value()) << form.text << complaint(read);
    EXPECT_EQ(read->values, form.real) << form.text;
    const bool is_complex = std::string(form.text).find("complex") != std::string::npos;
    EXPECT_EQ(read->imaginary.size(), is_complex ? 4 : 0) << form.text;
    if (is_complex) {
      EXPECT_EQ(read->imaginary, form.imaginary) << form.text;
    }
  }
  const std::string head = "%%MatrixMarket matrix ";
  EXPECT_THAT(complaint(exchange::read_matrix_market(head + "array real skew-symmetric\n2 2\n1\n2\n", "f")),
              HasSubstr("more than"));
  EXPECT_THAT(complaint(exchange::read_matrix_market(head + "coordinate real skew-symmetric\n2 2 1\n1 1 3\n", "f")),
              HasSubstr("the diagonal of a skew-symmetric matrix is 0"));
  EXPECT_THAT(complaint(exchange::read_matrix_market(head + "coordinate complex hermitian\n1 1 1\n1 1 3 1\n", "f")),
              HasSubstr("the diagonal of a hermitian matrix is real"));
  EXPECT_THAT(complaint(exchange::read_matrix_market(head + "coordinate pattern general\n1 1 1\n1 1\n", "f")),
              HasSubstr("a pattern has no values"));
}

TEST(MatrixMarket, KeepsTheImaginaryPart) {
  const auto read = exchange::read_matrix_market(file_content("beam_complex.mtx"), "f");
  expect_bar(read, printed);
  const Eigen::MatrixXd wanted = 0.02 * bernoulli();
  EXPECT_THAT(read->imaginary, NearInUnits(wanted, entry_scale(wanted), printed));
}

TEST(MatrixMarket, AcceptsCommentsBlankLinesAndWindowsLineEnds) {
  const auto read = exchange::read_matrix_market(
      "%%MatrixMarket Matrix Coordinate Integer General\r\n% by hand\r\n\r\n2 2 2\r\n1 1 3\r\n\r\n2 2 -4\r\n", "f");
  ASSERT_TRUE(read) << complaint(read);
  EXPECT_EQ(read->values(0, 0), 3);
  EXPECT_EQ(read->values(1, 1), -4);
}

TEST(NumpyArray, IsReadInEveryVersionAndOrder) {
  for (const char* name : {"beam.npy", "beam_version_2.npy", "beam_version_3.npy", "beam_complex.npy"})
    expect_bar(exchange::read_numpy_array(file_content(name), "f"), round_off);
  expect_bar(exchange::read_numpy_array(file_content("beam_by_columns.npy"), "f"), round_off, upper_ones());
  const auto lossy = exchange::read_numpy_array(file_content("beam_complex.npy"), "f");
  const Eigen::MatrixXd wanted = 0.02 * bernoulli();
  EXPECT_THAT(lossy->imaginary, NearInUnits(wanted, entry_scale(wanted), round_off));
}

TEST(CsvMatrix, IsReadWithCommasSemicolonsTabsAndBlanks) {
  expect_bar(exchange::read_csv_matrix(file_content("beam.csv"), "f"), round_off);
  expect_bar(exchange::read_csv_matrix(file_content("beam_semicolon.csv"), "f"), round_off);
  for (const char* text : {"1\t2\n3\t4\n", " 1  2 \n 3 4", "\xEF\xBB\xBF# heading\n1, 2\r\n3,4\r\n"}) {
    const auto read = exchange::read_csv_matrix(text, "f");
    ASSERT_TRUE(read) << complaint(read);
    EXPECT_EQ(read->values, (Eigen::MatrixXd(2, 2) << 1, 2, 3, 4).finished());
  }
}

TEST(TextLines, OfOldProgramsEndWithACarriageReturn) {
  EXPECT_EQ(exchange::with_line_feeds("1,2\r3,4\r"), "1,2\n3,4\n");
  EXPECT_EQ(exchange::with_line_feeds("1,2\r\n3,4\r\n"), "1,2\r\n3,4\r\n");
}

TEST(CsvMatrix, WarnsAboutALineReadAsHeading) {
  const auto read = exchange::read_csv_matrix("ux, uy\n1, 2\n3, 4\n", "f");
  ASSERT_TRUE(read);
  ASSERT_EQ(read->warnings.list().size(), 1u);
  EXPECT_THAT(message(read->warnings.list()[0]), HasSubstr("f:1: warning: heading"));
}

TEST(CsvMatrix, OfASpreadsheetOrADataFrameIsReadWithoutItsFrame) {
  const Eigen::MatrixXd wanted = (Eigen::MatrixXd(2, 2) << 1, 2, 3, 4).finished();
  const std::pair<const char*, std::size_t> cases[] = {{"0,1\n1,2\n3,4\n", 1},         {"1;2\r\n1;2\r\n3;4\r\n", 1},
                                                       {",0,1\n0,1,2\n1,3,4\n", 2},    {",ux,uy\nux,1,2\nuy,3,4\n", 2},
                                                       {"\"0\",\"1\"\n1,2\n3,4\n", 1}, {"1,2,\n3,4,\n", 0},
                                                       {"ux,uy,,\n1,2,,\n3,4,,\n", 1}};
  for (const auto& [text, warnings] : cases) {
    const auto read = exchange::read_csv_matrix(text, "f");
    ASSERT_TRUE(read) << text << complaint(read);
    EXPECT_EQ(read->values, wanted) << text;
    EXPECT_EQ(read->warnings.list().size(), warnings) << text;
  }
  EXPECT_FALSE(exchange::read_csv_matrix("5,6\n1,2\n3,4\n", "f"));  // not a heading
  EXPECT_EQ(exchange::read_csv_matrix("0,1\n1,0\n", "f")->values, (Eigen::MatrixXd(2, 2) << 0, 1, 1, 0).finished());
}

struct Bad {
  const char* text;
  const char* complaint;
};

TEST(MatrixMarket, ReportsWhatIsWrongAndWhere) {
  const std::string head = "%%MatrixMarket matrix coordinate real general\n";
  const Bad cases[] = {
      {"2 2 1\n1 1 1\n", "f:1: error: header"},  // placed after the header below; a second line is missing
      {"2 3 1\n1 1 1\n", "f:2: error: size: 2 × 3"},
      {"2 2\n1 1 1\n", "f:2: error: size: \"2 2\""},
      {"2 2 -1\n", "f:2: error: size"},
      {"0 0 0\n", "f:2: error: size: 0 × 0"},
      {"2000000000 2000000000 1\n1 1 1\n", "f:2: error: size: 2000000000 × 2000000000; a matrix of at most 6000"},
      {"99999999999 99999999999 1\n", "f:2: error: size"},
      {"2 2 1\n0 1 5\n",
       "f:3: error: entry: row 0, column 1; rows and columns count from 1 to 2; the file seems to count from 0"},
      {"2 2 1\n3 1 5\n", "f:3: error: entry: row 3"},
      {"2 2 1\n1 1 abc\n", "f:3: error: entry: \"1 1 abc\""},
      {"2 2 1\n1 1 nan\n", "f:3: error: entry"},
      {"2 2 1\n1 1 1e999\n", "f:3: error: entry"},
      {"2 2 1\n1 1 1 2\n", "f:3: error: entry"},
      {"2 2 2\n1 1 1\n", "the file ends after 1 of 2"},
      {"2 2 1\n1 1 1\n2 2 1\n", "f:4: error: entries: more than the stated 1"},
      {"2 2 2\n1 1 1\n1 1 1\n", "f:4: error: entry (1, 1): given again, first in line 3"},
      {"2 2 2000000000\n1 1 1\n", "the file ends after 1 of 2000000000"},
      {"", "error: size: missing"},
  };
  for (const Bad& bad : cases) {
    const bool headless = std::string(bad.complaint).find("header") != std::string::npos;
    const auto read = exchange::read_matrix_market(headless ? bad.text : head + bad.text, "f");
    EXPECT_THAT(complaint(read), HasSubstr(bad.complaint)) << bad.text;
  }
  for (const char* kind :
       {"coordinate pattern general", "coordinate real skew", "array complex hermitean", "vector real general"})
    EXPECT_THAT(
        complaint(exchange::read_matrix_market(std::string("%%MatrixMarket matrix ") + kind + "\n1 1 1\n1 1 1\n", "f")),
        HasSubstr("f:1: error: header"));
  EXPECT_THAT(complaint(exchange::read_matrix_market(
                  "%%MatrixMarket matrix coordinate real symmetric\n2 2 2\n2 1 5\n1 2 6\n", "f")),
              HasSubstr("its mirror image in line 3 is 5"));
  EXPECT_THAT(complaint(exchange::read_matrix_market("%%MatrixMarket matrix array real general\n2 2\n1\n2\n3\n", "f")),
              HasSubstr("the file ends in column 2 of 2"));
  EXPECT_THAT(
      complaint(exchange::read_matrix_market("%%MatrixMarket matrix array real symmetric\n2 2\n1\n2\n3\n4\n", "f")),
      HasSubstr("f:6: error: entries: more than"));
}

/// A version 1 file with this header text and this many zero bytes behind it.
std::string numpy_file(const std::string& header, std::size_t bytes) {
  std::string file("\x93NUMPY\x01\x00", 8);
  file += static_cast<char>(header.size() & 255);
  file += static_cast<char>(header.size() >> 8);
  return file + header + std::string(bytes, '\0');
}

TEST(NumpyArray, ReportsWhatIsWrong) {
  const auto said = [](const std::string& bytes) { return complaint(exchange::read_numpy_array(bytes, "f")); };
  const std::string order = "'fortran_order': False, ";
  EXPECT_EQ(said(numpy_file("{'descr': '<f8', " + order + "'shape': (1, 1), }", 8)), "none");
  EXPECT_THAT(said("PK\x03\x04"), HasSubstr("extract the array from the .npz"));
  EXPECT_THAT(said(""), HasSubstr("not a NumPy file"));
  EXPECT_THAT(said("\x93NUMPY"), HasSubstr("not a NumPy file"));
  EXPECT_THAT(said(std::string("\x93NUMPY\x01\x00\xff\xff{", 11)), HasSubstr("65535 bytes stated"));
  EXPECT_THAT(said(std::string("\x93NUMPY\x02\x00\xff\xff\xff\xff{", 13)), HasSubstr("4294967295 bytes stated"));
  EXPECT_THAT(said(numpy_file("{'descr': '<f4', " + order + "'shape': (1, 1), }", 4)),
              HasSubstr("number type: \"'<f4'\""));
  EXPECT_THAT(said(numpy_file("{'descr': '>f8', " + order + "'shape': (1, 1), }", 8)), HasSubstr("number type"));
  EXPECT_THAT(said(numpy_file("{'descr': '|O', " + order + "'shape': (1, 1), }", 8)), HasSubstr("number type"));
  EXPECT_THAT(said(numpy_file("{'descr': '<f8', 'shape': (1, 1), }", 8)), HasSubstr("fortran_order"));
  EXPECT_THAT(said(numpy_file("{'descr': '<f8', " + order + "'shape': (4,), }", 32)),
              HasSubstr("a matrix has two dimensions"));
  EXPECT_THAT(said(numpy_file("{'descr': '<f8', " + order + "'shape': (1, 1, 1), }", 8)),
              HasSubstr("a matrix has two dimensions"));
  EXPECT_THAT(said(numpy_file("{'descr': '<f8', " + order + "'shape': (1, 2), }", 16)), HasSubstr("size: 1 × 2"));
  EXPECT_THAT(said(numpy_file("{'descr': '<f8', " + order + "'shape': (-1, -1), }", 16)), HasSubstr("size: -1 × -1"));
  EXPECT_THAT(said(numpy_file("{'descr': '<f8', " + order + "'shape': (999999, 999999), }", 16)),
              HasSubstr("at most 6000"));
  EXPECT_THAT(said(numpy_file("{'descr': '<f8', " + order + "'shape': (5000, 5000), }", 16)),
              HasSubstr("16 bytes; a 5000 × 5000 matrix of this type has 200000000"));
  EXPECT_THAT(said(numpy_file("{'descr': '<f8', " + order + "'shape': (1, 1), }", 7)),
              HasSubstr("was the file cut off?"));
  EXPECT_THAT(
      said(numpy_file("{'descr': '<f8', " + order + "'shape': (1, 1), }", 0) + std::string("\0\0\0\0\0\0\xf8\x7f", 8)),
      HasSubstr("entry (1, 1): nan"));
}

TEST(CsvMatrix, ReportsWhatIsWrongAndWhere) {
  const Bad cases[] = {
      {"", "size: 0 × 0"},
      {"# nothing\n\n", "size: 0 × 0"},
      {"1,2\n3\n", "f:2: error: row: 1 numbers; the row in line 1 has 2"},
      {"1,2,3\n4,5,6\n", "size: 2 × 3"},
      {"1,2\n3,x\n", "f:2: error: entry (2, 2): \"x\""},
      {"1,2\n3,\n", "entry (2, 2): \"\"; every entry is a finite number; write 0"},
      {"1,5;2,5\n3;4\n", "heading"},
      {"1;2,5\n3;4\n", "write decimal points"},
      {"inf,2\n3,4\n", "entry (1, 1): \"inf\""},
      {"1,2\n3,1e400\n", "entry (2, 2)"},
  };
  for (const Bad& bad : cases)
    EXPECT_THAT(complaint(exchange::read_csv_matrix(bad.text, "f")), HasSubstr(bad.complaint)) << bad.text;
  EXPECT_THAT(complaint(exchange::read_csv_matrix(std::string(20000, ' ') + "1" + std::string(20000, ','), "f")),
              HasSubstr("at most 6000"));
}

TEST(MatrixFile, MustBeAReadableFile) {
  EXPECT_THAT(complaint(exchange::file_bytes("/no/such/file.mtx")), HasSubstr("no such file"));
  EXPECT_THAT(complaint(exchange::file_bytes(TRIVET_SOURCE_DIR)), HasSubstr("this is a directory"));
}

TEST(MatrixReaders, SurviveEveryTruncationAndEveryChangedByte) {
  for (const char* name : {"beam_complex.mtx", "beam_array_symmetric.mtx", "beam.csv", "beam_complex.npy"}) {
    const std::string whole = file_content(name);
    for (std::size_t at = 0; at < whole.size(); at += 3) {
      std::string changed = whole;
      changed[at] = static_cast<char>(changed[at] ^ 0x15);
      for (const std::string& text : {whole.substr(0, at), changed}) {
        static_cast<void>(exchange::read_matrix_market(text, "f"));
        static_cast<void>(exchange::read_numpy_array(text, "f"));
        static_cast<void>(exchange::read_csv_matrix(text, "f"));
      }
    }
  }
}

}  // namespace matrix_files_test
}  // namespace trivet::test
