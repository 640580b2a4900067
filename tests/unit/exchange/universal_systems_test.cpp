// SPDX-License-Identifier: BSD-3-Clause
// Nodes in double precision, coordinate systems and analysis data, as finite element and modal programs write them.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "unit/exchange/universal_texts.h"

namespace trivet::test {
namespace universal_systems_test {

using Eigen::Vector3d;
using exchange::UniversalFile;
using exchange::UniversalNode;
using testing::HasSubstr;
using Complex = std::complex<double>;

constexpr double round_off = 1e-15;  // a few products of numbers near 1

/// A node of set 2411 in mm.
std::string part_node(int label, int definition, int displacement, const char* position) {
  return fmt::format("{:10d}{:10d}{:10d}{:10d}\n{}\n", label, definition, displacement, 11, position);
}

/// Set 18: origin (1, 0, 0), x along +y and z along +x of the ground.
const std::string turned_system = universal_set(18,
                                                "         7         0         0         8         1\nSYS7\n"
                                                "  1.00000E+00  0.00000E+00  0.00000E+00  1.00000E+00  2.00000E+00  "
                                                "0.00000E+00\n  3.00000E+00  5.00000E+00  0.00000E+00\n");

TEST(UniversalPartNodes, HavePositionsInDoublePrecision) {
  const UniversalFile file = content(
      units_set(5, 1e3, 1e3) +
      universal_set(2411,
                    part_node(11, 1, 1, "   2.9999999999999999D+02   2.0000000000000001D-01  -2.5000000000000000E+00") +
                        part_node(12, 0, 0, "  1 2 3")));
  ASSERT_EQ(file.nodes.size(), 2u);
  EXPECT_EQ(file.nodes[0].label, 11);
  EXPECT_LE((file.nodes[0].position - Vector3d(0.3, 2e-4, -2.5e-3)).norm(), round_off);
  for (const UniversalNode& node : file.nodes) EXPECT_TRUE(node.position_known && node.axes_known);
  EXPECT_THAT(complaint(read_text(universal_set(2411, part_node(11, 1, 1, "  1 2")))), HasSubstr("f:4: error: set 1"));
}

TEST(UniversalSystems, BySetEighteenPlaceNodesAndTurnTheirDirections) {
  const UniversalFile file = content(
      universal_set(15, "  5  7  7  0  1. 2. 3.\n  6  3  0  0  1. 2. 3.\n  7  0  9  0  1. 2. 3.\n") + turned_system);
  ASSERT_EQ(file.nodes.size(), 3u);
  Eigen::Matrix3d axes;
  axes << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  EXPECT_LE((file.nodes[0].axes - axes).norm(), round_off);
  EXPECT_LE((file.nodes[0].position - Vector3d(1 + 3, 1, 2)).norm(), round_off);
  EXPECT_TRUE(file.nodes[0].position_known && file.nodes[0].axes_known);
  EXPECT_FALSE(file.nodes[1].position_known);  // the file has no system 3 and no system 9
  EXPECT_FALSE(file.nodes[2].axes_known);
}

TEST(UniversalSystems, ByAMatrixHaveItsRowsAsAxes) {
  const std::string systems =
      "         1\nPart\n         4         0         2\nCS4\n  0.0D+00 1.0D+00 0.0D+00\n  0.0D+00 0.0D+00 1.0D+00\n"
      "  1.0D+00 0.0D+00 0.0D+00\n  5.0D+00 0.0D+00 0.0D+00\n         5         1         2\nCS5\n"
      "  1 0 0\n  0 1 0\n  0 0 1\n  0 0 0\n";
  const UniversalFile file =
      content(universal_set(2420, systems) +
              universal_set(2411, part_node(1, 4, 4, "  1 2 3") + part_node(2, 5, 5, "  0 2 3")));
  EXPECT_EQ(file.nodes[0].position, Vector3d(1, 2, 3));  // positions of set 2411 are those of the part
  EXPECT_EQ(file.nodes[0].axes.col(0), Vector3d(0, 1, 0));
  EXPECT_EQ(file.nodes[0].axes.col(2), Vector3d(1, 0, 0));
  EXPECT_LE((file.nodes[1].axes.col(0) - Vector3d(0, 1, 0)).norm(), round_off);   // radial
  EXPECT_LE((file.nodes[1].axes.col(1) - Vector3d(-1, 0, 0)).norm(), round_off);  // tangential
}

/// Set 2414: head of results at nodes, and two nodes.
std::string analysis(int location, int kind, int result, int data, const std::string& values) {
  return universal_set(
      2414,
      fmt::format("         1\nMODE\n{:10d}\nNONE\nNONE\nNONE\nNONE\nShape\n         1{:10d}         2{:10d}{:10d}"
                  "         3\n         0         0         1         0         4         9         0         0\n"
                  "         0         0\n  0.00000E+00  1.25000E+01  6.16850E+03  2.00000E+00  3.00000E-02  "
                  "0.00000E+00\n -1.00000E+00  8.00000E+01  0.00000E+00  0.00000E+00  0.00000E+00  0.00000E+00\n{}",
                  location, kind, result, data, values));
}

TEST(UniversalAnalysisData, HasModesAtNodes) {
  const std::string values = "        11\n  1.00000E+00  2.00000E+00  3.00000E+00\n        12\n  0.0 0.0 -1.0\n";
  const UniversalFile file = content(analysis(1, 2, 8, 2, values));
  ASSERT_EQ(file.modes.size(), 1u);
  EXPECT_EQ(file.modes[0].number, 9);
  EXPECT_EQ(file.modes[0].load_case, 4);
  EXPECT_EQ(exchange::natural_frequency_hz(file.modes[0]), 12.5);
  EXPECT_EQ(exchange::damping_ratio(file.modes[0]), 0.03);
  EXPECT_EQ(std::get<exchange::UniversalNormalMode>(file.modes[0].parameters).modal_mass, 2);
  ASSERT_EQ(file.modes[0].nodes.size(), 2u);
  EXPECT_EQ(file.modes[0].nodes[0].components[2], Complex(3));
  EXPECT_FALSE(file.modes[0].has_rotations);
  const UniversalFile complex_file = content(analysis(1, 3, 8, 5, "        11\n  1. 2. 3. 4. 5. 6.\n"));
  EXPECT_EQ(complex_file.modes.at(0).nodes.at(0).components[1], Complex(3, 4));
  EXPECT_NEAR(exchange::natural_frequency_hz(complex_file.modes[0]), std::sqrt(6401.0) / (2 * std::numbers::pi), 1e-12);
}

/// Set 2414 of a frequency response at one frequency: x moves with i·scale, y not at all, z with 2·scale.
std::string response_at(double hertz, double scale) {
  std::string set = analysis(
      1, 5, 12, 5,
      fmt::format("        11\n{0:13.5E}{1:13.5E}{0:13.5E}{0:13.5E}{2:13.5E}{0:13.5E}\n", 0.0, scale, 2 * scale));
  const std::string frequency = "  1.25000E+01";
  return set.replace(set.find(frequency), frequency.size(), fmt::format("{:13.5E}", hertz));
}

TEST(UniversalAnalysisData, HasFrequencyResponsesAtNodes) {
  const UniversalFile file = content(response_at(10, 1) + response_at(20, 3) + response_at(10, 5));
  ASSERT_EQ(file.functions.size(), 4u);  // y does not move; the third set is of another load case
  const exchange::UniversalFunction& x = file.functions[0];
  EXPECT_EQ(x.type, exchange::UniversalFunctionType::spectrum);
  EXPECT_EQ(x.response.node, 11);
  EXPECT_EQ(x.response.direction, 1);
  EXPECT_EQ(file.functions[1].response.direction, 3);
  EXPECT_EQ(x.numerator.quantity, exchange::UniversalQuantity::acceleration);
  EXPECT_EQ(exchange::abscissa_values(x), (std::vector<double>{10, 20}));
  EXPECT_EQ(x.values, (std::vector<Complex>{{0, 1}, {0, 3}}));
  EXPECT_EQ(file.functions[1].values, (std::vector<Complex>{{2, 0}, {6, 0}}));
  EXPECT_EQ(file.functions[2].values, (std::vector<Complex>{{0, 5}}));
  const std::string millimetres =
      universal_set(164, "         9millimetre                  2\n  1.000D+03  1.000D+00  1.000D+00\n  2.7315D+02\n");
  EXPECT_EQ(content(millimetres + response_at(10, 1)).functions.at(0).values[0], Complex(0, 1e-3));
}

TEST(UniversalAnalysisData, OfAnotherKindIsNamedWithWhatToExport) {
  const std::string values = "        11\n  1. 2. 3.\n";
  EXPECT_THAT(
      warnings(analysis(1, 1, 8, 2, values)),
      testing::AllOf(HasSubstr("1 × motions of a static analysis"), HasSubstr("export modes at nodes, or functions")));
  EXPECT_THAT(warnings(analysis(1, 5, 12, 2, values)), HasSubstr("1 × real motions of a frequency response"));
  EXPECT_THAT(warnings(analysis(1, 2, 2, 2, values)), HasSubstr("1 × results of type 2 of modes"));
  EXPECT_THAT(warnings(analysis(2, 2, 8, 2, values)), HasSubstr("1 × results at elements"));
}

TEST(UniversalElements, AreCounted) {
  const std::string solid = "         1       111         5         1         1         4\n  1 3 6 7\n",
                    beam = "         2        11         5         1         1         2\n  0 0 0\n  1 2\n",
                    many =
                        "         3       116         5         1         1        20\n  1 2 3 4 5 6 7 8\n"
                        "  1 2 3 4 5 6 7 8\n  1 2 3 4\n";
  EXPECT_THAT(warnings(universal_set(2412, solid + beam + many)), HasSubstr("2412 with 3 elements"));
}

}  // namespace universal_systems_test
}  // namespace trivet::test
