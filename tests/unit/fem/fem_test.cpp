// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <random>

#include "support/tetrahedra.h"
#include "trivet/elements/checks.h"
#include "trivet/elements/law.h"
#include "trivet/fem/element_kernel.h"
#include "trivet/fem/material.h"
#include "trivet/fem/mesh.h"
#include "trivet/fem/preload.h"
#include "trivet/fem/shapes.h"
#include "trivet/fem/substructuring.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"

namespace fem_test {

using namespace trivet;
using test::in_tetrahedra;
using testing::HasSubstr;

const fem::Material rubber = fem::neo_hookean(1e6, 2e9);
const fem::Disc cylinder{.diameter = 0.05, .layers = {{.thickness = 0.025}}};

Eigen::MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return uniform(generator); });
}

Eigen::Matrix3Xd nodes_of(const fem::Mesh& mesh, const Eigen::Matrix3Xd& all, Eigen::Index element) {
  return all(Eigen::all, Eigen::VectorXi(mesh.elements.col(element)));
}

std::vector<fem::Material> solids() {
  return {fem::neo_hookean(1, 50), fem::mooney_rivlin(0.4, 0.15, 50), fem::yeoh(0.5, -0.05, 0.02, 50)};
}

TEST(Hyperelastic, TangentIsTheSlopeOfTheStress) {
  constexpr double step = 1e-5,
                   truncation = 1e-8;  // central differences: step² of numbers around 1, and round-off over step
  const Eigen::Matrix3d f = Eigen::Matrix3d::Identity() + 0.2 * random_matrix(3, 3, 1);
  for (const fem::Material& material : solids()) {
    const fem::StressAndTangent here = fem::stress_and_tangent(material, f, 0.7);
    for (int k = 0; k < 9; ++k) {
      Eigen::Matrix3d more = f, less = f;
      more.reshaped()(k) += step;
      less.reshaped()(k) -= step;
      const Eigen::Matrix3d slope =
          (fem::stress_and_tangent(material, more, 0.7).stress - fem::stress_and_tangent(material, less, 0.7).stress) /
          (2 * step);
      EXPECT_LT((slope.reshaped() - here.tangent.col(k)).cwiseAbs().maxCoeff(), truncation);
    }
  }
}

TEST(Hyperelastic, UniaxialTensionFollowsTheInvariants) {
  // Incompressible bar at stretch λ: P = 2 (λ − λ⁻²)(W1 + W2/λ), Treloar; the pressure cancels the lateral stress.
  constexpr double stretch = 1.4, round_off = 1e-13;  // a few dozen operations on numbers up to 50
  const Eigen::Matrix3d f = Eigen::Vector3d(stretch, 1 / std::sqrt(stretch), 1 / std::sqrt(stretch)).asDiagonal();
  const double e = stretch * stretch + 2 / stretch - 3;
  for (const fem::Material& m : solids()) {
    const Eigen::Matrix3d free = fem::stress_and_tangent(m, f, 0).stress;
    const double pressure = -free(1, 1) / fem::cofactor(f)(1, 1);
    const double expected =
        2 * (stretch - 1 / (stretch * stretch)) * (m.c10 + 2 * m.c20 * e + 3 * m.c30 * e * e + m.c01 / stretch);
    EXPECT_NEAR(fem::stress_and_tangent(m, f, pressure).stress(0, 0), expected, round_off);
  }
}

TEST(FemElement, TangentIsTheSlopeOfTheForces) {
  constexpr double step = 1e-6,
                   truncation = 1e-6;  // central differences: step² of numbers up to 50, and their round-off over step
  for (const fem::Material& material : solids())
    for (const bool tetrahedra : {false, true}) {
      const fem::Mesh hexahedra = fem::mesh(fem::Disc{.diameter = 2, .layers = {{.thickness = 1}}}, 1);
      const fem::Mesh mesh = tetrahedra ? in_tetrahedra(hexahedra) : hexahedra;
      const Eigen::Matrix3Xd x = nodes_of(mesh, mesh.nodes, 3), u = 0.02 * random_matrix(3, x.cols(), 2);
      const Eigen::Vector4d p(0.1, -0.2, 0.3, 0.05);
      const auto at = [&](const Eigen::Matrix3Xd& v) {
        return fem::element_system(mesh.kind, fem::TetPressure::continuous, x, material, &v, &p);
      };
      const fem::ElementSystem here = at(u);
      for (const int k : {0, 5, 13, 26}) {
        Eigen::Matrix3Xd more = u, less = u;
        const Eigen::Index a = k % x.cols(), c = k / x.cols();
        more(c, a) += step;
        less(c, a) -= step;
        const Eigen::VectorXd slope = (at(more).force - at(less).force) / (2 * step);
        EXPECT_LT((slope - here.tangent.col(c * x.cols() + a)).cwiseAbs().maxCoeff(),
                  truncation * here.tangent.cwiseAbs().maxCoeff());
      }
    }
}

