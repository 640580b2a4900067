// SPDX-License-Identifier: BSD-3-Clause
// Periodic motions of nonlinear machines: numbers of independent programs (harmonic balance with shooting, return error
// below 1e-13), and closed forms.
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/nonlinear/branch/steady_branch.h"
#include "trivet/numerics/periodic/fourier_basis.h"

namespace steady_motion_test {

using namespace trivet;
using nonlinear::SteadyBranch;
using nonlinear::SteadyPoint;
using test::RelativelyNear;

constexpr double pi = std::numbers::pi;

/// The system with nonlinear parts on its first elements, one each.
model::System with_laws(const std::string& text, const std::vector<model::NonlinearPart>& parts) {
  model::Description description = test::project(text).base().system.description();
  for (std::size_t i = 0; i < parts.size(); ++i) description.elements[i].nonlinear_parts = {parts[i]};
  return model::System::checked(description).value();
}

/// m ẍ + c ẋ + k x + f(x) = F cos ωt, by a guided mass on a spring from the ground.
model::System oscillator(double mass, double damping, double stiffness, double force, elements::ScalarLaw law) {
  const std::string excitation = "\n[excitations.F]\ntype = \"harmonic\"\non = \"m1\"\nat = [0, 0, 0]\nforce = [" +
      std::to_string(force) + ", 0, 0]\n";
  return with_laws(test::chain({mass}, {stiffness, 0}, {damping, 0}) + excitation, {{0, 0.5, {std::move(law)}}});
}

double amplitude(const SteadyPoint& point, Eigen::Index harmonic) {
  return point.deflections.block<2, 1>(2 * harmonic - 1, 0).norm();
}

double largest_multiplier(const SteadyPoint& point) { return point.multipliers.cwiseAbs().maxCoeff(); }

TEST(SteadyMotion, HardeningSpringHasTwoFoldsAndAnUnstableMiddleMotion) {
  const model::System system = oscillator(1.5, 0.9, 600, 0.8, elements::PolynomialForce{{0, 0, 2e5}});
  nonlinear::SteadyOptions options{.from = 14, .to = 30, .harmonics = 15};
  options.at = {16, 22, 23, 25};
  const SteadyBranch found = nonlinear::steady_branch(system, options);
  EXPECT_EQ(found.ended, "");
  constexpr double digits = 1e-7, of_multipliers = 1e-6;  // of the reference
  ASSERT_EQ(found.folds.size(), 2u);
  EXPECT_THAT(found.folds[0].point.angular_frequency, RelativelyNear(23.37324214072677, digits));
  EXPECT_THAT(found.folds[1].point.angular_frequency, RelativelyNear(21.342635329803098, digits));
  EXPECT_THAT(amplitude(found.folds[0].point, 1), RelativelyNear(0.037942526292881446, digits));
  ASSERT_EQ(found.at.size(), 8u);
  struct Row {
    double omega, first, third, multiplier;
    bool stable;
  };
  const Row rows[] = {{16, 0.0036615522591681, 8.605375e-07, 0.888865165780565, true},
                      {22, 0.0307331870637726, 0.0002568996, 0.917888092265, true},
                      {23, 0.0363915345862469, 0.00039231812, 0.921313793718, true},
                      {23, 0.0348072393825642, 0.00034137697, 1.15508182679, false},
                      {22, 0.0260704082908681, 0.00015462313, 1.20999031602, false},
                      {22, 0.0066072488037358, 2.435692e-06, 0.917888092265117, true},
                      {23, 0.0041663427736413, 5.532023e-07, 0.921313793719, true},
                      {25, 0.0023710184386832, 8.505005e-08, 0.927374110449856, true}};
  for (std::size_t i = 0; i < found.at.size(); ++i) {
    SCOPED_TRACE(i);
    EXPECT_EQ(found.at[i].angular_frequency, rows[i].omega);
    EXPECT_THAT(amplitude(found.at[i], 1), RelativelyNear(rows[i].first, digits));
    EXPECT_THAT(amplitude(found.at[i], 3), RelativelyNear(rows[i].third, 1e-6));  // seven digits given
    EXPECT_NEAR(largest_multiplier(found.at[i]), rows[i].multiplier, of_multipliers);
    EXPECT_EQ(found.at[i].stable, rows[i].stable);
    // Liouville: the states lose volume by the damper alone.
    EXPECT_THAT(std::abs(found.at[i].multipliers.prod()),
                RelativelyNear(std::exp(-2 * pi * 0.9 / 1.5 / rows[i].omega), 1e-9));
  }
}

/// On a force that falls by 1010 N/mm, deviations grow by e^3162 per second: by more than the largest number.
TEST(SteadyMotion, ThatIsLeftByMoreThanAllNumbersIsUnstable) {
  elements::ForceCurve falling{
      elements::KnotCurve({-1, 1}, std::vector<double>{1.01e6, -1.01e6}, elements::Interpolation::linear)};
  const model::System system = oscillator(0.1, 1, 1e4, 0.8, falling);
  const SteadyBranch found = nonlinear::steady_branch(system, {.from = pi, .to = 4 * pi, .harmonics = 3});
  EXPECT_EQ(found.ended, "");
  ASSERT_GT(found.points.size(), 5u);
  for (const SteadyPoint& point : found.points) {
    const double omega = point.angular_frequency;
    EXPECT_THAT(amplitude(point, 1), RelativelyNear(0.8 / std::hypot(1e6 + 0.1 * omega * omega, omega), 1e-12));
    EXPECT_FALSE(point.stable);
    EXPECT_TRUE(std::isinf(point.multiplier_uncertainty));
  }
}

TEST(SteadyMotion, OneHarmonicKnowsTheThirdThatItLeavesOut) {
  const model::System system = oscillator(1.5, 0.9, 600, 0.8, elements::PolynomialForce{{0, 0, 2e5}});
  const auto branch = [&](Eigen::Index harmonics) {
    return nonlinear::steady_branch(system, {.from = 14, .to = 30, .harmonics = harmonics});
  };
  const SteadyBranch one = branch(1), many = branch(15);
  double third = 0;
  for (const SteadyPoint& point : many.points)
    third = std::max(third, amplitude(point, 3) / point.deflections.cwiseAbs().maxCoeff());
  constexpr double second_order = 0.1;  // the third harmonic changes the stiffness that it moves against
  EXPECT_THAT(one.left_out, RelativelyNear(third, second_order));
  EXPECT_LT(many.left_out, 1e-9);
  // Folds with one harmonic: m ω² = k + 3/4 k₃ a² ± …, by the double roots of the cubic in a².
  EXPECT_THAT(one.folds.at(0).point.angular_frequency, RelativelyNear(23.350584555234533, 1e-10));
  EXPECT_THAT(one.folds.at(1).point.angular_frequency, RelativelyNear(21.341785642874047, 1e-10));
}

TEST(SteadyMotion, ThirdHarmonicHasAResonanceThatTheFundamentalLacks) {
  const model::System system = oscillator(1.2, 0.48, 480, 6, elements::PolynomialForce{{0, 0, 8e5}});
  nonlinear::SteadyOptions options{.from = 6, .to = 13, .harmonics = 25};
  options.at = {7, 7.98, 9};
  const SteadyBranch found = nonlinear::steady_branch(system, options);
  ASSERT_EQ(found.folds.size(), 2u);
  EXPECT_THAT(found.folds[0].point.angular_frequency, RelativelyNear(8.068113200891425, 1e-7));
  EXPECT_THAT(found.folds[1].point.angular_frequency, RelativelyNear(7.913155817650235, 1e-7));
  ASSERT_EQ(found.at.size(), 5u);
  const double first[] = {0.012041720386091, 0.010139428349519, 0.008559957129879, 0.01051050009396, 0.012246704434305};
  const double third[] = {0.002610882170312, 0.012294875289247, 0.012724785369035, 0.00668400893422, 0.00178008750943};
  const bool upper_first = amplitude(found.at[1], 3) > amplitude(found.at[3], 3);
  for (std::size_t i = 0; i < 5; ++i) {
    const std::size_t row = upper_first || i == 0 || i == 4 ? i : 4 - i;
    EXPECT_THAT(amplitude(found.at[i], 1), RelativelyNear(first[row], 1e-6));
    EXPECT_THAT(amplitude(found.at[i], 3), RelativelyNear(third[row], 1e-6));
    EXPECT_EQ(found.at[i].stable, row != 2);
  }
}

TEST(SteadyMotion, StopOnOneSideAgreesWithPiecewiseExactMotions) {
  const model::System system = oscillator(40, 48, 36000, 60, elements::GapStop{.gap_above = 0.006, .stiffness = 4e5});
  nonlinear::SteadyOptions options{.from = 24, .to = 50, .harmonics = 25};
  options.at = {27, 38, 42};
  const SteadyBranch found = nonlinear::steady_branch(system, options);
  EXPECT_EQ(found.ended, "");
  constexpr double truncation = 1e-4;  // of 25 harmonics; the next is below it
  ASSERT_EQ(found.folds.size(), 2u);
  EXPECT_THAT(found.folds[0].point.angular_frequency, RelativelyNear(43.587332443, truncation));
  // The other fold is 0.001 rad/s below the frequency at which the mass just touches, where harmonics converge slowly.
  EXPECT_NEAR(found.folds[1].point.angular_frequency, 33.8616328, 0.2);
  const auto row = [&](double omega) {
    for (const SteadyPoint& point : found.at)
      if (point.angular_frequency == omega) return point;
    ADD_FAILURE() << omega;
    return SteadyPoint();
  };
  EXPECT_THAT(row(27).deflections(0, 0), RelativelyNear(-0.00023441525114, 1e-3));  // a fiftieth of the amplitude
  EXPECT_THAT(amplitude(row(27), 1), RelativelyNear(0.00624124336593, truncation));
  EXPECT_THAT(amplitude(row(27), 2), RelativelyNear(0.000203151689013, 1e-3));
  EXPECT_TRUE(row(27).stable);
  EXPECT_THAT(amplitude(row(38), 1), RelativelyNear(0.01169872452333, truncation));  // the upper motion comes first
  EXPECT_THAT(row(38).deflections(0, 0), RelativelyNear(-0.004425056073829, truncation));
  EXPECT_TRUE(row(38).stable);
  EXPECT_THAT(amplitude(found.at.back(), 1), RelativelyNear(0.001733164827988, 1e-9));  // without contact
}

/// 180 kg on four mounts with a cubic part along z.
model::System body_on_four_mounts() {
  std::string text = R"(trivet = 1
[bodies.body]
mass = 180
center_of_mass = [0.02, -0.015, 0.11]
inertia = {about = "center_of_mass", xx = 9.5, yy = 14.0, zz = 12.5, xy = 0.4, xz = -0.3, yz = -0.2}
[element_types.mount]
type = "bushing"
translation = [3e5, 3e5, 4.5e5]
damping = {proportional = 0.0012}
[excitations.force]
type = "harmonic"
on = "body"
at = [0.1, 0.05, 0.2]
force = [0, 0, 400]
)";
  int number = 0;
  for (const char* at : {"-0.45, -0.3, 0", "-0.45, 0.3, 0", "0.45, -0.3, 0", "0.45, 0.3, 0"})
    text += "[elements.m" + std::to_string(++number) + "]\ntype = \"mount\"\non = \"body\"\nat = [" + at + "]\n";
  const model::NonlinearPart cubic{2, 0.5, {elements::PolynomialForce{{0, 0, 1.2e11}}}};
  return with_laws(text, {cubic, cubic, cubic, cubic});
}

