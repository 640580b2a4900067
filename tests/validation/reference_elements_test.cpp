// SPDX-License-Identifier: BSD-3-Clause
// Elements against published 12×12 matrices and against the paper's K.
#include <gmock/gmock.h>

#include <numbers>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/elements/checks.h"
#include "trivet/elements/law.h"
#include "trivet/judging/read_project.h"

namespace reference_elements_test {

using namespace trivet;
using elements::Matrix12;
using test::RelativelyNear;

/// Largest deviation over √(K_ii K_jj).
double scaled_difference(const Matrix12& a, const Matrix12& b) {
  double worst = 0;
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j) worst = std::max(worst, std::abs(a(i, j) - b(i, j)) / std::sqrt(b(i, i) * b(j, j)));
  return worst;
}

TEST(Cbush, AFiniteLengthBushingHasTheMomentArmsOfNastran) {
  // Nastran CBUSH semantics, spring at half of the length; matrix as published with MYSTRAN issue 7, load case of
  // issue 12.
  constexpr double round_off = 1e-10;  // the entries are exact; some ten operations
  const double L = 10, k[] = {1e5, 2e5, 3e5, 4e4, 5e4, 6e4};
  Matrix12 expected = Matrix12::Zero();
  const auto set = [&](int i, int j, double value) { expected(i - 1, j - 1) = expected(j - 1, i - 1) = value; };
  for (int i = 0; i < 4; ++i) set(i + 1, i + 1, k[i]), set(i + 7, i + 7, k[i]), set(i + 1, i + 7, -k[i]);
  set(2, 6, 1e6), set(2, 12, 1e6), set(6, 8, -1e6), set(8, 12, -1e6);
  set(3, 5, -1.5e6), set(3, 11, -1.5e6), set(5, 9, 1.5e6), set(9, 11, 1.5e6);
  set(5, 5, 7.55e6), set(11, 11, 7.55e6), set(5, 11, 7.45e6);
  set(6, 6, 5.06e6), set(12, 12, 5.06e6), set(6, 12, 4.94e6);
  elements::Vector6 constants;
  constants << k[0], k[1], k[2], k[3], k[4], k[5];
  EXPECT_LE(scaled_difference(elements::constants_at_point(constants, {L, 0, 0}, 0.5), expected), round_off);

  const Eigen::Matrix<double, 6, 6> moved_end =
      elements::constants_at_point(constants, {L, 0, 0}, 0.5).bottomRightCorner<6, 6>();
  elements::Vector6 load = elements::Vector6::Zero(), displacement;
  load(2) = 1000;
  displacement << 0, 0, 0.5033333333333333, 0, -0.1, 0;
  EXPECT_THAT((moved_end * displacement).eval(), test::NearVector(load, round_off));
}

/// Matrix of a straight Euler–Bernoulli beam of round section along x, nodes 1 (ground) and 2.
Matrix12 textbook_beam(double E, double G, double d, double L) {
  const double A = std::numbers::pi * d * d / 4, I = std::numbers::pi * std::pow(d, 4) / 64, J = 2 * I;
  Matrix12 k = Matrix12::Zero();
  const auto set = [&](int i, int j, double value) { k(i, j) = k(j, i) = value; };
  const double a = E * A / L, t = G * J / L, s = 12 * E * I / std::pow(L, 3), c = 6 * E * I / (L * L),
               b = 4 * E * I / L;
  set(0, 0, a), set(6, 6, a), set(0, 6, -a), set(3, 3, t), set(9, 9, t), set(3, 9, -t);
  for (const auto& [u, r, sign] : {std::array{1, 5, 1}, {2, 4, -1}}) {
    set(u, u, s), set(u + 6, u + 6, s), set(u, u + 6, -s), set(r, r, b), set(r + 6, r + 6, b), set(r, r + 6, b / 2);
    set(u, r, sign * c), set(u, r + 6, sign * c), set(u + 6, r, -sign * c), set(u + 6, r + 6, -sign * c);
  }
  return k;
}

TEST(BodyOnBeam, FrequenciesOfABodyOnAFull12x12) {
  constexpr double all_digits = 1e-9;  // of frequencies that differ by a factor 50
  const double expected[] = {21.239713236103995, 21.266698737544388, 103.1875984282794,
                             195.8593730759356,  235.487103553267,   1067.1378022032654};
  model::Description d;
  model::Body body;
  body.name = "body";
  body.mass.mass = 8;
  body.mass.centre = {0.05, 0.02, -0.03};
  body.mass.inertia_about_centre << 0.03, 0.002, -0.001, 0.002, 0.05, 0.003, -0.001, 0.003, 0.045;
  d.bodies.push_back(body);
  model::Element beam;
  beam.name = "beam";
  beam.type = "matrix";
  beam.k.body = 0;
  beam.n.at = {-0.5, 0, 0};
  beam.law.nominal_stiffness = textbook_beam(210e9, 80769230769.23077, 0.03, 0.5);
  d.elements.push_back(beam);
  const auto system = model::System::checked(d);
  ASSERT_TRUE(system.has_value());
  const modal::Modes modes = modal::modes(*system);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_THAT(*modes.list[i].angular_frequency / (2 * std::numbers::pi), RelativelyNear(expected[i], all_digits));
}

TEST(ThreeEqualElements, TogetherAreTheStiffnessOfThePaper) {
  // A realisation of the paper's K by three identical 12×12 elements, found by a separate linear solution.
  constexpr double all_digits = 1e-12;  // of the matrices in the file
  const auto three =
      judging::read_project(std::string(TRIVET_SOURCE_DIR) + "/examples/paper/three_elements.toml").value();
  const auto one = judging::read_project(std::string(TRIVET_SOURCE_DIR) + "/examples/paper/corrected.toml").value();
  const Eigen::MatrixXd expected = assembly::assemble(one.base().system).matrices.K;
  const Eigen::VectorXd scale = expected.diagonal().cwiseSqrt();
  EXPECT_THAT(assembly::assemble(three.base().system).matrices.K, test::NearInUnits(expected, scale, all_digits));
  EXPECT_THAT(assembly::assemble(three.base().system).matrices.B,
              test::NearInUnits((0.05 * expected).eval(), scale, all_digits));
}

}  // namespace reference_elements_test