/// Forces on the inner nodes of a block with randomly displaced inner nodes, under a uniform deformation gradient.
double patch_unbalance(const fem::Mesh& regular, const Eigen::Matrix3d& gradient, const fem::Material& material,
                       double pressure) {
  fem::Mesh mesh = regular;
  const Eigen::Vector3d low = mesh.nodes.rowwise().minCoeff(), high = mesh.nodes.rowwise().maxCoeff();
  std::vector<bool> inside;
  for (Eigen::Index a = 0; a < mesh.nodes.cols(); ++a) {
    const Eigen::Vector3d x = mesh.nodes.col(a);
    inside.push_back((x - low).minCoeff() > 1e-9 && (high - x).minCoeff() > 1e-9);
  }
  const bool curved = mesh.kind == fem::Mesh::Kind::hex27;
  const Eigen::MatrixXd shift = 0.02 * random_matrix(3, mesh.nodes.cols(), 7);
  for (Eigen::Index a = 0; a < mesh.nodes.cols() && curved; ++a)
    if (inside[a]) mesh.nodes.col(a) += shift.col(a);
  Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, mesh.nodes.cols());
  const Eigen::Matrix3Xd all = (gradient - Eigen::Matrix3d::Identity()) * mesh.nodes;
  const Eigen::Vector4d corner_pressure = Eigen::Vector4d::Constant(pressure);
  double scale = 0;
  for (Eigen::Index e = 0; e < mesh.elements.cols(); ++e) {
    const Eigen::Matrix3Xd x = nodes_of(mesh, mesh.nodes, e), u = nodes_of(mesh, all, e);
    const fem::ElementSystem system =
        fem::element_system(mesh.kind, fem::TetPressure::continuous, x, material, &u, &corner_pressure);
    EXPECT_FALSE(system.inverted);
    scale = std::max(scale, system.force.cwiseAbs().maxCoeff());
    for (Eigen::Index i = 0; i < 3 * x.cols(); ++i)
      forces(i / x.cols(), mesh.elements(i % x.cols(), e)) += system.force(i);
  }
  double worst = 0;
  for (Eigen::Index a = 0; a < mesh.nodes.cols(); ++a)
    if (inside[a]) worst = std::max(worst, forces.col(a).cwiseAbs().maxCoeff());
  return worst / scale;
}

TEST(FemElement, PassesThePatchTestAtFiniteStrainOnDistortedElements) {
  // The rule of 3×3×3 points is exact here even on curved elements: gradient times determinant is a polynomial of
  // degree 5.
  constexpr double round_off = 1e-12;  // sums over 27 points of some hundred operations
  const fem::Mesh hexahedra = fem::mesh(fem::Block{.width = 1, .depth = 1, .layers = {{.thickness = 1}}}, 1);
  const Eigen::Matrix3d gradient = Eigen::Matrix3d::Identity() + 0.1 * random_matrix(3, 3, 3);
  for (const fem::Material& m : solids()) {
    EXPECT_LT(patch_unbalance(hexahedra, gradient, m, 0), round_off);
    EXPECT_LT(patch_unbalance(in_tetrahedra(hexahedra), gradient, m, m.bulk_modulus * (gradient.determinant() - 1)),
              round_off);
  }
}

TEST(Substructuring, GivesTheSchurComplementAndTheCondensedUnknowns) {
  constexpr double round_off = 1e-11;  // 61 eliminations, in another order than the factorization
  constexpr int elements = 60, inner = 61,
                retained = 2;  // an indefinite chain of elements with 3 unknowns, with loops to the retained ones
  std::vector<std::vector<int>> unknowns;
  std::vector<Eigen::MatrixXd> matrices;
  Eigen::Matrix3Xd centres = Eigen::Matrix3Xd::Zero(3, elements);
  Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(inner + retained, inner + retained);
  for (int e = 0; e < elements; ++e) {
    unknowns.push_back({e, e + 1, inner + e % 2});
    const Eigen::MatrixXd a = random_matrix(3, 3, static_cast<unsigned>(e));
    matrices.emplace_back((a + a.transpose()).eval() + 4 * (e < 30 ? 1 : -1) * Eigen::MatrixXd::Identity(3, 3));
    centres(0, e) = e;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) whole(unknowns.back()[i], unknowns.back()[j]) += matrices.back()(i, j);
  }
  fem::Substructuring substructuring(unknowns, centres, inner, retained);
  const Eigen::MatrixXd solution = whole.topLeftCorner(inner, inner).lu().solve(whole.topRightCorner(inner, retained));
  const Eigen::MatrixXd expected =
      whole.bottomRightCorner(retained, retained) - whole.bottomLeftCorner(retained, inner) * solution;
  const auto matrix = [&](int e) { return matrices[e]; };
  const auto one = substructuring.condense(matrix, true, 1, {}), two = substructuring.condense(matrix, true, 2, {});
  EXPECT_LT((one.matrix - expected).cwiseAbs().maxCoeff(), round_off * expected.cwiseAbs().maxCoeff());
  EXPECT_EQ(one.matrix, two.matrix);
  const Eigen::Vector2d moved(0.3, -0.7);
  EXPECT_LT((substructuring.recover(moved).head(inner) + solution * moved).cwiseAbs().maxCoeff(),
            round_off * solution.cwiseAbs().maxCoeff());
}

