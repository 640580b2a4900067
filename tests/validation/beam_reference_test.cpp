// SPDX-License-Identifier: BSD-3-Clause
// The Timoshenko beam against textbook matrices and exact frequencies.
#include <gmock/gmock.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <numbers>

#include "support/matchers.h"
#include "trivet/elements/beam.h"

namespace beam_reference_test {

using namespace trivet;
using namespace trivet::elements;
using test::RelativelyNear;

constexpr double pi = std::numbers::pi;
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double round_off = 1e-12;        // closed forms of some ten operations
constexpr double printed_digits = 1e-5;    // six digits of Timoshenko and Goodier
constexpr double solve_round_off = 1e-11;  // six equations, solved for the flexibility

TEST(Section, HasTheTextbookConstants) {
  const Metal metal{"", 2.6e11, 1e11, 7850, ""};                                                     // ν = 0.3
  EXPECT_THAT(round_section(0.02, metal).shear_factor_1, RelativelyNear(6 * 1.3 / 8.8, round_off));  // Cowper
  EXPECT_THAT(rectangular_section(0.1, 0.02, metal).shear_factor_2, RelativelyNear(13 / 15.3, round_off));
  constexpr double thin_wall = 1e-4;  // the closed form is the limit of a thin wall; this one has 5e-6 of the radius
  EXPECT_THAT(tube_section(0.02, 0.0199999, metal).shear_factor_1, RelativelyNear(2 * 1.3 / (4 + 3 * 0.3), thin_wall));
  constexpr double three_digits = 2e-3;  // 0.312 is printed
  EXPECT_THAT(rectangular_section(1, 1, metal).torsion_constant, RelativelyNear(0.140577, printed_digits));
  EXPECT_THAT(rectangular_section(1, 2, metal).torsion_constant, RelativelyNear(2 * 0.228682, printed_digits));
  EXPECT_THAT(rectangular_section(10, 1, metal).torsion_constant, RelativelyNear(10 * 0.312, three_digits));
}

TEST(Beam, IsTheTextbookMatrixWithoutShear) {
  // d = 30 mm, L = 0.5 m, E = 210 GPa; entries of the published Euler–Bernoulli matrix, its x is our e3.
  const Metal metal{"", 210e9, 80769230769.23077, 7850, ""};
  Section section = round_section(0.03, metal);
  section.shear_factor_1 = section.shear_factor_2 = infinite;
  const Matrix12 k = beam_stiffness({metal, section, 0.5});
  EXPECT_THAT(k(8, 8), RelativelyNear(296880505.76423544, round_off));
  EXPECT_THAT(k(6, 6), RelativelyNear(801577.3655634356, round_off));
  EXPECT_THAT(k(0, 6), RelativelyNear(-801577.3655634356, round_off));
  EXPECT_THAT(k(11, 11), RelativelyNear(12845.791114798649, round_off));
  EXPECT_THAT(k(10, 10), RelativelyNear(66798.11379695297, round_off));
  EXPECT_THAT(k(4, 10), RelativelyNear(33399.05689847648, round_off));
  EXPECT_THAT(k(6, 10), RelativelyNear(-200394.3413908589, round_off));
  EXPECT_THAT(k(7, 9), RelativelyNear(200394.3413908589, round_off));
  EXPECT_THAT(k(0, 4), RelativelyNear(200394.3413908589, round_off));
}

TEST(Beam, ACantileverBendsByMomentAndShear) {
  const Metal metal = elements::metal("structural_steel").value();
  const Section s = rectangular_section(0.03, 0.08, metal);
  const double L = 0.3, E = metal.young_modulus, G = metal.shear_modulus;
  const Matrix6 flexibility = beam_stiffness({metal, s, L}).bottomRightCorner<6, 6>().llt().solve(Matrix6::Identity());
  EXPECT_THAT(flexibility(0, 0),
              RelativelyNear(L * L * L / (3 * E * s.moment_2) + L / (s.shear_factor_1 * G * s.area), solve_round_off));
  EXPECT_THAT(flexibility(1, 1),
              RelativelyNear(L * L * L / (3 * E * s.moment_1) + L / (s.shear_factor_2 * G * s.area), solve_round_off));
  EXPECT_THAT(flexibility(0, 4), RelativelyNear(L * L / (2 * E * s.moment_2), solve_round_off));
  EXPECT_THAT(flexibility(1, 3), RelativelyNear(-L * L / (2 * E * s.moment_1), solve_round_off));
  EXPECT_THAT(flexibility(4, 4), RelativelyNear(L / (E * s.moment_2), solve_round_off));
}

using Coordinates = std::vector<int>;

/// Natural angular frequencies of `count` equal beams end to end; coordinates `at_ends` are held at both outer ends,
/// `everywhere` at every node.
Eigen::VectorXd frequencies(const Beam& whole, int count, const Coordinates& at_ends, const Coordinates& everywhere) {
  Beam part = whole;
  part.length = whole.length / count;
  const int size = 6 * (count + 1);
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(size, size), m = k;
  for (int i = 0; i < count; ++i) {
    k.block<12, 12>(6 * i, 6 * i) += beam_stiffness(part);
    m.block<12, 12>(6 * i, 6 * i) += beam_mass(part);
  }
  std::vector<int> free;
  for (int i = 0; i < size; ++i)
    if (const auto names = [i](const Coordinates& list) { return std::ranges::find(list, i % 6) != list.end(); };
        !names(everywhere) && !((i < 6 || i >= size - 6) && names(at_ends)))
      free.push_back(i);
  const Eigen::MatrixXd kf = k(free, free), mf = m(free, free);
  return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(kf, mf, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .cwiseMax(0)
      .cwiseSqrt();
}

TEST(Beam, APinnedStubbyBeamTendsToTheExactTimoshenkoFrequencies) {
  const Metal metal{"", 210e9, 80e9, 7850, ""};
  const Beam beam{metal, rectangular_section(0.1, 0.04, metal), 0.5};  // stubby
  const double a = beam.section.area, i = beam.section.moment_2,
               shear = beam.section.shear_factor_1 * metal.shear_modulus * a, rho = metal.density;
  const auto exact = [&](int mode) {  // lower root of ρ²IA/(κGA) ω⁴ − (ρA + ρI k² + EIρA k²/(κGA)) ω² + EI k⁴ = 0
    const double k2 = std::pow(mode * pi / beam.length, 2), bending = metal.young_modulus * i;
    const double p = rho * rho * i * a / shear, q = rho * a + rho * i * k2 + bending * rho * a * k2 / shear,
                 r = bending * k2 * k2;
    return std::sqrt(2 * r / (q + std::sqrt(q * q - 4 * p * r)));
  };
  const Coordinates in_other_planes{1, 2, 3, 5}, pinned{0};
  const double coarse = frequencies(beam, 8, pinned, in_other_planes)(0) / exact(1) - 1;
  const double fine = frequencies(beam, 16, pinned, in_other_planes)(0) / exact(1) - 1;
  // Second order: the shear force is constant within each element. The extrapolation removes it.
  constexpr double mesh_error = 2e-4, extrapolation_error = 1e-5, higher_orders = 0.2;
  EXPECT_LT(fine, mesh_error);
  EXPECT_NEAR(coarse / fine, 4, higher_orders);
  EXPECT_NEAR((4 * fine - coarse) / 3, 0, extrapolation_error);
}

TEST(Beam, AClampedSlenderBeamHasTheEulerFrequencies) {
  const Metal metal{"", 210e9, 80e9, 7850, ""};
  const Beam beam{metal, rectangular_section(0.001, 0.002, metal), 1};
  const double scale = std::sqrt(metal.young_modulus * beam.section.moment_2 / (metal.density * beam.section.area));
  const Eigen::VectorXd found =
      frequencies(beam, 20, {0, 1, 2, 3, 4, 5}, {});  // both planes, the second twice as stiff
  constexpr double not_of_euler = 2e-4;               // the mesh, and shear and rotary inertia, in the third mode
  const double roots[] = {4.730040744862704, 7.853204624095838, 10.995607838001671};
  for (const double root : {roots[0], roots[1], roots[2]})
    for (const double plane : {1.0, 2.0}) {
      const double expected = plane * root * root * scale;
      EXPECT_THAT((found.array() / expected - 1).abs().minCoeff(), testing::Le(not_of_euler)) << root << " " << plane;
    }
}

}  // namespace beam_reference_test