TEST(SteadyMotion, BodyOnFourCubicMountsAgreesWithFullHarmonicBalance) {
  constexpr double hertz = 2 * pi;
  nonlinear::SteadyOptions options{.from = 8 * hertz, .to = 26 * hertz, .harmonics = 11};
  options.at = {18.9 * hertz};
  const SteadyBranch found = nonlinear::steady_branch(body_on_four_mounts(), options);
  EXPECT_EQ(found.ended, "");
  constexpr double digits = 1e-6;  // of the reference: 138 unknowns, confirmed by shooting
  ASSERT_EQ(found.folds.size(), 2u);
  EXPECT_THAT(found.folds[0].point.angular_frequency, RelativelyNear(19.342978126056288 * hertz, digits));
  EXPECT_THAT(found.folds[1].point.angular_frequency, RelativelyNear(18.584949336705957 * hertz, digits));
  ASSERT_EQ(found.at.size(), 3u);
  const double multipliers[] = {0.83588169966, 1.21580119507, 0.83141683596};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(largest_multiplier(found.at[i]), multipliers[i], digits);
    EXPECT_EQ(found.at[i].stable, i != 1);
  }
}

/// Exact pieces between events [400 periods]; the harmonics left out fall as 1/k⁴.
TEST(SteadyMotion, FrictionDamperAgreesWithPiecewiseExactMotions) {
  const model::System system = oscillator(10, 8, 4e4, 50, elements::HystereticForce(elements::Slider{2e4, 30}));
  nonlinear::SteadyOptions options{.from = 58, .to = 82, .harmonics = 41};
  options.of = {"m1.x"};
  options.at = {60, 64, 66, 68, 70, 75, 80};
  const SteadyBranch found = nonlinear::steady_branch(system, options);
  EXPECT_EQ(found.ended, "");
  EXPECT_TRUE(found.folds.empty());
  const double rows[][3] = {
      {0.0038480808190535, 0.0038367492366979, 2.8018674e-05}, {0.024809957403191, 0.0247720587941003, 3.6428983e-05},
      {0.0128837655357558, 0.0128492377313432, 3.2035479e-05}, {0.0087024777098448, 0.0086742683053945, 2.8144393e-05},
      {0.0066465268830035, 0.0066246790236006, 2.4757238e-05}, {0.0042403402880353, 0.0042312860635265, 1.7871827e-05},
      {0.0031154876948549, 0.0031144674155445, 1.2536595e-05}};
  ASSERT_EQ(found.at.size(), std::size(rows));
  for (std::size_t i = 0; i < found.at.size(); ++i) {
    SCOPED_TRACE(found.at[i].angular_frequency);
    EXPECT_TRUE(found.at[i].stable);
    constexpr double truncation = 3e-7;  // of 41 harmonics: 1/k⁴
    EXPECT_THAT(found.at[i].results[0].largest, RelativelyNear(rows[i][0], 1e-6));
    EXPECT_THAT(amplitude(found.at[i], 1), RelativelyNear(rows[i][1], truncation));
    EXPECT_THAT(amplitude(found.at[i], 3), RelativelyNear(rows[i][2], 1e-6));
    // The force feeds what damper and slider lose: 4 slip (X − slip/k) with half of the range X.
    const double omega = found.at[i].angular_frequency;
    double lost = 4 * 30 * (found.at[i].results[0].half_of_range() - 30 / 2e4);
    for (Eigen::Index k = 1; k <= 41; ++k)
      lost += pi * 8 * omega * static_cast<double>(k * k) * std::pow(amplitude(found.at[i], k), 2);
    EXPECT_THAT(pi * 50 * found.at[i].deflections(2, 0), RelativelyNear(lost, 1e-6));
  }
}