TEST(PartialElimination, GivesTheSchurComplementOfManyBlocksAndTheEliminatedUnknowns) {
  constexpr double round_off = 1e-11;
  constexpr Eigen::Index all = 320, condensed = 230, retained = all - condensed;
  // Positive and negative pivots, as of displacements and pressures; zeros on the diagonal of whole blocks would not
  // do.
  const Eigen::MatrixXd random = random_matrix(all, all, 5);
  Eigen::MatrixXd whole = random + random.transpose();
  for (Eigen::Index i = 0; i < all; ++i) whole(i, i) = i % 3 == 0 ? -60 : 60;
  const Eigen::MatrixXd solution =
      whole.topLeftCorner(condensed, condensed).lu().solve(whole.topRightCorner(condensed, retained));
  const Eigen::MatrixXd expected =
      whole.bottomRightCorner(retained, retained) - whole.bottomLeftCorner(retained, condensed) * solution;
  const auto negative =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(whole.topLeftCorner(condensed, condensed), Eigen::EigenvaluesOnly)
          .eigenvalues();
  Eigen::MatrixXd lower = whole.triangularView<Eigen::Lower>();
  const fem::Pivots pivots = fem::eliminate_leading(lower, condensed, 2);
  EXPECT_EQ(pivots.negative, (negative.array() < 0).count());
  EXPECT_FALSE(pivots.singular);
  const Eigen::MatrixXd error = lower.bottomRightCorner(retained, retained) - expected;
  EXPECT_LT(Eigen::MatrixXd(error.triangularView<Eigen::Lower>()).cwiseAbs().maxCoeff(), round_off * 60);
  Eigen::VectorXd values = Eigen::VectorXd::Zero(all);
  values.tail(retained).setLinSpaced(-1, 1);
  const Eigen::VectorXd eliminated = -solution * values.tail(retained);
  fem::recover_leading(lower.leftCols(condensed), values);
  EXPECT_LT((values.head(condensed) - eliminated).cwiseAbs().maxCoeff(), round_off);
}

TEST(Bisection, CutsWhereTheFewestUnknownsAreShared) {
  // A row of elements, each with three unknowns in common with the next, but one between the fourth and the fifth.
  std::vector<std::vector<int>> unknowns(9);
  int count = 0;
  for (std::size_t e = 0; e + 1 < unknowns.size(); ++e)
    for (int i = 0; i < (e == 3 ? 1 : 3); ++i, ++count) {
      unknowns[e].push_back(count);
      unknowns[e + 1].push_back(count);
    }
  Eigen::Matrix3Xd centres = Eigen::Matrix3Xd::Zero(3, 9);
  centres.row(1).setLinSpaced(9, 1, 0);
  for (int e = 0; e < 9; ++e) centres(0, e) = centres(2, e) = (4 * e) % 9;  // neighbours are far apart here
  std::vector<int> elements{4, 0, 8, 2, 6, 1, 3, 7, 5};
  EXPECT_EQ(fem::Bisection(unknowns, centres, count).halve(elements), 5);
  EXPECT_THAT(elements, testing::ElementsAre(8, 7, 6, 5, 4, 3, 2, 1, 0));
}

TEST(FemCondensation, IsAPassiveStressFreeElementInSkewAxes) {
  constexpr double round_off = 1e-10;  // all eliminations; the bulk modulus is 2000 times the shear modulus
  fem::ElementFrame skew = fem::frame(cylinder);
  skew.point_n = Eigen::Vector3d(0.003, -0.002, -0.001);
  skew.axes = Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const fem::SolidStiffness solid = fem::condense(fem::mesh(cylinder, 1), {rubber}, skew);
  const Eigen::Vector3d arm = skew.axes.transpose() * (skew.point_k - skew.point_n);
  const auto verdict = elements::examine(solid.stiffness, elements::rigid_motions(arm, Eigen::Matrix3d::Identity()));
  EXPECT_LT(verdict.asymmetry, elements::rounding_of_data);
  EXPECT_LT(verdict.rigid_residual, elements::silent_residual);
  EXPECT_TRUE(elements::is_semidefinite(verdict));
  EXPECT_LT(solid.rigid_residual, round_off);
}

