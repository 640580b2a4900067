// SPDX-License-Identifier: BSD-3-Clause
// Matrix files with node names: Nastran DMIG, Abaqus and CalculiX.
#include <gtest/gtest.h>

#include "support/matchers.h"
#include "support/matrix_files.h"
#include "trivet/elements/checks.h"
#include "trivet/exchange/end_stiffness.h"
#include "trivet/exchange/matrix_file.h"
#include "trivet/exchange/matrix_formats.h"
#include "trivet/exchange/named_matrix.h"
#include "trivet/exchange/text/file_bytes.h"

namespace trivet::test {
namespace labelled_matrices_test {

using exchange::Label;
using exchange::NodeEnd;
using exchange::RigidEnd;
using testing::HasSubstr;

const std::string folder = std::string(TRIVET_SOURCE_DIR) + "/tests/data/matrices/";
std::string file_content(const std::string& name) { return *exchange::file_bytes(folder + name); }

/// Digits of the entries in the files: 10 in large fields, 4 in small fields with a sign and an exponent.
constexpr double large_field = 1e-9, small_field = 2e-3;

TEST(NastranDmig, IsReadInLargeFieldAsSymmetricMatrix) {
  const auto matrix = exchange::read_nastran_dmig(file_content("chain_large.pch"), "f", "kaax");
  ASSERT_TRUE(matrix) << complaint(matrix);
  ASSERT_EQ(matrix->labels.size(), 30u);
  EXPECT_EQ(matrix->labels.front(), (Label{11, 1}));
  EXPECT_EQ(matrix->labels.back(), (Label{15, 6}));
  const auto exact = exchange::read_matrix_file(folder + "chain.npy");
  EXPECT_THAT(matrix->values, NearInUnits(exact->values, entry_scale(exact->values), large_field));
}

TEST(NastranDmig, IsReadInSmallFieldAsSquareMatrix) {
  const auto matrix = exchange::read_matrix_file(folder + "chain_small.bdf");
  ASSERT_TRUE(matrix) << complaint(matrix);
  const auto exact = exchange::read_matrix_file(folder + "chain.npy");
  EXPECT_THAT(matrix->values, NearInUnits(exact->values, entry_scale(exact->values), small_field));
}

TEST(NastranDmig, KeepsTheImaginaryPart) {
  const auto matrix = exchange::read_matrix_file(folder + "beam_complex.pch");
  ASSERT_TRUE(matrix) << complaint(matrix);
  const Eigen::MatrixXd loss = 0.02 * bernoulli();
  EXPECT_THAT(matrix->values, NearInUnits(bernoulli(), entry_scale(bernoulli()), large_field));
  EXPECT_THAT(matrix->imaginary, NearInUnits(loss, entry_scale(loss), large_field));
}

/// The same 2×2 matrix, 3 and 5 on the diagonal and −2 off it, on component 1 of the points 7 and 9.
TEST(NastranDmig, IsTheSameInFreeFieldLargeFieldWithContinuationsAndTabs) {
  const char* texts[] = {
      // free field, an entry of each triangle, other cards and comments around it
      "SOL 103\nBEGIN BULK\nGRID,7,,0.,0.,0.\n$ "
      "comment\nDMIG,K,0,6,2\nDMIG,K,7,1,,7,1,3.0,,+A\n+A,9,1,-2.0\nDMIG,K,9,1,,9,1,5.+0\nENDDATA\nDMIG,K,9,1,,9,1,5."
      "\n",
      // small field with two entries behind a continuation, lower case name
      "DMIG    k              0       6       1\n"
      "DMIG    k              7       1               7       1     3.0        +A\n"
      "+A             9       1    -2.0\n"
      "DMIG    k              9       1               9       1   .5+01\n",
      // large field
      "DMIG*   K                              0               6               2\n*\n"
      "DMIG*   K                              7               1                \n"
      "*                      7               1         3.0D+00\n"
      "*                      9               1        -2.0D+00\n"
      "DMIG*   K                              9               1                \n"
      "*                      9               1           5.D+0\n",
      // tabs
      "DMIG\tK\t0\t6\t2\nDMIG\tK\t7\t1\t\t7\t1\t3.\n\t9\t1\t-2.\nDMIG\tK\t9\t1\t\t9\t1\t5.\n",
      // square, both triangles
      "DMIG,K,0,1,2\nDMIG,K,7,1,,7,1,3.0\n,9,1,-2.0\nDMIG,K,9,1,,9,1,5.0\n,7,1,-2.\n",
  };
  for (const char* text : texts) {
    const auto matrix = exchange::read_nastran_dmig(text, "f");
    ASSERT_TRUE(matrix) << complaint(matrix) << text;
    EXPECT_EQ(matrix->values, (Eigen::MatrixXd(2, 2) << 3, -2, -2, 5).finished()) << text;
    EXPECT_EQ(matrix->labels, (std::vector<Label>{{7, 1}, {9, 1}}));
  }
}

TEST(NastranDmig, ReadsAmplitudeAndPhaseInDegrees) {
  const auto matrix = exchange::read_nastran_dmig("DMIG,K,0,6,4,,1\nDMIG,K,7,,,7,,2.0,30.\n", "f");
  ASSERT_TRUE(matrix) << complaint(matrix);
  EXPECT_DOUBLE_EQ(matrix->values(0, 0), std::sqrt(3.0));
  constexpr double few_roundings = 4 * epsilon;  // an angle in radians, its sine and a product
  EXPECT_NEAR(matrix->imaginary(0, 0), 1, few_roundings);
  EXPECT_EQ(matrix->labels[0], (Label{7, 0}));
}

TEST(NastranDmig, ReportsWhatIsWrongAndWhere) {
  const auto said = [](const std::string& text, const std::string& name = "") {
    return complaint(exchange::read_nastran_dmig(text, "f", name));
  };
  const std::string head = "DMIG,K,0,6,2\n";
  EXPECT_THAT(said(""), HasSubstr("DMIG: no such card"));
  EXPECT_THAT(said("DMIG,K,0,9,2,,,,4\n"), HasSubstr("f:1: error: IFO: \"9\""));
  EXPECT_THAT(said("DMIG,K,0,6,7\n"), HasSubstr("f:1: error: TIN"));
  EXPECT_THAT(said("DMIG,K,0,6,3,,2\n"), HasSubstr("POLAR: 2"));
  EXPECT_THAT(said(head), HasSubstr("size: 0 × 0"));
  EXPECT_THAT(said("DMIG,K,7,1,,7,1,3.0\n"), HasSubstr("its header card comes first"));
  EXPECT_THAT(said(head + head), HasSubstr("f:2: error: DMIG: a second header card"));
  EXPECT_THAT(said(head + "DMIG,M,0,6,2\n"), HasSubstr("the file has 2 matrices: k, m"));
  EXPECT_THAT(said(head, "KK"), HasSubstr("did you mean \"k\"?"));
  EXPECT_THAT(said(head + "DMIG,K,x,1,,7,1,3.0\n"), HasSubstr("f:2: error: grid point: \"x\", component \"1\""));
  EXPECT_THAT(said(head + "DMIG,K,7,7,,7,1,3.0\n"), HasSubstr("f:2: error: grid point: \"7\", component \"7\""));
  EXPECT_THAT(said(head + "DMIG,K,7,1,,7,1,3.0\n,-9,1,1.\n"), HasSubstr("f:3: error: grid point: \"-9\""));
  EXPECT_THAT(said(head + "DMIG,K,7,1,,7,1,abc\n"), HasSubstr("f:2: error: entry: \"abc\""));
  EXPECT_THAT(said(head + "DMIG,K,7,1,,7,1,1.,2.\n"), HasSubstr("the header declares the matrix as real"));
  EXPECT_THAT(said(head + "DMIG,K,7,1,,7,1,1.\nDMIG,K,7,1,,7,1,1.\n"),
              HasSubstr("f:3: error: entry (1, 1): given again, first in line 2"));
  EXPECT_THAT(said(head + "DMIG,K,7,1,,9,1,1.\nDMIG,K,9,1,,7,1,2.\n"), HasSubstr("its mirror image"));
  std::string many = head;
  for (int i = 1; i <= 6001; ++i) many += "DMIG,K," + std::to_string(i) + ",,," + std::to_string(i) + ",,1.\n";
  EXPECT_THAT(said(many), HasSubstr("at most 6000"));
}

TEST(Substructure, IsReadWithItsNodes) {
  const auto matrix = exchange::read_matrix_file(folder + "block_plates.mtx");
  ASSERT_TRUE(matrix) << complaint(matrix);
  ASSERT_EQ(matrix->labels.size(), 24u);
  EXPECT_EQ(matrix->labels[4], (Label{2, 2}));
  EXPECT_EQ(matrix->labels[23], (Label{20, 3}));
  EXPECT_EQ(matrix->values(2, 1), 0.1682692307692E+06);
  EXPECT_EQ(matrix->values, matrix->values.transpose());
}

const RigidEnd bottom{{0, 0, 0}, {{1, {-5, -5, 0}}, {2, {5, -5, 0}}, {3, {-5, 5, 0}}, {4, {5, 5, 0}}}};
const RigidEnd top{{0, 0, 60}, {{17, {-5, -5, 60}}, {18, {5, -5, 60}}, {19, {-5, 5, 60}}, {20, {5, 5, 60}}}};

elements::MatrixVerdict verdict(const exchange::Matrix12& matrix) {
  return elements::examine(matrix, elements::rigid_motions({0, 0, 60}, Eigen::Matrix3d::Identity()));
}

TEST(MatrixStorage, ResistsNoRigidMotionAfterCondensationOntoItsPlates) {
  const auto matrix = exchange::read_matrix_file(folder + "block_storage.sti");
  ASSERT_TRUE(matrix) << complaint(matrix);
  EXPECT_EQ(matrix->labels.size(), 96u);  // 20 nodes, and nine inner modes of each of four elements
  const auto ends = exchange::reduce_to_ends(*matrix, bottom, top);
  ASSERT_TRUE(ends) << complaint(ends);
  EXPECT_LT(verdict(ends->values).rigid_residual, elements::silent_residual);
  EXPECT_TRUE(elements::is_semidefinite(verdict(ends->values)));
  // Clamped ends prevent the contraction: stiffer than E A / L, but by less than 5 %.
  constexpr double clamped_ends = 1.05, bar = 210000.0 * 100 / 60;
  EXPECT_GT(ends->values(8, 8), bar);
  EXPECT_LT(ends->values(8, 8), clamped_ends * bar);
}

TEST(Substructure, FailsOnlyTheCheckOfRigidMotionWithRigidBodies) {
  const auto matrix = exchange::read_matrix_file(folder + "block_rigid_body.mtx");
  ASSERT_TRUE(matrix) << complaint(matrix);
  const auto ends = exchange::reduce_to_ends(*matrix, NodeEnd{101, 103}, NodeEnd{102, 104});
  ASSERT_TRUE(ends) << complaint(ends);
  EXPECT_GT(verdict(ends->values).rigid_residual, elements::refused_residual);
  EXPECT_LT(verdict(ends->values).asymmetry, elements::rounding_of_data);
  EXPECT_TRUE(elements::is_semidefinite(verdict(ends->values)));
  constexpr double printed = 1e-6;                                 // 13 digits of up to 1e7
  EXPECT_TRUE(ends->values.topRightCorner(6, 6).isZero(printed));  // the ends are not coupled
}

TEST(Substructure, FailsTheCheckOfRigidMotionWithPlates) {
  const auto matrix = exchange::read_matrix_file(folder + "block_plates.mtx");
  const auto ends = exchange::reduce_to_ends(*matrix, bottom, top);
  ASSERT_TRUE(ends) << complaint(ends);
  EXPECT_GT(verdict(ends->values).rigid_residual, elements::refused_residual);
}

TEST(Substructure, ListsComponentsOnceForAllNodesThatFollow) {
  const char* text =
      "*USER ELEMENT, NODES=3, LINEAR, TYPE=U1\n** ELEMENT NODES\n** 10, 20,\n** 30\n1, 2\n3, 6\n"
      "*MATRIX, TYPE=MASS\n9.,\n*MATRIX, TYPE=STIFFNESS\n1.,\n2., 3.,\n4., 5., 6.\n7., 8., 9., 10.\n1.1D1, 12., 13., "
      "14., 15.\n";
  const auto matrix = exchange::read_abaqus_matrix(text, "f");
  ASSERT_TRUE(matrix) << complaint(matrix);
  EXPECT_EQ(matrix->labels, (std::vector<Label>{{10, 1}, {10, 2}, {20, 1}, {20, 2}, {30, 6}}));
  EXPECT_EQ(matrix->values(4, 0), 11);
  EXPECT_EQ(matrix->values(0, 3), 7);
}

TEST(Substructure, IsReadUnsymmetricAndWithoutNamesOfNodes) {
  const auto matrix = exchange::read_abaqus_matrix(
      "*USER ELEMENT, NODES=2, LINEAR, UNSYMM\n3\n*MATRIX,TYPE=STIFFNESS\n1., 2.\n3., 4.\n", "f");
  ASSERT_TRUE(matrix) << complaint(matrix);
  EXPECT_EQ(matrix->values, (Eigen::MatrixXd(2, 2) << 1, 2, 3, 4).finished());
  EXPECT_EQ(matrix->labels, (std::vector<Label>{{1, 3}, {2, 3}}));
  ASSERT_EQ(matrix->warnings.list().size(), 1u);
}

TEST(AbaqusMatrix, IsReadFromOneTriangleOrBoth) {
  for (const char* text :
       {"7,1, 7,1, 3.0\n9,1, 7,1, -2.0\n9,1, 9,1, 5.\n", "** both\n7 1 7 1 3\n9 1 7 1 -2\n7 1 9 1 -2\n9 1 9 1 5\n"}) {
    const auto matrix = exchange::read_abaqus_matrix(text, "f");
    ASSERT_TRUE(matrix) << complaint(matrix);
    EXPECT_EQ(matrix->values, (Eigen::MatrixXd(2, 2) << 3, -2, -2, 5).finished());
    EXPECT_EQ(matrix->labels, (std::vector<Label>{{7, 1}, {9, 1}}));
  }
}

TEST(AbaqusMatrix, ReportsWhatIsWrongAndWhere) {
  const auto said = [](const std::string& text, const std::string& type = "stiffness") {
    return complaint(exchange::read_abaqus_matrix(text, "f", type));
  };
  EXPECT_THAT(said(""), HasSubstr("size: 0 × 0"));
  EXPECT_THAT(said("1 1 5.0\n"), HasSubstr("f:1: error: entry: \"1 1 5.0\""));
  EXPECT_THAT(said("1,11,1,11,5.0\n"), HasSubstr("f:1: error: component: 11"));
  EXPECT_THAT(said("1,1,1,1,five\n"), HasSubstr("f:1: error: entry"));
  EXPECT_THAT(said("1,1,1,1,5\n1,1,1,1,5\n"), HasSubstr("f:2: error: entry (1, 1): given again, first in line 1"));
  const std::string element = "*USER ELEMENT, NODES=2, LINEAR\n1\n";
  EXPECT_THAT(said(element), HasSubstr("*MATRIX, TYPE=stiffness: 0 numbers; 2 components need 3"));
  EXPECT_THAT(said(element + "*MATRIX, TYPE=MASS\n1,2,3\n"), HasSubstr("the file has mass"));
  EXPECT_THAT(said(element + "*MATRIX, TYPE=STIFFNESS\n1,2\n"),
              HasSubstr("2 numbers; 2 components need 3; was the file cut off?"));
  EXPECT_THAT(said(element + "*MATRIX, TYPE=STIFFNESS\n1,x,3\n"), HasSubstr("f:4: error: entry: \"x\""));
  EXPECT_THAT(said("*USER ELEMENT, NODES=2000000000, LINEAR\n1\n"), HasSubstr("NODES=2000000000"));
  EXPECT_THAT(said("*USER ELEMENT, NODES=6000, LINEAR\n1,2,3,4,5,6\n"), HasSubstr("size: 36000 × 36000"));
  EXPECT_THAT(said("*USER ELEMENT, LINEAR\n1\n"), HasSubstr("NODES=0"));
  EXPECT_THAT(said("*USER ELEMENT, NODES=2\n8\n"), HasSubstr("f:2: error: components: \"8\""));
  EXPECT_THAT(said("*USER ELEMENT, NODES=2\n1\n2,1\n1,1\n"), HasSubstr("f:4: error: components"));
  EXPECT_THAT(said("*USER ELEMENT, NODES=2\n** ELEMENT NODES\n** 5, 5\n1\n"),
              HasSubstr("node 5, component 1: named twice"));
  EXPECT_THAT(said("*USER ELEMENT, NODES=2\n** ELEMENT NODES\n** 5\n1\n"),
              HasSubstr("nodes: 1 in the comment; NODES=2"));
  EXPECT_THAT(said(element + element), HasSubstr("f:3: error: *USER ELEMENT: a second one"));
}

TEST(MatrixStorage, ReportsWhatIsWrongAndWhere) {
  const auto said = [](const char* entries, const char* rows) {
    return complaint(exchange::read_matrix_storage(entries, "k.sti", rows, "k.dof"));
  };
  EXPECT_EQ(said("1 1 2.\n1 2 -2.\n2 2 2.\n", "1.1\n2.1\n"), "none");
  EXPECT_THAT(said("1 1 2.\n", ""), HasSubstr("k.dof: error: size: 0 × 0"));
  EXPECT_THAT(said("1 1 2.\n", "1.7\n"), HasSubstr("k.dof:1: error: row: \"1.7\""));
  EXPECT_THAT(said("1 1 2.\n", "one\n"), HasSubstr("k.dof:1: error: row: \"one\""));
  EXPECT_THAT(said("1 1 2.\n", "1.1\n1.1\n"), HasSubstr("named twice"));
  EXPECT_THAT(said("1 3 2.\n", "1.1\n2.1\n"),
              HasSubstr("k.sti:1: error: entry: row 1, column 3; k.dof has 2 rows; do the two files belong together?"));
  EXPECT_THAT(said("1 1\n", "1.1\n"), HasSubstr("k.sti:1: error: entry"));
  EXPECT_THAT(said("", "1.1\n"), HasSubstr("k.sti: error: entries: none"));
}

TEST(MatrixFile, NeedsAKnownFormat) {
  EXPECT_THAT(complaint(exchange::read_matrix_file(folder + "README.md")),
              HasSubstr("the file name does not show it; known formats are matrix_market, numpy"));
  EXPECT_THAT(complaint(exchange::read_matrix_file(folder + "beam.npy", {"ansys", ""})),
              HasSubstr("format: \"ansys\""));
}

TEST(LabelledReaders, SurviveEveryTruncationAndEveryChangedByte) {
  for (const char* name : {"chain_small.bdf", "beam_complex.pch", "block_rigid_body.mtx", "block_storage.dof"}) {
    const std::string whole = file_content(name);
    for (std::size_t at = 0; at < whole.size(); at += 5) {
      std::string changed = whole;
      changed[at] = static_cast<char>(changed[at] ^ 0x15);
      for (const std::string& text : {whole.substr(0, at), changed}) {
        static_cast<void>(exchange::read_nastran_dmig(text, "f"));
        static_cast<void>(exchange::read_abaqus_matrix(text, "f"));
        static_cast<void>(exchange::read_matrix_storage(text, "f", text, "f"));
      }
    }
  }
}

}  // namespace labelled_matrices_test
}  // namespace trivet::test
