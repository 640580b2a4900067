// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "support/matchers.h"
#include "support/step_shapes.h"
#include "support/stl_shapes.h"
#include "trivet/fem/mesh.h"
#include "trivet/fem/msh_file.h"
#include "trivet/fem/step_mesh.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/temporary_folder.h"

namespace step_mesh_test {

using namespace trivet;
using namespace trivet::fem;
using std::numbers::pi;
using ::testing::AllOf;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::SizeIs;

constexpr double mm = 1e-3;
constexpr double on_the_face = 1e-9;       // [m] nodes are written with 16 digits
constexpr double quadrature_error = 1e-9;  // relative, of the areas and volumes that gmsh integrates
constexpr double printed_digits = 1e-12;   // 16 digits of lengths up to 50 mm, and of their products
const Material rubber = neo_hookean(1e6, 1e9);

class StepMeshing : public ::testing::Test {
 protected:
  std::filesystem::path step(const std::string& commands) const {
    test::write_step(folder_.path() / "part.step", commands);
    return folder_.path() / "part.step";
  }
  std::filesystem::path cylinder() const { return step("Cylinder(1) = {0, 0, 0, 0, 0, 25, 25};"); }
  static std::string messages(const foundation::Expected<StepMesh>& mesh) {
    std::string text;
    if (!mesh)
      for (const foundation::Problem& problem : mesh.error().list()) text += message(problem) + "\n";
    return text;
  }
  static StepMeshOptions coarse() { return {.size = 8 * mm, .rim_size = 3 * mm}; }