TEST(SteadyMotion, OneHarmonicOfAFrictionDamperIsTheFormulaOfKrackAndGross) {
  const model::System system = oscillator(10, 8, 4e4, 50, elements::HystereticForce(elements::Slider{2e4, 30}));
  nonlinear::SteadyOptions options{.from = 58, .to = 82, .harmonics = 1};
  options.at = {60, 64, 70, 80};
  const SteadyBranch found = nonlinear::steady_branch(system, options);
  const double first[] = {0.0038599903337061, 0.0248810707791693, 0.0066435316346812, 0.0031124831860031};
  ASSERT_EQ(found.at.size(), std::size(first));
  for (std::size_t i = 0; i < found.at.size(); ++i)
    EXPECT_THAT(amplitude(found.at[i], 1), RelativelyNear(first[i], 1e-9));
}

/// Below the slip force a slider is a spring.
TEST(SteadyMotion, SliderThatNeverSlipsIsASpringAndIsNamed) {
  const model::System system = oscillator(10, 8, 4e4, 1, elements::HystereticForce(elements::Slider{2e4, 30}));
  nonlinear::SteadyOptions options{.from = 50, .to = 60, .harmonics = 3};
  options.at = {55};
  const SteadyBranch found = nonlinear::steady_branch(system, options);
  ASSERT_EQ(found.at.size(), 1u);
  const std::complex<double> stiffness(6e4 - 10 * 55 * 55, 8 * 55);
  EXPECT_THAT(amplitude(found.at[0], 1), RelativelyNear(1 / std::abs(stiffness), 1e-12));
  EXPECT_THAT(found.sticking, testing::ElementsAre("k1.deflection.x"));
  EXPECT_TRUE(found.at[0].stable);
  EXPECT_NEAR(largest_multiplier(found.at[0]), std::exp(-8 / (2 * 10.0) * 2 * pi / 55), 1e-9);
}

