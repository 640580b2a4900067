// SPDX-License-Identifier: BSD-3-Clause
// CalculiX, run as a process, against the Timoshenko beam and against itself by three methods: unit motions of a rigid
// plate, the whole stiffness condensed here, and its own substructure.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "support/matchers.h"
#include "support/matrix_files.h"
#include "trivet/elements/checks.h"
#include "trivet/elements/law.h"
#include "trivet/exchange/end_stiffness.h"
#include "trivet/exchange/matrix_file.h"

namespace trivet::test {
namespace calculix_test {

using exchange::Matrix12;
using exchange::NodeEnd;
using exchange::RigidEnd;

/// A bar of 10 × 20 × 120 mm along z in eight quadratic bricks. Without lateral contraction clamped ends do not disturb
/// it.
struct BrickBar {
  static constexpr double width = 10, height = 20, length = 120, modulus = 210000;
  static constexpr int elements = 8;
  std::map<std::array<int, 3>, int> nodes;  ///< by half-steps along x, y, z
  RigidEnd n{{0, 0, 0}, {}}, k{{0, 0, length}, {}};

  BrickBar() {
    for (int z = 0; z <= 2 * elements; ++z)
      for (int y = 0; y <= 2; ++y)
        for (int x = 0; x <= 2; ++x) {
          if (x % 2 + y % 2 + z % 2 > 1) continue;
          const int number = static_cast<int>(nodes.size()) + 1;
          nodes[{x, y, z}] = number;
          if (z == 0) n.nodes.push_back({number, position({x, y, z})});
          if (z == 2 * elements) k.nodes.push_back({number, position({x, y, z})});
        }
  }
  static Eigen::Vector3d position(const std::array<int, 3>& at) {
    return {width * (at[0] - 1) / 2, height * (at[1] - 1) / 2, length * at[2] / (2 * elements)};
  }

  /// Mesh, material and the sets PN and PK; nodes 901 … 904 are for rigid bodies.
  [[nodiscard]] std::string deck() const {
    std::ostringstream text;
    text << "*NODE\n";
    for (const auto& [at, number] : nodes)
      text << number << ", " << position(at).x() << ", " << position(at).y() << ", " << position(at).z() << "\n";
    text << "901, 0., 0., 0.\n902, 0., 0., 0.\n903, 0., 0., " << length << "\n904, 0., 0., " << length
         << "\n*ELEMENT, TYPE=C3D20, ELSET=BAR\n";
    const int corners[20][3] = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2},
                                {0, 2, 2}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}, {1, 0, 2}, {2, 1, 2},
                                {1, 2, 2}, {0, 1, 2}, {0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}};
    for (int e = 0; e < elements; ++e) {
      text << e + 1;
      for (int i = 0; i < 20; ++i)
        text << (i == 10 ? ",\n" : ", ") << nodes.at({corners[i][0], corners[i][1], corners[i][2] + 2 * e});
      text << "\n";
    }
    for (const auto& [name, end] : {std::pair{"PN", &n}, std::pair{"PK", &k}}) {
      text << "*NSET, NSET=" << name << "\n";
      for (const auto& at : end->nodes) text << at.node << ",\n";
    }
    text << "*MATERIAL, NAME=STEEL\n*ELASTIC\n"
         << modulus << ", 0.\n*DENSITY\n7.85E-9\n*SOLID SECTION, ELSET=BAR, MATERIAL=STEEL\n";
    return text.str();
  }
};

/// Timoshenko beam without lateral contraction. Shear warps a section with the third power of the height; one quadratic
/// brick across the section cannot: the section stays plane, and its shear factor is 1 instead of 5/6.
Matrix12 timoshenko() {
  constexpr double a = BrickBar::width, b = BrickBar::height, l = BrickBar::length, e = BrickBar::modulus, g = e / 2;
  const double about_x = a * b * b * b / 12, about_y = b * a * a * a / 12;
  const double torsion = b * a * a * a * (1.0 / 3 - 0.21 * a / b * (1 - std::pow(a / b, 4) / 12));
  Matrix12 k = bernoulli({.length = l,
                          .axial = e * a * b,
                          .torsion = g * torsion,
                          .bending_about_x = e * about_x,
                          .bending_about_y = e * about_y});
  const auto soften = [&](int u, int turn, double inertia) {
    const double stiffness = e * inertia, phi = 12 * stiffness / (g * a * b * l * l);
    for (const int i : {0, 6})
      for (const int j : {0, 6}) {
        k(u + i, u + j) /= 1 + phi;
        k(u + i, turn + j) /= 1 + phi;
        k(turn + i, u + j) /= 1 + phi;
        k(turn + i, turn + j) = stiffness / l * ((i == j ? 4 : 2) + (i == j ? phi : -phi)) / (1 + phi);
      }
  };
  soften(0, 4, about_y);
  soften(1, 3, about_x);
  return k;
}

const std::string rigid_ends =
    "*RIGID BODY, NSET=PN, REF NODE=901, ROT NODE=902\n*RIGID BODY, NSET=PK, REF NODE=903, ROT NODE=904\n";

