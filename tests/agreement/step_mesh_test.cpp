// SPDX-License-Identifier: BSD-3-Clause
// A mount from a STEP file against the same mount from its parameters: tetrahedra of the mesher against structured
// hexahedra.
#include <gmock/gmock.h>

#include "support/matchers.h"
#include "support/step_shapes.h"
#include "trivet/fem/condensation.h"
#include "trivet/fem/shapes.h"
#include "trivet/fem/step_mesh.h"
#include "trivet/foundation/temporary_folder.h"

namespace step_mesh_test {

using namespace trivet;
using namespace trivet::fem;

constexpr double mm = 1e-3;
const std::vector<Material> rubber{linear_elastic(3e6, 0.4995)};

TEST(StepMount, BondedCylinderAgreesWithHexahedra) {
  const foundation::TemporaryFolder folder;
  test::write_step(folder.path() / "mount.step", "Cylinder(1) = {0, 0, 0, 0, 0, 25, 25};");
  const auto step = mesh_step(folder.path() / "mount.step", {.size = 5 * mm, .rim_size = 1.2 * mm});
  ASSERT_TRUE(step);
  const SolidStiffness tetrahedra =
      condense(step->mesh, rubber, {step->centre_n, step->centre_k, Eigen::Matrix3d::Identity()});
  const SolidStiffness hexahedra = condense(Disc{50 * mm, {{25 * mm, 0, false}}}, rubber);
  constexpr double discretisation =
      0.005;  // the two kinds of tetrahedra differ by some 0.5 % on such a mesh; their mean is more accurate
  for (int i = 6; i < 12; ++i)
    EXPECT_THAT(tetrahedra.stiffness(i, i), test::RelativelyNear(hexahedra.stiffness(i, i), discretisation))
        << "coordinate " << i;
  constexpr double uneven_mesh = 0.002;  // the mesh is not symmetric
  EXPECT_THAT(tetrahedra.stiffness(6, 6), test::RelativelyNear(tetrahedra.stiffness(7, 7), uneven_mesh));
}

}  // namespace step_mesh_test
