// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/nonlinear/machine/condensed_machine.h"

#include <gmock/gmock.h>

#include <Eigen/QR>

#include "support/projects.h"
#include "trivet/foundation/index.h"
#include "trivet/nonlinear/machine/periodic_excitation.h"

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

  /// Coordinates × deflections.
  [[nodiscard]] MatrixXd rows() const {
    MatrixXd found(assembled.matrices.size(), to_index(deflections.size()));
    for (Index j = 0; j < found.cols(); ++j) found.col(j) = deflections[j].on_coordinates;
    return found;
  }

  model::System given;
  nonlinear::References references;
  model::System system;
  assembly::Assembled assembled;
  std::vector<nonlinear::Deflection> deflections;
};

void expect_basis(const Machine& machine, Index rank) {
  constexpr double round_off = 1e-12;
  const nonlinear::PeriodicExcitation excitation =
      nonlinear::periodic_excitation(machine.system, machine.assembled, {});
  const nonlinear::DeflectionBasis basis =
      nonlinear::CondensedMachine(machine.assembled, machine.deflections, excitation).basis();
  const MatrixXd rows = machine.rows();
  EXPECT_EQ(basis.size(), rank);
  Eigen::ColPivHouseholderQR<MatrixXd> factors(rows);  // a rank by another method
  factors.setThreshold(1e-9);
  EXPECT_EQ(basis.size(), factors.rank());
  const MatrixXd independent = rows(Eigen::all, basis.independent);
  EXPECT_LT((independent * basis.spread - rows).cwiseAbs().maxCoeff(), round_off);
  for (const assembly::Loading& loading : excitation.loadings)
    for (const numerics::LoadTerm& term : loading.motion.terms()) {
      Eigen::VectorXcd moved(rows.cols());  // by the ground alone
      for (Index j = 0; j < moved.size(); ++j)
        moved(j) = (machine.deflections[j].on_ground.transpose() * term.value)(0);
      const Eigen::VectorXcd found = basis.spread.transpose() * moved(basis.independent);
      EXPECT_LT((found - moved).norm(), round_off * moved.norm());
    }
}

const std::string two_struts = R"(trivet = 1
[bodies.m]
mass = 25
inertia = {about = "center_of_mass", xx = 1, yy = 1, zz = 1}
free = FREE
[elements.up]
type = "bushing"
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

const std::string force = "[excitations.F]\ntype = \"harmonic\"\non = \"BODY\"\nat = [0, 0, 0]\nforce = [0, 0, 3]\n";

std::string force_on(const std::string& body) {
  std::string text = force;
  return text.replace(text.find("BODY"), 4, body);
}

std::string with_free(const std::string& free) {
  std::string text = two_struts;
  return text.replace(text.find("FREE"), 4, free) + force_on("m");
}

TEST(DeflectionBasis, TwoStrutsOnOneCoordinateHaveOneMotion) {
  const Machine machine(with_free("[\"z\"]"));
  ASSERT_EQ(machine.deflections.size(), 6u);
  expect_basis(machine, 1);
}

TEST(DeflectionBasis, ABodyHasAtMostSixMotions) {
  expect_basis(Machine(with_free("[\"x\", \"y\", \"z\", \"rx\", \"ry\", \"rz\"]")), 5);
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
  const Machine machine(mounts + "]\n" + force_on("p"));
  ASSERT_EQ(machine.deflections.size(), 12u);
  expect_basis(machine, 6);
  const std::string sea = "[excitations.sea]\ntype = \"base\"\ntranslation = [0.001, 0.002, 0.003]\n";
  expect_basis(Machine(mounts + "]\n" + sea), 6);  // all feet move as one
}

TEST(DeflectionBasis, ExcludesTheInnerCoordinatesOfAMountThatDependsOnFrequency) {
  const std::string mounts = R"(trivet = 1
[bodies.p]
mass = 260
inertia = {about = "center_of_mass", xx = 12, yy = 24, zz = 22}
[elements.rubber]
type = "bushing"
on = "p"
at = [0, 0, 0]
translation = [70e3, 70e3, 120e3]
rotation = [20e3, 20e3, 20e3]
damping = {fractional_zener = {ratio = 1.5, time = 1e-3, order = 0.6}}
[elements.rope]
type = "bushing"
on = "p"
at = [0.5, 0.2, 0.1]
translation = [70e3, 70e3, 120e3]
laws.x = {cubic = 1e9}
laws.y = {cubic = 1e9}
laws.z = {cubic = 1e9}
)";
  const Machine machine(mounts + force_on("p"));
  ASSERT_GT(machine.assembled.matrices.size(), machine.assembled.constant.size());
  ASSERT_EQ(machine.deflections.size(), 3u);
  expect_basis(machine, 3);
}

}  // namespace deflection_basis_test