/// A separate folder for the files of one run.
class CalculiX : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(std::system("command -v ccx >/dev/null 2>&1"), 0) << "CalculiX is missing: scripts/packages tests";
    std::string pattern = (std::filesystem::temp_directory_path() / "trivet-calculix-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override {
    if (!folder_.empty()) std::filesystem::remove_all(folder_);
  }
  void run(const std::string& name, const std::string& deck) const {
    std::ofstream(folder_ / (name + ".inp")) << deck;
    const std::string command =
        "cd '" + folder_.string() + "' && OMP_NUM_THREADS=1 ccx " + name + " >" + name + ".log 2>&1";
    ASSERT_EQ(std::system(command.c_str()), 0) << "CalculiX failed";
  }

  /// 12×12 from the reactions of both plates to unit motions of plate K, then of plate N.
  [[nodiscard]] Matrix12 by_unit_motions() const {
    constexpr double unit = 1e-3;
    std::string deck = bar_.deck() + rigid_ends + "*NSET, NSET=ENDS\n901, 902, 903, 904\n";
    const auto coordinate = [](int i) { return std::pair{901 + i / 3, i % 3 + 1}; };
    for (int moved = 0; moved < 12; ++moved) {
      deck += "*STEP\n*STATIC\n*BOUNDARY, OP=NEW\n";
      for (int i = 0; i < 12; ++i) {
        const auto [node, component] = coordinate(i);
        deck += std::to_string(node) + ", " + std::to_string(component) + ", " + std::to_string(component) +
            (i == moved ? ", 0.001\n" : ", 0.\n");
      }
      deck += "*NODE PRINT, NSET=ENDS\nRF\n*END STEP\n";
    }
    run("motions", deck);
    Matrix12 k = Matrix12::Zero();
    std::ifstream data(folder_ / "motions.dat");
    int column = -1;
    for (std::string line; std::getline(data, line);) {
      if (line.find("forces") != std::string::npos) ++column;
      std::istringstream numbers(line);
      int node = 0;
      Eigen::Vector3d force;
      if (column < 0 || column > 11 || !(numbers >> node >> force.x() >> force.y() >> force.z()) || node < 901 ||
          node > 904)
        continue;
      k.block<3, 1>(3 * (node - 901), column) = force / unit;
    }
    EXPECT_EQ(column, 11);
    return k;
  }

  BrickBar bar_;
  std::filesystem::path folder_;
};

/// The step that writes the stiffness of all nodes.
const std::string storage_step = "*STEP\n*FREQUENCY, SOLVER=MATRIXSTORAGE\n1\n*END STEP\n";

/// CalculiX prints reactions with seven digits.
constexpr double printed_reaction = 2e-6;
/// Eight quadratic bricks reproduce the cubic bending line to 0.3 %. In torsion one brick across and ends that cannot
/// warp are stiffer than free torsion.
constexpr double bending_of_bricks = 4e-3, torsion_of_bricks = 0.25;

Matrix12 condensed(const foundation::Expected<exchange::NamedMatrix>& matrix, const BrickBar& bar) {
  EXPECT_TRUE(matrix) << complaint(matrix);
  if (!matrix) return Matrix12::Zero();
  const auto ends = exchange::reduce_to_ends(*matrix, bar.n, bar.k);
  EXPECT_TRUE(ends) << complaint(ends);
  return ends ? ends->values : Matrix12(Matrix12::Zero());
}

elements::MatrixVerdict verdict(const Matrix12& matrix) {
  return elements::examine(matrix, elements::rigid_motions({0, 0, BrickBar::length}, Eigen::Matrix3d::Identity()));
}

TEST_F(CalculiX, WholeStiffnessCondensedHereAgreesWithItsUnitMotions) {
  run("storage", bar_.deck() + storage_step);
  const Matrix12 here = condensed(exchange::read_matrix_file(folder_ / "storage.sti"), bar_);
  EXPECT_THAT(by_unit_motions(), NearInUnits(here, entry_scale(here), printed_reaction));
  EXPECT_LT(verdict(here).rigid_residual, elements::silent_residual);
  EXPECT_TRUE(elements::is_semidefinite(verdict(here)));
}

TEST_F(CalculiX, BricksAreATimoshenkoBeam) {
  run("storage", bar_.deck() + storage_step);
  Matrix12 bricks = condensed(exchange::read_matrix_file(folder_ / "storage.sti"), bar_);
  Matrix12 beam = timoshenko();
  constexpr double uniform_strain = 1e-9;  // exact in every element; the condensation rounds
  EXPECT_THAT(bricks(8, 8), RelativelyNear(beam(8, 8), uniform_strain));
  EXPECT_THAT(bricks(11, 11), RelativelyNear(beam(11, 11), torsion_of_bricks));
  for (const int i : {5, 11})
    for (const int j : {5, 11}) bricks(i, j) = beam(i, j) = 0;
  EXPECT_THAT(bricks, NearInUnits(beam, entry_scale(timoshenko()), bending_of_bricks));
}

TEST_F(CalculiX, SubstructureIsWrongWithoutAMessageAndTheRigidMotionTestFindsIt) {
  const std::string output =
      "*SUBSTRUCTURE MATRIX OUTPUT, STIFFNESS=YES, OUTPUT FILE=USER DEFINED, FILE NAME=reduced\n*END STEP\n";
  run("rigid",
      bar_.deck() + rigid_ends +
          "*STEP\n*SUBSTRUCTURE GENERATE\n*RETAINED NODAL DOFS, SORTED=NO\n901,1,3\n902,1,3\n903,1,3\n904,1,3\n" +
          output);
  const auto matrix = exchange::read_matrix_file(folder_ / "reduced.mtx");
  ASSERT_TRUE(matrix) << complaint(matrix);
  const auto ends = exchange::reduce_to_ends(*matrix, NodeEnd{901, 902}, NodeEnd{903, 904});
  ASSERT_TRUE(ends) << complaint(ends);
  EXPECT_GT(verdict(ends->values).rigid_residual, elements::refused_residual);
  EXPECT_GT(ends->values(8, 8), 10 * timoshenko()(8, 8));
}

}  // namespace calculix_test
}  // namespace trivet::test
