// SPDX-License-Identifier: BSD-3-Clause
// Bonded rubber against published closed forms and against finite-element results of separate programs.
#include <gmock/gmock.h>

#include <numbers>

#include "support/matchers.h"
#include "trivet/elements/pressure_modulus.h"
#include "trivet/elements/rubber_layer.h"
#include "trivet/elements/rubber_mounts.h"

namespace rubber_reference_test {

using namespace trivet;
using namespace trivet::elements;
using test::RelativelyNear;

constexpr double pi = std::numbers::pi;
constexpr double all_digits = 1e-9;  // of the published numbers, ten or more
constexpr double round_off = 1e-12;  // a few operations

TEST(BondedDisc, HasThePublishedModuli) {
  const Rubber rubber{7e5, 2e9}, incompressible{7e5, std::numeric_limits<double>::infinity()};
  const double radius = 0.05, h = 0.02, s = disc_shape_factor(radius, 0, h);
  EXPECT_THAT(s, RelativelyNear(1.25, all_digits));
  EXPECT_THAT(disc_pressure_modulus(rubber, radius, h), RelativelyNear(6533918.01350156, all_digits));
  EXPECT_THAT(disc_pressure_bending_modulus(rubber, radius, h), RelativelyNear(2183917.4021871523, all_digits));
  EXPECT_THAT(disc_pressure_modulus(incompressible, radius, h), RelativelyNear(6562500.0, all_digits));
  EXPECT_THAT(disc_pressure_bending_modulus(incompressible, radius, h), RelativelyNear(2187500.0, all_digits));
  EXPECT_THAT(gent_lindley_modulus(incompressible, s), RelativelyNear(8662500.0, all_digits));
  EXPECT_THAT(gent_lindley_modulus(rubber, s), RelativelyNear(8625142.35218709, all_digits));
  EXPECT_THAT(gent_meinecke_bending_modulus(incompressible, s), RelativelyNear(4287500.0, all_digits));
}

TEST(BondedDisc, TextbookFormulasGiveThePublishedMatrix) {
  const Matrix12 c =
      rubber_disc({.rubber = {7e5, 2e9}, .radius = 0.05, .thickness = 0.02, .formulas = LayerFormulas::textbook});
  EXPECT_THAT(c(8, 8), RelativelyNear(3387085.481224644, all_digits));
  EXPECT_THAT(c(2, 8), RelativelyNear(-3387085.481224644, all_digits));
  EXPECT_THAT(c(0, 0), RelativelyNear(274889.35718910693, all_digits));
  EXPECT_THAT(c(11, 11), RelativelyNear(343.61169648638366, all_digits));
  EXPECT_THAT(c(3, 3), RelativelyNear(1077.5486906089152, all_digits));
  EXPECT_THAT(c(3, 9), RelativelyNear(-1022.5708191710938, all_digits));
  EXPECT_THAT(c(0, 4), RelativelyNear(2748.8935718910693, all_digits));
  EXPECT_THAT(c(0, 10), RelativelyNear(2748.8935718910693, all_digits));
  EXPECT_THAT(c(1, 3), RelativelyNear(-2748.8935718910693, all_digits));
}

TEST(BondedDisc, AgreesWithThreeDimensionalFiniteElements) {
  // Cylinder D = 50 mm, E = 3 MPa, ν = 0.4995, hexahedra with quadratic displacement and discontinuous linear pressure,
  // rim graded: ±0.05 %.
  constexpr double axial_error = 0.005, shear_error = 0.004, tilt_error = 0.01;
  const Rubber rubber{3e6 / (2 * 1.4995), 3e6 / (3 * (1 - 2 * 0.4995))};
  const double table[][4] = {{0.025, 363450, 68550, 59.06},
                             {0.010, 2353050, 187087, 206.9},
                             {0.005, 14816700, 383647, 951.5},
                             {0.0025, 98979100, 776527, 6017}};
  for (const auto& [h, axial, shear, tilt] : table) {
    const Matrix12 c = rubber_disc({.rubber = rubber, .radius = 0.025, .thickness = h});
    EXPECT_THAT(c(8, 8), RelativelyNear(axial, axial_error)) << h;
    EXPECT_THAT(c(6, 6), RelativelyNear(shear, shear_error)) << h;
    EXPECT_THAT(c(9, 9), RelativelyNear(tilt, tilt_error)) << h;
  }
  constexpr double printed_digits = 1e-5;  // six, and torsion is exact
  EXPECT_THAT(rubber_disc({.rubber = rubber, .radius = 0.025, .thickness = 0.025})(11, 11),
              RelativelyNear(24.5519, printed_digits));
}

TEST(BondedDisc, AgreesWithAxisymmetricFiniteElementsOverAllShapeFactors) {
  // Fourier-axisymmetric Q2/P1, K/G = 2000, by a program separate from the library; S, Ec/3G, shear/(G A/h), Eb/3G, all
  // ±0.15 %.
  constexpr double documented = 0.01;  // docs/elements/rubber.md: at most 0.8 %
  const double table[][4] = {{0.25, 1.197136, 0.704684, 1.138965},  {0.375, 1.343833, 0.822051, 1.221539},
                             {0.5, 1.544884, 0.873037, 1.314852},   {0.75, 2.124910, 0.918636, 1.541914},
                             {1, 2.947382, 0.939980, 1.834025},     {1.5, 5.317270, 0.960574, 2.640932},
                             {2, 8.632592, 0.970628, 3.760080},     {3, 17.941782, 0.980549, 6.941509},
                             {5, 45.694863, 0.988390, 16.896872},   {7, 81.989222, 0.991725, 31.086421},
                             {10, 143.070310, 0.994217, 58.445088}, {20, 314.768347, 0.997114, 168.728674}};
  for (const auto& [s, axial, shear, bending] : table) {
    const double h = 1 / (2 * s), area = pi, moment = pi / 4;
    const LayerConstants c = layer_constants(RubberDisc{.rubber = {1e6, 2e9}, .radius = 1, .thickness = h});
    EXPECT_THAT(c.axial * h / area / 3e6, RelativelyNear(axial, documented)) << s;
    EXPECT_THAT(c.shear_1 * h / area / 1e6, RelativelyNear(shear, documented)) << s;
    EXPECT_THAT(c.bending_1 * h / moment / 3e6, RelativelyNear(bending, documented)) << s;
  }
}

TEST(BondedRing, AgreesWithAxisymmetricFiniteElements) {
  constexpr double documented = 0.045;  // docs/elements/rubber.md: at most 4 %
  const double table[][5] = {{0.3, 0.25, 1.280111, 0.750090, 1.203588},   {0.3, 1, 2.816426, 0.942106, 2.269800},
                             {0.3, 10, 109.389276, 0.994235, 85.612576},  {0.5, 0.25, 1.364017, 0.751817, 1.280525},
                             {0.5, 1, 2.717494, 0.942318, 2.490907},      {0.5, 10, 108.117508, 0.994235, 97.754459},
                             {0.75, 0.25, 1.468589, 0.750728, 1.424940},  {0.75, 2, 6.437015, 0.971191, 6.318304},
                             {0.75, 10, 107.575890, 0.994235, 105.521453}};
  for (const auto& [p, s, axial, shear, bending] : table) {
    const double h = (1 - p) / (2 * s), area = pi * (1 - p * p), moment = pi * (1 - std::pow(p, 4)) / 4;
    const LayerConstants c =
        layer_constants(RubberDisc{.rubber = {1e6, 2e9}, .radius = 1, .hole_radius = p, .thickness = h});
    EXPECT_THAT(c.axial * h / area / 3e6, RelativelyNear(axial, documented)) << p << " " << s;
    EXPECT_THAT(c.shear_1 * h / area / 1e6, RelativelyNear(shear, documented)) << p << " " << s;
    EXPECT_THAT(c.bending_1 * h / moment / 3e6, RelativelyNear(bending, documented)) << p << " " << s;
  }
}

TEST(BondedStrip, AgreesWithPlaneStrainFiniteElements) {
  constexpr double documented = 0.012;  // docs/elements/rubber.md: at most 1 %
  const double table[][4] = {{0.25, 1.507880, 0.500581, 1.405632},
                             {0.5, 1.749753, 0.762686, 1.484977},
                             {1, 2.665083, 0.884898, 1.693793},
                             {3, 12.682912, 0.961568, 3.714289},
                             {10, 107.459811, 0.988471, 26.090760}};
  for (const auto& [s, axial, shear, bending] : table) {
    const double h = 1 / (2 * s), length = 500;  // the effect of the ends is 1 / length
    const LayerConstants c =
        layer_constants(RubberBlock{.rubber = {1e6, 2e9}, .width_1 = 1, .width_2 = length, .thickness = h});
    EXPECT_THAT(c.axial * h / length / 3e6, RelativelyNear(axial, documented)) << s;
    EXPECT_THAT(c.shear_1 * h / length / 1e6, RelativelyNear(shear, documented)) << s;
    EXPECT_THAT(c.bending_2 * h * 12 / length / 3e6, RelativelyNear(bending, documented)) << s;
  }
}

TEST(RubberBlock, AgreesWithThreeDimensionalFiniteElements) {
  // Quarter model of Q2/P1 bricks, edges graded, K/G = 2000, per G, width_1 = 1, by a program separate from the
  // library, ±0.5 %: width_2, S, axial, shear 1, shear 2, bending 1, bending 2, torsion.
  constexpr double axial_error = 0.02, shear_error = 0.045, bending_error = 0.05, torsion_error = 0.05;
  const double table[][8] = {{1, 0.25, 3.711, 0.73845, 0.73845, 0.29024, 0.29024, 0.14623},
                             {1, 0.5, 10.049, 1.7578, 1.7578, 0.68361, 0.68361, 0.30353},
                             {1, 1, 40.043, 3.764, 3.764, 1.9651, 1.9651, 0.63196},
                             {1, 2.5, 435.77, 9.7673, 9.7673, 14.353, 14.353, 1.6295},
                             {1, 6, 5008.4, 23.769, 23.769, 155.59, 155.59, 3.9621},
                             {2, 0.25, 5.6854, 0.98115, 1.2363, 1.7332, 0.45588, 0.48744},
                             {2, 0.5, 15.193, 2.524, 2.7528, 4.1616, 1.0486, 1.0961},
                             {2, 1, 57.574, 5.5334, 5.7611, 13.199, 2.7261, 2.3354},
                             {2, 2.5, 604.23, 14.537, 14.766, 113.06, 16.47, 6.0798},
                             {2, 6, 6980.6, 35.539, 35.769, 1275.5, 166.53, 14.828},
                             {4, 0.25, 10.019, 1.4759, 2.2322, 11.908, 0.81024, 2.258},
                             {4, 0.5, 25.703, 4.0562, 4.7486, 29.398, 1.7938, 5.8404}};
  for (const auto& [width_2, s, axial, shear_1, shear_2, bending_1, bending_2, torsion] : table) {
    const double h = width_2 / (2 * s * (1 + width_2));
    const LayerConstants c =
        layer_constants(RubberBlock{.rubber = {1, 2000}, .width_1 = 1, .width_2 = width_2, .thickness = h});
    EXPECT_THAT(c.axial, RelativelyNear(axial, axial_error)) << width_2 << " " << s;
    EXPECT_THAT(c.shear_1, RelativelyNear(shear_1, shear_error)) << width_2 << " " << s;
    EXPECT_THAT(c.shear_2, RelativelyNear(shear_2, shear_error)) << width_2 << " " << s;
    EXPECT_THAT(c.bending_1, RelativelyNear(bending_1, bending_error)) << width_2 << " " << s;
    EXPECT_THAT(c.bending_2, RelativelyNear(bending_2, bending_error)) << width_2 << " " << s;
    EXPECT_THAT(c.torsion, RelativelyNear(torsion, torsion_error)) << width_2 << " " << s;
  }
}

TEST(RubberBlock, TwistsBetweenPolarMomentAndSaintVenant) {
  // J = 0.1406 a⁴ of a square, 1.124 b⁴ of 1 × 4 (Timoshenko and Goodier).
  const auto torsion = [](double width_2, double h) {
    return layer_constants(RubberBlock{.rubber = {1e6}, .width_1 = 1, .width_2 = width_2, .thickness = h}).torsion * h /
        1e6;
  };
  constexpr double thin = 1e-3;     // the limit of a thickness of zero; the rest falls with its square
  constexpr double tall = 3e-3;     // the limit of an infinite height, whose ends take 1 / height; four digits
  constexpr double slender = 0.05;  // the warping of three terms is 4 % stiff for a slender section
  EXPECT_THAT(torsion(1, 0.001), RelativelyNear(1.0 / 6, thin));
  EXPECT_THAT(torsion(1, 1000), RelativelyNear(0.1406, tall));
  EXPECT_THAT(torsion(4, 0.001), RelativelyNear(4 * 17 / 12.0, thin));
  EXPECT_THAT(torsion(4, 10000), RelativelyNear(1.124, slender));
}

TEST(RubberBush, HasItsClosedForms) {
  const RubberBush bush{.rubber = {7e5, 2e9}, .inner_radius = 0.012, .outer_radius = 0.03, .length = 0.05};
  EXPECT_THAT(long_bush_axial(bush), RelativelyNear(240001.8663306621, all_digits));
  EXPECT_THAT(bush_torsion(bush), RelativelyNear(75.39822368615503, all_digits));
  EXPECT_THAT(rubber_bush(bush)(5, 5), RelativelyNear(75.39822368615503, all_digits));
  // Adkins and Gent 1954, incompressible.
  RubberBush rigid = bush;
  rigid.rubber.bulk_modulus = std::numeric_limits<double>::infinity();
  const double l = std::log(2.5), sum = 0.03 * 0.03 + 0.012 * 0.012, difference = 0.03 * 0.03 - 0.012 * 0.012,
               gl = 7e5 * 0.05;
  EXPECT_THAT(long_bush_radial(rigid), RelativelyNear(4 * pi * gl / (l - difference / sum), all_digits));
  EXPECT_THAT(short_bush_radial(rigid),
              RelativelyNear(80 * pi * gl * sum / (25 * sum * l - 9 * difference), all_digits));
}

TEST(RubberBush, AgreesWithAxisymmetricFiniteElements) {
  // ri = 1, K/G = 2000, per G: ro/ri, length/wall, axial, radial, tilt.
  constexpr double axial_error = 0.035, radial_error = 0.045, tilt_error = 0.075;
  const double table[][5] = {
      {1.15, 1, 5.14707, 20.9697, 3.00579},  {1.15, 2, 11.9379, 60.1335, 7.19903}, {1.15, 8, 52.3963, 1572.34, 85.4242},
      {1.15, 16, 106.344, 8501.84, 1311.45}, {1.5, 1, 5.93003, 23.2656, 5.0221},   {1.5, 2, 13.7319, 65.0628, 14.4398},
      {1.5, 8, 60.2181, 1066.44, 647.27},    {1.5, 16, 122.203, 3290.34, 9860.07}, {2, 1, 6.97736, 25.5965, 9.52967},
      {2, 2, 16.1034, 68.715, 34.3901},      {2, 8, 70.4892, 720.381, 2299.12},    {2, 16, 143.007, 1781.92, 27699.4},
      {3, 1, 8.91084, 29.4138, 25.076},      {3, 2, 20.4229, 74.6891, 114.555},    {3, 8, 89.0512, 543.032, 8562.9},
      {3, 16, 180.559, 1212.38, 86707.4},    {5, 1, 12.4037, 36.5823, 87.7821},    {5, 2, 28.1132, 88.3454, 483.555},
      {5, 8, 121.809, 515.348, 36483.2},     {5, 16, 246.738, 1099.41, 336964}};
  for (const auto& [ratio, slenderness, axial, radial, tilt] : table) {
    const BushConstants c = bush_constants(
        {.rubber = {1e6, 2e9}, .inner_radius = 1, .outer_radius = ratio, .length = slenderness * (ratio - 1)});
    EXPECT_THAT(c.axial / 1e6, RelativelyNear(axial, axial_error)) << ratio << " " << slenderness;
    EXPECT_THAT(c.radial / 1e6, RelativelyNear(radial, radial_error)) << ratio << " " << slenderness;
    EXPECT_THAT(c.tilt / 1e6, RelativelyNear(tilt, tilt_error)) << ratio << " " << slenderness;
  }
}

TEST(Hardness, FollowsGentAndLindley) {
  // Gent 1958 at 50 degrees gives 2.456 MPa; Lindley's measured table G = 0.64 MPa. E/3 and G agree within the scatter
  // of compounds.
  constexpr double printed_digits = 1e-3, scatter = 0.35;  // four, and of compounds: docs/elements/rubber.md
  EXPECT_THAT(young_modulus_from_hardness(50), RelativelyNear(2.456e6, printed_digits));
  EXPECT_THAT(shear_modulus_from_irhd(50), RelativelyNear(0.64e6, round_off));
  EXPECT_THAT(shear_modulus_from_irhd(52.5), RelativelyNear(0.725e6, round_off));
  for (const double hardness : {35.0, 45.0, 60.0, 70.0})
    EXPECT_THAT(young_modulus_from_hardness(hardness) / 3, RelativelyNear(shear_modulus_from_irhd(hardness), scatter));
}

}  // namespace rubber_reference_test
