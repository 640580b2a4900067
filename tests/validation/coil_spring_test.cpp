// SPDX-License-Identifier: BSD-3-Clause
// The coil spring against published frequencies, a published 12×12, and its equations solved with 70 digits.
#include <gmock/gmock.h>

#include <array>

#include "support/coil_springs.h"
#include "support/matchers.h"
#include "trivet/elements/coil_dynamics.h"

namespace coil_spring_test {

using namespace trivet;
using elements::Matrix12;
using test::literature_spring;
using test::RelativelyNear;
constexpr double pi = std::numbers::pi;

TEST(CoilSpring, FirstTenClampedFrequenciesOfThePublishedSpring) {
  // Pearson 1982, Lee and Thompson 2001: 393.5, 395.9, 462.8, 525.5, 863.9, 876.9 Hz. The first eight to 1e-6 from an
  // independent 12×12 matrix exponential, the last two from straight elements extrapolated, to 2e-5.
  constexpr std::array published = {393.5, 395.9, 462.8, 525.5, 863.9, 876.9};
  constexpr std::array exact = {393.400, 395.979, 462.718, 525.567, 863.567, 876.741, 913.473, 1037.243};
  constexpr std::array extrapolated = {1310.3584, 1364.2752};
  constexpr double exponential = 1.01e-6, printed_digits = 6e-4, extrapolation = 5e-5;
  const std::vector<double> omega = elements::natural_frequencies(literature_spring(), elements::SeatsHeld::both, 10);
  for (std::size_t i = 0; i < published.size(); ++i)
    EXPECT_THAT(omega[i] / (2 * pi), RelativelyNear(published[i], printed_digits)) << i;
  for (std::size_t i = 0; i < exact.size(); ++i)
    EXPECT_THAT(omega[i] / (2 * pi), RelativelyNear(exact[i], exponential)) << i;
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_THAT(omega[i + 8] / (2 * pi), RelativelyNear(extrapolated[i], extrapolation)) << i;
}

TEST(CoilSpring, StiffnessOfThePublishedSpring) {
  // Castigliano's theorem for the curved rod, at the top seat; its shear factor differs in the third digit.
  constexpr double other_shear_factor = 1e-4;
  Eigen::Matrix<double, 6, 6> expected;
  expected << 306.04358222428374, -0.6041200066131152, -14.941134978078045, 0.02461411633036571, -5.5031825158059,
      -0.057949425134543306, -0.604120006613122, 307.70658193408036, -4.854669038452093, 5.544351280785702,
      0.03089927771670564, -0.018828909611587695, -14.941134978078036, -4.854669038452131, 1293.1630237407787,
      0.1869185911774704, 0.3580675881548678, -0.280261416573676, 0.024614116330365563, 5.544351280785703,
      0.18691859117747095, 0.13653170552280638, -2.8584650881439853e-05, -0.00034565686599802477, -5.503182515805898,
      0.03089927771670552, 0.35806758815486567, -2.85846508814427e-05, 0.13543974167872347, 0.0010409040526312549,
      -0.057949425134543146, -0.018828909611587397, -0.28026141657370107, -0.00034565686599802477,
      0.0010409040526312505, 0.041675579054987116;
  const Matrix12 k = elements::stiffness(literature_spring());
  EXPECT_LE(test::scaled_difference(k.bottomRightCorner<6, 6>().eval(), expected), other_shear_factor);
}

TEST(CoilSpring, AxialRateOfTheStandardsExample) {
  // EN 13906-1 worked example (De 39.6, d 5, n 9.5, nt 11.5, L0 105.8 mm): 16.181 N/mm, from G d⁴/(8 D³ n).
  constexpr double second_order_of_the_index =
      0.02;  // 1/(2 κ C²) by shear and the held rotation of the seats, C = 6.92
  const elements::CoilSpring spring = test::standards_spring();
  EXPECT_THAT(elements::stiffness(spring)(8, 8), RelativelyNear(16181.0, second_order_of_the_index));
  EXPECT_DOUBLE_EQ(elements::seat_distance(spring), 105.8e-3);
}

/// Vector v of the reference computation: a millimetre and 0.2 rad times 1 … 12, some negative.
spatial::Vector12 probe() {
  spatial::Vector12 v;
  for (int i = 0; i < 12; ++i) v(i) = (i + 1) * (i % 6 < 3 ? 1e-3 : 0.2) * (i % 5 == 2 ? -1 : 1);
  return v;
}

/// |difference| over Σ |D_ij v_j|, the largest over i.
template <typename Matrix, typename Expected>
double backward_difference(const Matrix& d, const Expected& expected) {
  double worst = 0;
  for (int i = 0; i < 12; ++i) {
    typename Matrix::Scalar sum = 0;
    double size = 0;
    for (int j = 0; j < 12; ++j) sum += d(i, j) * probe()(j), size += std::abs(d(i, j) * probe()(j));
    worst = std::max(worst, std::abs(sum - expected[std::size_t(i)]) / size);
  }
  return worst;
}

// D(ω) v by one matrix exponential of the 12×12 system over the whole wire, with 70 digits.
constexpr double digits_of_reference = 1e-11;

TEST(CoilSpring, DynamicStiffnessFromATenthOfAHertzToTenKilohertz) {
  using Row = std::array<double, 12>;
  const std::pair<double, Row> reference[] = {
      {0.1,
       {16.01562946774648, -12.41235961010782, -16.19123566746758, 0.1777208592949379, 0.242851414982916,
        -0.04886663926208037, -16.01562957148405, 12.412359066123, 16.19123311892038, 0.2691253145560066,
        0.3337128624098781, 0.04886661265457748}},
      {50,
       {15.92189031543482, -12.52974512331559, -16.3215954713063, 0.1785533165625182, 0.2424191205709271,
        -0.05178878050069227, -15.94848637915643, 12.38928133523301, 15.67852767383789, 0.2675461029221156,
        0.3325257897417234, 0.0450859829096695}},
      {1000,
       {65.73108865155442, -68.02927513820311, -238.2531992968977, 0.1731725691491544, 0.3480572457634976,
        0.9886722686654184, -132.2984426557862, 95.18904719785058, 173.5085960552168, 0.4839039197993469,
        0.6160385313775911, -0.9405420176607227}},
      {10000,
       {-1647.982514675035, -1648.429212933137, 3628.607771882856, 16.32305150044773, -13.04681058724009,
        -1.227267298500074, -599.544367730762, 4904.606732310194, -556.3069489820464, 12.24863323203616,
        -3.96098349613271, -23.78327058842022}}};
  for (const auto& [hertz, row] : reference)
    EXPECT_LE(backward_difference(elements::dynamic_stiffness(literature_spring(), 2 * pi * hertz), row),
              digits_of_reference)
        << hertz;
}

TEST(CoilSpring, DynamicStiffnessWithLossAtAComplexFrequency) {
  using namespace std::complex_literals;
  const std::array<std::complex<double>, 12> expected = {
      66.9699038880277 - 6.87244010357071i,    -67.8644438964361 - 3.10918468254171i,
      -237.349800166185 - 7.4781981393418i,    0.173825124712421 + 0.00621100483783341i,
      0.356680869608438 - 0.0414875378796429i, 0.959439474777031 + 0.179284617058514i,
      -133.395937901928 + 2.54794833231592i,   94.8154032918555 + 6.81925348406103i,
      172.813247340896 + 2.10369789428976i,    0.479577738396957 + 0.0389432711517353i,
      0.623148175847484 - 0.0262149717377343i, -0.909988031030247 - 0.191059808688315i};
  elements::CoilSpring spring = literature_spring();
  spring.loss_factor = 0.05;
  EXPECT_LE(backward_difference(elements::dynamic_stiffness(spring, 2 * pi * (1000.0 + 30i)), expected),
            digits_of_reference);
}

}  // namespace coil_spring_test