 private:
  foundation::TemporaryFolder folder_;
};

/// Mean edge of the elements with a corner within `distance` of the rims (radius 25 mm at the plates) if `near`, else
/// of the others.
double mean_edge(const Mesh& mesh, double distance, bool near) {
  double sum = 0;
  int count = 0;
  for (Eigen::Index e = 0; e < mesh.elements.cols(); ++e) {
    const Eigen::Vector3d a = mesh.nodes.col(mesh.elements(0, e)), b = mesh.nodes.col(mesh.elements(1, e));
    const double rim = std::hypot(a.head<2>().norm() - 25 * mm, std::min(a.z(), 25 * mm - a.z()));
    if ((rim < distance) == near) sum += (b - a).norm(), ++count;
  }
  return sum / count;
}

TEST_F(StepMeshing, BondsTheTwoEndsOfACylinder) {
  const auto step = mesh_step(cylinder(), coarse());
  ASSERT_TRUE(step) << messages(step);
  const Mesh& mesh = step->mesh;
  EXPECT_THAT(check_mesh(mesh, {rubber}).list(), ::testing::IsEmpty());
  EXPECT_EQ(mesh.elements.rows(), 10);
  EXPECT_EQ(mesh.material.size(), to_size(mesh.elements.cols()));
  for (const int node : mesh.plate_n) EXPECT_NEAR(mesh.nodes(2, node), 0, on_the_face);
  for (const int node : mesh.plate_k) EXPECT_NEAR(mesh.nodes(2, node), 25 * mm, on_the_face);
  std::vector<int> on_end;
  for (int node = 0; node < mesh.nodes.cols(); ++node)
    if (std::abs(mesh.nodes(2, node)) < on_the_face) on_end.push_back(node);
  EXPECT_EQ(mesh.plate_n, on_end) << "every node of the end, ascending";
  EXPECT_THAT(step->volume, test::RelativelyNear(pi * 25 * 25 * 25 * mm * mm * mm, quadrature_error));
  EXPECT_LE((step->centre_n - Eigen::Vector3d(0, 0, 0)).norm(), on_the_face);
  EXPECT_LE((step->centre_k - Eigen::Vector3d(0, 0, 25 * mm)).norm(), on_the_face);
}

TEST_F(StepMeshing, FollowsCurvedSurfacesAtSecondOrder) {
  const auto step = mesh_step(cylinder(), coarse());
  ASSERT_TRUE(step);
  int outside = 0;
  for (Eigen::Index t = 0; t < step->mesh.nodes.cols(); ++t)
    outside += step->mesh.nodes.col(t).head<2>().norm() > 25 * mm + on_the_face;
  EXPECT_EQ(outside, 0);
  const auto middle_on_surface = [&](Eigen::Index e) {  // node 4 is the middle of the edge 0–1
    const auto radius = [&](int k) { return step->mesh.nodes.col(step->mesh.elements(k, e)).head<2>().norm(); };
    return radius(0) > 25 * mm - on_the_face && radius(1) > 25 * mm - on_the_face && radius(4) > 25 * mm - on_the_face;
  };
  int curved = 0;
  for (Eigen::Index e = 0; e < step->mesh.elements.cols(); ++e) curved += middle_on_surface(e);
  EXPECT_GT(curved, 10);
}

TEST_F(StepMeshing, IsFinerAtTheRims) {
  const auto step = mesh_step(cylinder(), {.size = 6 * mm, .rim_size = 1.5 * mm});
  ASSERT_TRUE(step);
  constexpr double rim_scatter = 0.6 * mm, inner_scatter = 1.5 * mm;  // a mesher meets sizes on average only
  EXPECT_NEAR(mean_edge(step->mesh, 1 * mm, true), 1.5 * mm, rim_scatter);
  EXPECT_NEAR(mean_edge(step->mesh, 10 * mm, false), 6 * mm, inner_scatter);
}

TEST_F(StepMeshing, GivesTheSameMeshForTheSameFile) {
  const std::filesystem::path file = cylinder();
  const auto one = mesh_step(file, coarse()), two = mesh_step(file, coarse());
  ASSERT_TRUE(one && two);
  EXPECT_EQ(one->mesh.nodes, two->mesh.nodes);
  EXPECT_EQ(one->mesh.elements, two->mesh.elements);
  EXPECT_EQ(one->mesh.plate_n, two->mesh.plate_n);
}

TEST_F(StepMeshing, ScalesTheSolid) {
  StepMeshOptions doubled = coarse();
  doubled.size *= 2, doubled.rim_size *= 2, doubled.scale = 2;
  const std::filesystem::path file = cylinder();
  const auto one = mesh_step(file, coarse()), two = mesh_step(file, doubled);
  ASSERT_TRUE(one && two);
  ASSERT_EQ(one->mesh.nodes.cols(), two->mesh.nodes.cols());
  EXPECT_LE((2 * one->mesh.nodes - two->mesh.nodes).cwiseAbs().maxCoeff(), printed_digits);
  EXPECT_THAT(two->volume, test::RelativelyNear(8 * one->volume, printed_digits));
}

TEST_F(StepMeshing, JoinsTouchingSolidsAndNumbersThemAsMaterials) {
  const auto step = mesh_step(
      this->step("Box(1) = {0, 0, 0, 20, 20, 10}; Box(2) = {5, 5, 10, 10, 10, 4}; Box(3) = {0, 0, 14, 20, 20, 10};"),
      {.size = 8 * mm, .rim_size = 5 * mm});
  ASSERT_TRUE(step) << messages(step);
  EXPECT_EQ(step->solids, 3);
  EXPECT_THAT(check_mesh(step->mesh, {rubber, rubber, rubber}).list(), ::testing::IsEmpty())
      << "one piece from plate to plate";
  for (Eigen::Index e = 0; e < step->mesh.elements.cols(); ++e) {
    double z = 0;
    for (int k = 0; k < 4; ++k) z += step->mesh.nodes(2, step->mesh.elements(k, e)) / 4;
    EXPECT_EQ(step->mesh.material[e], z < 10 * mm ? 0 : z < 14 * mm ? 1 : 2);
  }
}

TEST_F(StepMeshing, RejectsSolidsThatOverlap) {
  EXPECT_THAT(messages(mesh_step(step("Box(1) = {0, 0, 0, 20, 20, 10}; Box(2) = {0, 0, 8, 20, 20, 10};"), coarse())),
              HasSubstr("overlap"));
}

TEST_F(StepMeshing, BondsTheSleevesOfABush) {
  StepMeshOptions options{.size = 5 * mm, .rim_size = 3 * mm};
  options.plate_n = FacesOnCylinder{10 * mm};
  options.plate_k = FacesOnCylinder{20 * mm};
  const auto bush = mesh_step(step("Cylinder(1) = {0, 0, -15, 0, 0, 30, 20}; Cylinder(2) = {0, 0, -15, 0, 0, 30, 10};"
                                   "BooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };"),
                              options);
  ASSERT_TRUE(bush) << messages(bush);
  EXPECT_THAT(check_mesh(bush->mesh, {rubber}).list(), ::testing::IsEmpty());
  for (const int node : bush->mesh.plate_n)
    EXPECT_NEAR(bush->mesh.nodes.col(node).head<2>().norm(), 10 * mm, on_the_face);
  for (const int node : bush->mesh.plate_k)
    EXPECT_NEAR(bush->mesh.nodes.col(node).head<2>().norm(), 20 * mm, on_the_face);
  EXPECT_LE(bush->centre_n.norm(), on_the_face);
  ASSERT_THAT(bush->faces_k, SizeIs(1));
  EXPECT_THAT(bush->faces_k[0].area, test::RelativelyNear(2 * pi * 20 * 30 * mm * mm, quadrature_error));
}

TEST_F(StepMeshing, BondsFacesByBoxAndByNumber) {
  StepMeshOptions options = coarse();
  options.plate_n = FacesInBox{Eigen::Vector3d(-30, -30, -1) * mm, Eigen::Vector3d(30, 30, 1) * mm};
  const std::filesystem::path file = cylinder();
  const auto by_box = mesh_step(file, options);
  ASSERT_TRUE(by_box) << messages(by_box);
  options.plate_n = FacesByNumber{{by_box->faces_n.at(0).number}};
  const auto by_number = mesh_step(file, options), by_default = mesh_step(file, coarse());
  ASSERT_TRUE(by_number && by_default);
  EXPECT_EQ(by_number->mesh.plate_n, by_default->mesh.plate_n);
  EXPECT_EQ(by_box->mesh.plate_n, by_default->mesh.plate_n);
}

TEST_F(StepMeshing, APlateWithoutFaceIsRejectedWithAListOfTheFaces) {
  StepMeshOptions options = coarse();
  options.plate_n = FurthestFaces{{1, 0, 0}};
  options.plate_k = FacesByNumber{{2, 17}};
  EXPECT_THAT(messages(mesh_step(cylinder(), options)),
              AllOf(HasSubstr("plate_n: no plane face normal to (1, 0, 0)"), HasSubstr("plate_k: no face 17"),
                    HasSubstr("at (0, 0, 0.025) m with 0.001963 m²")));
  options.plate_n = options.plate_k = FacesByNumber{{2}};
  EXPECT_THAT(messages(mesh_step(cylinder(), options)), HasSubstr("face 2 is also bonded to plate N"));
  options.plate_k = FacesOnCylinder{26 * mm};
  EXPECT_THAT(messages(mesh_step(cylinder(), options)), HasSubstr("no face on the cylinder of radius 0.026 m"));
}

TEST_F(StepMeshing, RejectsInvalidSizes) {
  EXPECT_THAT(messages(mesh_step("none.step", {})), HasSubstr("size: not given"));
  EXPECT_THAT(messages(mesh_step("none.step", {.size = -1, .rim_distance = -1, .scale = 0})),
              AllOf(HasSubstr("size: -1"), HasSubstr("rim_distance: -1"), HasSubstr("scale: 0")));
  EXPECT_THAT(messages(mesh_step("none.step", {.size = 1 * mm, .rim_size = 2 * mm})), HasSubstr("between 0 and size"));
  EXPECT_THAT(messages(mesh_step(cylinder(), {.size = 1e-3 * mm})),
              AllOf(HasSubstr("size"), HasSubstr("use a size above")));
  EXPECT_THAT(messages(mesh_step("none.step", coarse())), HasSubstr("none.step: cannot be read"));
  EXPECT_THROW((void)step_faces("none.step", -1), foundation::InvalidInput);
}

TEST_F(StepMeshing, EndsAtItsTimeLimitWithAMessage) {
  StepMeshOptions options{.size = 0.8 * mm};
  options.time_limit = 0.3;
  EXPECT_THAT(messages(mesh_step(cylinder(), options)), HasSubstr("gmsh had not finished after 0.3 s"));
}

TEST(MshFile, RejectsInvalidContent) {
  const foundation::TemporaryFolder folder;
  for (const char* text :
       {"", "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n2\n1 0 0 0\n",
        "$MeshFormat\n2.2 0 8\n$Nodes\n1\n1 0 0 0\n$EndNodes\n$Elements\n1\n1 9 2 0 1 1 2 3 4 5 6\n$EndElements\n",
        "$MeshFormat\n2.2 0 8\n$Nodes\n99999999999\n"}) {
    test::write_file(folder.path() / "mesh.msh", text);
    EXPECT_FALSE(read_msh(folder.path() / "mesh.msh")) << text;
  }
  EXPECT_FALSE(read_msh(folder.path() / "missing.msh"));
}

}  // namespace step_mesh_test
