// SPDX-License-Identifier: BSD-3-Clause
// The same solid with other elements, and by CalculiX run as a separate program.
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <array>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "support/matchers.h"
#include "support/tetrahedra.h"
#include "trivet/elements/law.h"
#include "trivet/fem/preload.h"
#include "trivet/fem/shapes.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/temporary_folder.h"
#include "trivet/spatial/rigid_motion.h"

namespace solid_mount_agreement_test {

using namespace trivet;

const fem::Block block{.width = 0.06, .depth = 0.05, .layers = {{.thickness = 0.03}}};

double scaled_difference(const spatial::Matrix12& a, const spatial::Matrix12& b, int i, int j) {
  return std::abs(a(i, j) - b(i, j)) / std::sqrt(a(i, i) * a(j, j));
}

TEST(SolidMount, TetrahedraAndHexahedraAgreeWithinTheirEstimates) {
  constexpr double other_half = 0.006;  // the bracket is an estimate, not a bound
  const std::vector<fem::Material> rubber{fem::linear_elastic(3e6, 0.4995)};
  const fem::SolidStiffness hexahedra = fem::condense(block, rubber, 3);
  const fem::SolidStiffness tetrahedra =
      fem::condense(test::in_tetrahedra(fem::mesh(block, 3)), rubber, fem::frame(block));
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j)
      EXPECT_LT(scaled_difference(hexahedra.stiffness, tetrahedra.stiffness, i, j),
                hexahedra.relative_error(i, j) + tetrahedra.relative_error(i, j) + other_half)
          << i << ", " << j;
}

TEST(SolidMount, PreloadedTetrahedraOfBothPressuresAgreeWithHexahedra) {
  constexpr double meshes = 0.04;  // coarse meshes: one to three per cent each before preload
  const std::vector<fem::Material> rubber{fem::mooney_rivlin(0.4e6, 0.1e6, 1e9)};
  const fem::Mesh hexahedra = fem::mesh(block, 2), tetrahedra = test::in_tetrahedra(hexahedra);
  fem::Preload load;
  load.value << 0.001, 0, -0.002, 0, 0.02, 0.05;
  const auto expected = fem::preloaded_stiffness(hexahedra, rubber, fem::frame(block), load);
  ASSERT_TRUE(expected.converged) << expected.failure_reason;
  for (const auto pressure : {fem::TetPressure::constant, fem::TetPressure::continuous}) {
    const auto solid =
        fem::preloaded_stiffness(tetrahedra, rubber, fem::frame(block), load, {.tet_pressure = pressure});
    ASSERT_TRUE(solid.converged) << solid.failure_reason;
    EXPECT_EQ(solid.negative_eigenvalues, 0);
    for (int i = 0; i < 12; ++i)
      for (int j = 0; j < 12; ++j)
        EXPECT_LT(scaled_difference(expected.stiffness, solid.stiffness, i, j), meshes) << i << ", " << j;
  }
}

TEST(SolidMount, TangentIsTheSlopeOfThePreload) {
  // The tangent against central differences of the force, of second order, with steps of 1e-3 of the load.
  constexpr double truncation = 1e-5;  // 1e-3 squared, and the settling of Newton's method over the step
  const std::vector<fem::Material> rubber{fem::yeoh(0.5e6, -0.05e6, 0.02e6, 1e9)};
  const fem::Mesh mesh = fem::mesh(block, 1);
  fem::Preload load;
  load.value << 0.001, -0.0005, -0.003, 0, 0, 0;
  const auto here = fem::preloaded_stiffness(mesh, rubber, fem::frame(block), load);
  ASSERT_TRUE(here.converged) << here.failure_reason;
  for (int j = 0; j < 3; ++j) {
    const double step = 3e-6;
    fem::Preload more = load, less = load;
    more.value(j) += step;
    less.value(j) -= step;
    const spatial::Vector12 slope = (fem::preloaded_stiffness(mesh, rubber, fem::frame(block), more).preload -
                                     fem::preloaded_stiffness(mesh, rubber, fem::frame(block), less).preload) /
        (2 * step);
    // Forces only: the tangent's moments are those of rotation vectors, and a translation changes the arm.
    for (const int i : {0, 1, 2, 6, 7, 8})
      EXPECT_NEAR(slope(i), here.stiffness(i, 6 + j),
                  truncation * std::sqrt(here.stiffness(i, i) * here.stiffness(j, j)));
  }
}