TEST(SteadyMotion, QuadraticDamperAgreesWithShooting) {
  const model::System system = oscillator(3, 0, 1200, 12, elements::DampingForce(elements::QuadraticDamping{60, 60}));
  nonlinear::SteadyOptions options{.from = 9, .to = 42, .harmonics = 21};
  options.of = {"m1.x"};
  options.at = {10, 16, 20, 24, 40};
  const SteadyBranch found = nonlinear::steady_branch(system, options);
  const double rows[][3] = {{0.01331159204, 0.00011752999, 0.01333716586},
                            {0.02302332333, 0.00023435127, 0.02308118696},
                            {0.024291052, 0.00024279073, 0.02434974862},
                            {0.01660793004, 0.00011122021, 0.0166259},
                            {0.00332335253, 4.2836e-06, 0.00332348537}};
  ASSERT_EQ(found.at.size(), std::size(rows));
  for (std::size_t i = 0; i < found.at.size(); ++i) {
    SCOPED_TRACE(found.at[i].angular_frequency);
    EXPECT_TRUE(found.at[i].stable);
    EXPECT_THAT(amplitude(found.at[i], 1), RelativelyNear(rows[i][0], 1e-6));
    EXPECT_THAT(amplitude(found.at[i], 3), RelativelyNear(rows[i][1], 1e-5));  // five digits given for the last
    EXPECT_THAT(found.at[i].results[0].largest, RelativelyNear(rows[i][2], 1e-6));
    // Liouville: the states lose volume by the mean of the damping 2 c |v| / m.
    const double omega = found.at[i].angular_frequency;
    double mean = 0;
    constexpr int samples = 4000;
    for (int n = 0; n < samples; ++n)
      mean += std::abs(omega *
                       numerics::motion_at(21, 2 * pi * n / samples,
                                           numerics::phase_derivative(found.at[i].deflections.col(0)))) /
          samples;
    EXPECT_THAT(std::abs(found.at[i].multipliers.prod()),
                RelativelyNear(std::exp(-2 * 60 * mean / 3 * 2 * pi / omega), 1e-5));
  }
}