TEST(FemCondensation, DoesNotDependOnTheNumberOfThreads) {
  const fem::Mesh mesh = fem::mesh(cylinder, 2);
  EXPECT_EQ(fem::condense(mesh, {rubber}, fem::frame(cylinder), {.threads = 1}).stiffness,
            fem::condense(mesh, {rubber}, fem::frame(cylinder), {.threads = 2}).stiffness);
}

TEST(FemCondensation, CanBeInterruptedAndRespectsItsMemoryLimit) {
  const fem::Mesh mesh = fem::mesh(cylinder, 2);
  const foundation::Progress stop = [](std::string_view, double) { throw foundation::Interrupted(); };
  EXPECT_THROW((void)fem::condense(mesh, {rubber}, fem::frame(cylinder), {.threads = 2}, stop),
               foundation::Interrupted);
  try {
    (void)fem::condense(mesh, {rubber}, fem::frame(cylinder), {.memory_limit = 1e5});
    FAIL();
  } catch (const foundation::InvalidInput& refused) {
    EXPECT_THAT(refused.what(), HasSubstr("use a coarser mesh or raise the limit"));
  }
}

std::string first_finding(const fem::Mesh& mesh, const std::vector<fem::Material>& materials) {
  const foundation::Problems problems = fem::check_mesh(mesh, materials);
  return problems.list().empty() ? "" : foundation::message(problems.list().front());
}

TEST(FemChecks, NameWhatIsWrongWithAMesh) {
  const fem::Mesh sound = fem::mesh(cylinder, 1);
  EXPECT_EQ(first_finding(sound, {rubber}), "");
  const auto finding = [&](auto spoil) {
    fem::Mesh mesh = sound;
    spoil(mesh);
    EXPECT_THROW((void)fem::condense(mesh, {rubber}, fem::frame(cylinder)), foundation::InvalidInput);
    return first_finding(mesh, {rubber});
  };
  EXPECT_THAT(finding([](fem::Mesh& m) { m.plate_k.clear(); }), HasSubstr("plate K must be bonded"));
  EXPECT_THAT(finding([](fem::Mesh& m) { m.plate_k.push_back(m.plate_n.front()); }),
              HasSubstr("1 nodes also belong to plate N"));
  EXPECT_THAT(finding([](fem::Mesh& m) { m.material[2] = 1; }), HasSubstr("element 2 has material 1"));
  EXPECT_THAT(finding([](fem::Mesh& m) { m.elements.col(1) = Eigen::VectorXi(m.elements.col(1).reverse()); }),
              HasSubstr("flat or inverted"));
  EXPECT_THAT(finding([](fem::Mesh& m) { m.nodes.row(2).setZero(); }), HasSubstr("volume"));
  EXPECT_THAT(finding([](fem::Mesh& m) { m.elements(0, 0) = 100000; }), HasSubstr("a node number that does not exist"));
  EXPECT_THAT(finding([](fem::Mesh& m) { m.nodes(0, 0) = std::nan(""); }), HasSubstr("not a finite number"));
  EXPECT_THAT(finding([](fem::Mesh& m) { m.elements.resize(27, 0); }), HasSubstr("no elements"));
  EXPECT_THAT(finding([](fem::Mesh& m) {  // a second, loose cylinder
                const Eigen::Index n = m.nodes.cols(), e = m.elements.cols();
                m.nodes.conservativeResize(3, 2 * n);
                m.nodes.rightCols(n) = m.nodes.leftCols(n).colwise() + Eigen::Vector3d(1, 0, 0);
                m.elements.conservativeResize(27, 2 * e);
                m.elements.rightCols(e) = m.elements.leftCols(e).array() + static_cast<int>(n);
                m.material.resize(to_size(2 * e), 0);
              }),
              HasSubstr("is not bonded to a plate"));
  EXPECT_THAT(first_finding(sound, {fem::Material{.c10 = -1, .bulk_modulus = 1}}), HasSubstr("must be > 0"));
  EXPECT_THROW((void)fem::linear_elastic(3e6, 0.5), foundation::InvalidInput);
  EXPECT_THROW((void)fem::mesh(fem::Bush{.inner_diameter = 0.02, .outer_diameter = 0.01, .length = 0.1}, 1),
               foundation::InvalidInput);
}

}  // namespace fem_test