/// CalculiX's stiffness of the K end: one static step per unit motion of the plate, C3D20R on the same nodes.
class CalculiX {
 public:
  CalculiX(const fem::Mesh& mesh, const fem::ElementFrame& frame, double young, double nu)
      : mesh_(mesh), frame_(frame) {
    write_input(young, nu);
  }

  spatial::Matrix6 stiffness() const {
    const std::string command = "cd '" + folder_.path().string() + "' && OMP_NUM_THREADS=1 ccx mount > mount.log 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0);
    std::ifstream file(folder_.path() / "mount.dat");
    spatial::Matrix6 k = spatial::Matrix6::Zero();
    int step = -1;
    for (std::string line; std::getline(file, line);) {
      step += line.find("forces") != std::string::npos;
      std::istringstream numbers(line);
      int node = 0;
      Eigen::Vector3d force;
      if (!(numbers >> node >> force.x() >> force.y() >> force.z()) || step < 0 || step > 5) continue;
      k.col(step).head<3>() += force;
      k.col(step).tail<3>() += (mesh_.nodes.col(node - 1) - frame_.point_k).cross(force);
    }
    EXPECT_EQ(step, 5) << "six steps";
    return k;
  }

 private:
  void write_input(double young, double nu) const {
    constexpr std::array<int, 20> serendipity{0, 1, 2, 3, 4, 5, 6, 7, 8, 11, 13, 9, 16, 18, 19, 17, 10, 12, 14, 15};
    std::vector<bool> used(to_size(mesh_.nodes.cols()), false);
    std::ostringstream elements;
    for (Eigen::Index e = 0; e < mesh_.elements.cols(); ++e) {
      elements << e + 1;
      int written = 0;
      for (const int a : serendipity) {
        elements << (++written == 11 ? ",\n" : ", ") << mesh_.elements(a, e) + 1;
        used[mesh_.elements(a, e)] = true;
      }
      elements << "\n";
    }
    std::ofstream file(folder_.path() / "mount.inp");
    file.precision(16);
    file << "*NODE, NSET=ALL\n";
    for (Eigen::Index a = 0; a < mesh_.nodes.cols(); ++a)
      if (used[a])
        file << a + 1 << ", " << mesh_.nodes(0, a) << ", " << mesh_.nodes(1, a) << ", " << mesh_.nodes(2, a) << "\n";
    file << "*ELEMENT, TYPE=C3D20R, ELSET=SOLID\n" << elements.str() << "*NSET, NSET=PLATE\n";
    for (const int a : mesh_.plate_k)
      if (used[a]) file << a + 1 << ",\n";
    file << "*MATERIAL, NAME=RUBBER\n*ELASTIC\n"
         << young << ", " << nu << "\n*SOLID SECTION, ELSET=SOLID, MATERIAL=RUBBER\n";
    for (int motion = 0; motion < 6; ++motion) {
      file << "*STEP\n*STATIC\n*BOUNDARY, OP=NEW\n";
      for (const int a : mesh_.plate_n)
        if (used[a]) file << a + 1 << ", 1, 3, 0\n";
      for (const int a : mesh_.plate_k) {
        if (!used[a]) continue;
        const Eigen::Vector3d u = spatial::rigid_motion(mesh_.nodes.col(a) - frame_.point_k).topRows<3>().col(motion);
        for (int c = 0; c < 3; ++c) file << a + 1 << ", " << c + 1 << ", " << c + 1 << ", " << u(c) << "\n";
      }
      file << "*NODE PRINT, NSET=PLATE\nRF\n*END STEP\n";
    }
  }

  const fem::Mesh& mesh_;
  fem::ElementFrame frame_;
  foundation::TemporaryFolder folder_;
};

TEST(SolidMount, AgreesWithCalculiX) {
  ASSERT_EQ(std::system("command -v ccx > /dev/null 2>&1"), 0) << "CalculiX is missing: scripts/packages tests";
  // Compressible enough that serendipity elements with reduced integration converge fast; both meshes are within a few
  // per mille.
  constexpr double young = 3e6, nu = 0.45, meshes = 0.005;
  const fem::Mesh mesh = fem::mesh(block, 3);
  const spatial::Matrix6 theirs = CalculiX(mesh, fem::frame(block), young, nu).stiffness();
  const spatial::Matrix6 ours =
      fem::condense(mesh, {fem::linear_elastic(young, nu)}, fem::frame(block)).stiffness.bottomRightCorner<6, 6>();
  const spatial::Vector6 scale = ours.diagonal().cwiseSqrt();
  EXPECT_THAT(theirs, test::NearInUnits(ours, scale, meshes));
}

}  // namespace solid_mount_agreement_test