/// m ẍ + c ẋ − k x + k₃ x³ = F cos ωt about x = 10 mm: shooting with monodromy matrix, root of multiplier + 1.
TEST(SteadyMotion, PeriodDoublesAtTheLoadThatShootingFinds) {
  model::Description description =
      oscillator(1, 3, 100, 1, elements::ElasticForce(elements::PolynomialForce{{-200, 0, 1e6}})).description();
  description.elements[0].nonlinear_parts[0].at_rest = 0.01;
  const model::System system = model::System::checked(description).value();
  nonlinear::SteadyOptions options{.from = 0.01, .to = 0.31, .over = nonlinear::Parameter::load_factor};
  options.angular_frequency = 12.727922061357857;
  options.harmonics = 15;
  options.of = {"m1.x"};
  const SteadyBranch found = nonlinear::steady_branch(system, options);
  ASSERT_EQ(found.changes.size(), 1u);
  const nonlinear::StabilityChange& change = found.changes[0];
  EXPECT_EQ(change.kind, nonlinear::StabilityChange::Kind::period_doubling);
  constexpr double digits = 1e-6;  // of the reference
  EXPECT_THAT(change.point.load_factor, RelativelyNear(0.29884586401840224, digits));
  EXPECT_THAT(change.point.results[0].smallest + 0.01, RelativelyNear(0.003385994878734, digits));
  EXPECT_THAT(change.point.results[0].largest + 0.01, RelativelyNear(0.013423635214776, digits));
  EXPECT_THAT(change.point.results[0].mean + 0.01, RelativelyNear(0.007844607525809, digits));
  EXPECT_THAT(amplitude(change.point, 1), RelativelyNear(0.004943796978163, digits));
  EXPECT_THAT(std::abs(change.point.multipliers.prod()), RelativelyNear(0.22741904, digits));
  EXPECT_FALSE(found.points.back().stable);
}

