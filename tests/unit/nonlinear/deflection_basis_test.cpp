// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/deflection_basis.h"

#include <gmock/gmock.h>

#include <Eigen/QR>

#include "support/projects.h"
#include "trivet/foundation/index.h"

namespace deflection_basis_test {

using namespace trivet;
using Eigen::Index;
using Eigen::MatrixXd;

struct Machine {
  explicit Machine(const std::string& text)
      : given(test::project(text).base().system),
        references(nonlinear::positive_references(given)),
        system(nonlinear::with_references(given, references)),
        assembled(assembly::assemble(system)),
        deflections(nonlinear::nonlinear_deflections(system, assembled, references)) {}

  /// Coordinates, and those of the ground below them, × deflections.
  [[nodiscard]] MatrixXd rows(bool with_ground) const {
    const Index n = assembled.matrices.size(), ground = with_ground ? assembled.ground.size() : 0;
    MatrixXd found(n + ground, to_index(deflections.size()));
    for (Index j = 0; j < found.cols(); ++j)
      found.col(j) << deflections[to_size(j)].on_coordinates, deflections[to_size(j)].on_ground.head(ground);
    return found;
  }

  model::System given;
  nonlinear::References references;
  model::System system;
  assembly::Assembled assembled;
  std::vector<nonlinear::Deflection> deflections;
};

void expect_basis(const Machine& machine, bool ground_moves, Index rank) {
  constexpr double round_off = 1e-12;
  const nonlinear::DeflectionBasis basis =
      nonlinear::deflection_basis(machine.assembled, machine.deflections, ground_moves);
  const MatrixXd rows = machine.rows(ground_moves);
  EXPECT_EQ(basis.size(), rank);
  Eigen::ColPivHouseholderQR<MatrixXd> factors(rows);  // a rank by another method
  factors.setThreshold(1e-9);
  EXPECT_EQ(basis.size(), factors.rank());
  const MatrixXd independent = rows(Eigen::all, basis.independent);
  EXPECT_LT((independent * basis.spread - rows).cwiseAbs().maxCoeff(), round_off);
}

const std::string two_struts = R"(trivet = 1
[bodies.m]
mass = 25
inertia = {about = "center_of_mass", xx = 1, yy = 1, zz = 1}
free = FREE
[elements.up]
type = "three_springs"
on = "m"
at = [0, 0, 0]
translation = [900, 800, 3201]
rotation = [50, 50, 50]
[elements.l]
type = "strut"
on = "m"
at = [0, 0, 0]
from_at = [-0.1, 0.02, 0.03]
free_length = 0.14
stiffness = 4000
[elements.r]
type = "strut"
on = "m"
at = [0.01, 0, 0]
from_at = [0.1, 0, 0.01]
free_length = 0.14
stiffness = 4000
)";

std::string with_free(const std::string& free) {
  std::string text = two_struts;
  return text.replace(text.find("FREE"), 4, free);
}

TEST(DeflectionBasis, TwoStrutsOnOneCoordinateHaveOneMotion) {
  const Machine machine(with_free("[\"z\"]"));
  ASSERT_EQ(machine.deflections.size(), 6u);
  expect_basis(machine, false, 1);
}

TEST(DeflectionBasis, ABodyHasAtMostSixMotions) {
  expect_basis(Machine(with_free("[\"x\", \"y\", \"z\", \"rx\", \"ry\", \"rz\"]")), false, 5);
  std::string mounts = R"(trivet = 1
[bodies.p]
mass = 260
inertia = {about = "center_of_mass", xx = 12, yy = 24, zz = 22}
[element_types.rope]
type = "bushing"
translation = [70e3, 70e3, 120e3]
laws.x = {cubic = 1e9}
laws.y = {cubic = 1e9}
laws.z = {cubic = 1e9}
[tables.elements]
rows = [
)";
  int count = 0;
  for (const std::string row : {"0.5, 0.2, 0.1", "-0.4, 0.3, 0", "0.5, -0.25, 0", "-0.6, -0.2, -0.1"})
    mounts += "  {name = \"m" + std::to_string(count++) + "\", type = \"rope\", on = \"p\", at = [" + row + "]},\n";
  const Machine machine(mounts + "]\n");
  ASSERT_EQ(machine.deflections.size(), 12u);
  expect_basis(machine, false, 6);
  expect_basis(machine, true, 6);  // the ground moves as one body
}

}  // namespace deflection_basis_test