/// The same machine rests at x = 0, where it is unstable: the motions in its wells are found from them, the second well
/// as the image of the first.
TEST(SteadyMotion, OfAMachineBetweenTwoWellsIsFoundInThem) {
  const model::System system =
      oscillator(1, 3, 100, 1, elements::ElasticForce(elements::PolynomialForce{{-200, 0, 1e6}}));
  nonlinear::SteadyOptions options{.from = 0.01, .to = 0.31, .over = nonlinear::Parameter::load_factor};
  options.angular_frequency = 12.727922061357857;
  options.harmonics = 15;
  options.of = {"m1.x"};
  options.detached = true;
  const SteadyBranch found = nonlinear::steady_branch(system, options);
  ASSERT_TRUE(found.search);
  EXPECT_EQ(found.search->rests, 2);
  EXPECT_FALSE(found.points.front().stable);
  ASSERT_EQ(found.further.size(), 1u);
  const SteadyBranch& well = found.further[0];
  EXPECT_NE(well.points.front().stable, well.points.back().stable);
  ASSERT_EQ(well.changes.size(), 1u);
  constexpr double digits = 1e-6;  // of the reference
  EXPECT_THAT(well.changes[0].point.load_factor, RelativelyNear(0.29884586401840224, digits));
  EXPECT_THAT(std::abs(well.changes[0].point.results[0].mean), RelativelyNear(0.007844607525809, digits));
}

/// A loss factor is a complex stiffness: with one harmonic, a cubic of the amplitude alone.
TEST(SteadyMotion, LossFactorOfAHardeningSpringKeepsItsPhaseAtEveryFrequency) {
  const double m = 1.5, k = 600, eta = 0.08, cubic = 2e5, F = 0.8;
  const std::string excitation =
      "\n[excitations.F]\ntype = \"harmonic\"\non = \"m1\"\nat = [0, 0, 0]\nforce = [0.8, 0, 0]\n";
  const model::System system =
      with_laws(test::chain({m}, {k, 0}, {0, 0}, {eta, 0}) + excitation,
                {{0, 0.5, {elements::ElasticForce(elements::PolynomialForce{{0, 0, cubic}})}}});
  nonlinear::SteadyOptions options{.from = 14, .to = 30, .harmonics = 1};
  const SteadyBranch found = nonlinear::steady_branch(system, options);
  EXPECT_EQ(found.multipliers_of, nonlinear::SteadyBranch::Multipliers::viscous_machine);
  for (const SteadyPoint& point : found.points) {
    const double a = amplitude(point, 1), w = point.angular_frequency;
    EXPECT_THAT(std::hypot(k - m * w * w + 0.75 * cubic * a * a, eta * k) * a, RelativelyNear(F, 1e-10));
  }
}

}  // namespace steady_motion_test
