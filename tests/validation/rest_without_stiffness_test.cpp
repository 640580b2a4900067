// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>

#include "support/matchers.h"
#include "support/projects.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/modal/modes.h"
#include "trivet/nonlinear/branch/steady_branch.h"
#include "trivet/nonlinear/branch/stiffness_over_amplitude.h"
#include "trivet/nonlinear/machine/static_machine.h"
#include "trivet/nonlinear/modes/backbone.h"
#include "trivet/nonlinear/rest/rest_position.h"
#include "trivet/response/steady/static_response.h"

/// Machines whose drawing position has no stiffness against the load, whose load is just borne there, or whose
/// stiffnesses cancel at rest: closed forms and quadratures.
namespace rest_without_stiffness_test {

using namespace trivet;
using test::RelativelyNear;

constexpr double g = 9.80665;
constexpr double digits = 1e-9;  // of results, which Newton's method has to round-off

std::string body(double mass, const std::string& free, bool weighs = true) {
  return "trivet = 1\n" + std::string(weighs ? "gravity = [0, 0, -9.80665]\n" : "") +
      "[bodies.m]\nmass = " + std::to_string(mass) + "\nfree = [" + free + "]\n";
}

std::string strut(const std::string& name, const std::string& from, double free_length, double stiffness) {
  return "[elements." + name + "]\ntype = \"strut\"\non = \"m\"\nat = [0, 0, 0]\nfrom_at = [" + from +
      "]\nfree_length = " + std::to_string(free_length) + "\nstiffness = " + std::to_string(stiffness) + "\n";
}

double at_rest(const model::System& system, const std::string& name) {
  const nonlinear::StaticMachine held = nonlinear::static_machine(system, assembly::assemble(system));
  return response::static_response(held.system, held.assembled, {name}).values[0].value;
}

std::vector<double> natural_frequencies(const model::System& system) {
  std::vector<double> found;
  for (const modal::Mode& mode : modal::modes(system, assembly::assemble(system)).list)
    found.push_back(mode.angular_frequency.value_or(-1));
  return found;
}

/// 20 kg between two wires of 2 m without tension: 2 k z (1 − L/√(L² + z²)) = m g. The lamp sinks before any stiffness
/// holds it.
TEST(RestWithoutStiffness, ALampSinksOnAStraightWire) {
  constexpr double L = 2, k = 5e5, mass = 20;
  double low = 0, high = L;
  while (high - low > 1e-15) {
    const double z = (low + high) / 2;
    (2 * k * z * (1 - L / std::hypot(L, z)) < mass * g ? low : high) = z;
  }
  const model::System system =
      test::project(body(mass, "'x', 'y', 'z'") + strut("l", "-2, 0, 0", L, k) + strut("r", "2, 0, 0", L, k))
          .base()
          .system;
  EXPECT_THAT(at_rest(system, "m.z"), RelativelyNear(-low, digits));
  const double length = std::hypot(L, low), tension = k * (length - L), sine = low / length;
  const double upright = 2 * (k * sine * sine + tension / length * (1 - sine * sine)), aside = 2 * tension / length,
               along = 2 * (k * (1 - sine * sine) + tension / length * sine * sine);
  const std::vector<double> found = natural_frequencies(system);
  EXPECT_THAT(found[0], RelativelyNear(std::sqrt(aside / mass), digits));
  EXPECT_THAT(found[1], RelativelyNear(std::sqrt(upright / mass), digits));
  EXPECT_THAT(found[2], RelativelyNear(std::sqrt(along / mass), digits));
}

/// Two unlike springs, 800 N/m and 2000 N/m of 1 m and 0.6 m, pulled aside by 30 N and 400 N: SciPy's root of the
/// balance of forces, and the eigenvalues of its tangent.
TEST(RestWithoutStiffness, UnlikeSpringsArePulledFarAside) {
  const model::System system =
      test::project(body(12, "'x', 'z'", false) + strut("l", "-1, 0, 0", 1, 800) + strut("r", "0.6, 0, 0", 0.6, 2000) +
                    "[excitations.pull]\ntype = \"constant\"\non = \"m\"\nat = [0, 0, 0]\n"
                    "force = [30, 0, -400]\n")
          .base()
          .system;
  constexpr double printed = 1e-7;
  EXPECT_THAT(at_rest(system, "m.x"), RelativelyNear(0.15887692, printed));
  EXPECT_THAT(at_rest(system, "m.z"), RelativelyNear(-0.63059419, printed));
  EXPECT_THAT(natural_frequencies(system)[0], RelativelyNear(10.11778286, printed));
  EXPECT_THAT(natural_frequencies(system)[1], RelativelyNear(13.55817099, printed));
}

/// A pendulum: nothing but its own weight holds the mass to the side, with m g over the length of the strut.
TEST(RestWithoutStiffness, AMassHangsOnAStrutOfItsFreeLength) {
  constexpr double L = 0.5, k = 1e4, mass = 10, sag = mass * g / k;
  const model::System system = test::project(body(mass, "'x', 'y', 'z'") + strut("s", "0, 0, 0.5", L, k)).base().system;
  EXPECT_THAT(at_rest(system, "m.z"), RelativelyNear(-sag, digits));
  const std::vector<double> found = natural_frequencies(system);
  EXPECT_THAT(found[0], RelativelyNear(std::sqrt(g / (L + sag)), digits));
  EXPECT_THAT(found[1], RelativelyNear(std::sqrt(g / (L + sag)), digits));
  EXPECT_THAT(found[2], RelativelyNear(std::sqrt(k / mass), digits));
}

/// Released beside a wall, it swings down to hang there: no path of equilibria leads from where it was drawn.
TEST(RestWithoutStiffness, AMassOnOneHorizontalStrutSwingsDown) {
  constexpr double L = 0.5, k = 1e4, mass = 10, sag = mass * g / k;
  const model::System system = test::project(body(mass, "'x', 'z'") + strut("s", "-0.5, 0, 0", L, k)).base().system;
  EXPECT_THAT(at_rest(system, "m.x"), RelativelyNear(-L, digits));
  EXPECT_THAT(at_rest(system, "m.z"), RelativelyNear(-L - sag, digits));
}

/// A strut compressed by just the weight, and four bellows at the pressure p = p_a + m g / 4 A: rest is where they were
/// drawn, with k and 4 n p A² / V.
TEST(RestWithoutStiffness, ALoadThatBuiltInForcesJustBearMovesNothing) {
  constexpr double round_off = 1e-12;  // [m], of a travel of 0.1 m
  const model::System on_strut =
      test::project(body(10, "'z'") +
                    "[elements.s]\ntype = \"strut\"\non = \"m\"\nat = [0, 0, 0]\nfrom_at = [0, 0, -0.5]\n"
                    "free_length = 0.5980665\nstiffness = 1000\n")
          .base()
          .system;
  EXPECT_NEAR(at_rest(on_strut, "m.z"), 0, round_off);
  EXPECT_THAT(natural_frequencies(on_strut)[0], RelativelyNear(10, digits));
  constexpr double pressure = 101325 + 1200 * g / 4 / 0.012;
  std::string text = body(1200, "'z'");
  for (const char* name : {"a", "b", "c", "d"})
    text += "[elements." + std::string(name) +
        "]\ntype = \"air_spring\"\non = \"m\"\nat = [0, 0, 0]\nfrom_at = [0, 0, -0.2]\npressure = " +
        std::to_string(pressure) + "\nvolume = 0.002\narea = 0.012\nexponent = 1.38\nlateral = 2e4\n";
  const model::System on_air = test::project(text).base().system;
  EXPECT_NEAR(at_rest(on_air, "m.z"), 0, round_off);
  EXPECT_THAT(natural_frequencies(on_air)[0],
              RelativelyNear(std::sqrt(4 * 1.38 * pressure * 0.012 * 0.012 / 0.002 / 1200), digits));
}

const std::string cubic_mount =
    "[elements.s]\ntype = \"three_springs\"\non = \"m\"\nat = [0, 0, 0]\ntranslation = [0, 0, 0]\nlaws.z = {cubic = "
    "1e6}\n";

/// c z³ = m g, with the stiffness 3 c z².
TEST(RestWithoutStiffness, ACubicMountBearsAWeight) {
  const double z = std::cbrt(g / 1e6);
  const model::System system = test::project(body(1, "'z'") + cubic_mount).base().system;
  EXPECT_THAT(at_rest(system, "m.z"), RelativelyNear(-z, digits));
  EXPECT_THAT(natural_frequencies(system)[0], RelativelyNear(std::sqrt(3e6 * z * z), digits));
}

/// A pin in its ring and nothing else: it falls until it bears.
TEST(RestWithoutStiffness, APinFallsOntoItsRing) {
  const model::System system =
      test::project(
          body(10, "'x', 'z'") +
          "[elements.r]\ntype = \"stop\"\non = \"m\"\nat = [0, 0, 0]\naxis = \"y\"\nring = 0.003\nstiffness = 1e6\n")
          .base()
          .system;
  constexpr double sunk = 0.003 + 10 * g / 1e6;
  EXPECT_THAT(at_rest(system, "m.z"), RelativelyNear(-sunk, digits));
  EXPECT_THAT(natural_frequencies(system)[0], RelativelyNear(std::sqrt(g / sunk), digits));
}

/// Shallow trusses have three positions of rest below their limit load, one above it: all sign changes of their force.
TEST(RestWithoutStiffness, AllPositionsOfATrussAreFound) {
  for (const double height : {0.1, 0.2, 0.3})
    for (const double stiffness : {2e5, 1e6})
      for (const double mass : {5.0, 20.0, 50.0, 60.0, 71.0, 150.0}) {
        SCOPED_TRACE(testing::Message() << height << " m, " << stiffness << " N/m, " << mass << " kg");
        const double length = std::hypot(1, height);
        const auto missing = [&](double z) {
          return 2 * stiffness * (1 - length / std::hypot(1, height + z)) * (height + z) + mass * g;
        };
        std::vector<double> zeros;
        constexpr double step = 1e-5;
        for (double z = -1.2; z < 0.1; z += step)
          if ((missing(z) < 0) != (missing(z + step) < 0)) zeros.push_back(z);
        const std::string at = std::to_string(-height);
        const model::System system =
            test::project(body(mass, "'z'") +
                          "[elements.l]\ntype = \"strut\"\non = \"m\"\nat = [0, 0, 0]\nfrom_at = [-1, 0, " + at +
                          "]\nstiffness = " + std::to_string(stiffness) +
                          "\n[elements.r]\ntype = \"strut\"\non = \"m\"\nat = [0, 0, 0]\nfrom_at = [1, 0, " + at +
                          "]\nstiffness = " + std::to_string(stiffness) + "\n")
                .base()
                .system;
        const std::vector<nonlinear::RestState> states = nonlinear::rest_states(system);
        ASSERT_EQ(states.size(), zeros.size());
        std::vector<double> found;
        for (const nonlinear::RestState& state : states) {
          const double z = state.deflections[2].second;
          found.push_back(z);
          EXPECT_EQ(state.stable, missing(z + step) > missing(z - step));
        }
        std::ranges::sort(found);
        for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], zeros[i], step);
      }
}

/// 25 kg on 3200 N/m, with two struts of 4000 N/m that are compressed from 140 mm to 100 mm across it and take this
/// stiffness away: nothing but round-off is left.
std::string without_stiffness_at_rest(double spring = 3200) {
  return body(25, "'z'", false) +
      "[elements.up]\ntype = \"three_springs\"\non = \"m\"\nat = [0, 0, 0]\ntranslation = [0, 0, " +
      std::to_string(spring) + "]\ndamping = {translation = [0, 0, 8]}\n" + strut("l", "-0.1, 0, 0", 0.14, 4000) +
      strut("r", "0.1, 0, 0", 0.14, 4000) +
      "[excitations.f]\ntype = \"harmonic\"\non = \"m\"\nat = [0, 0, 0]\nforce = [0, 0, 3]\n";
}

TEST(RestWithoutStiffness, StiffnessesThatCancelLeaveNoRoundOff) {
  const project::Project project = test::project(without_stiffness_at_rest());
  for (const foundation::Problem& problem : project.base().warnings.list())
    EXPECT_THAT(problem.finding, testing::Not(testing::HasSubstr("unstable")));
  const model::System& system = project.base().system;
  EXPECT_NEAR(at_rest(system, "m.z"), 0, 1e-12);
  const modal::Mode mode = modal::modes(system, assembly::assemble(system)).list.front();
  EXPECT_EQ(mode.eigenvalue_squared, 0);
  EXPECT_FALSE(mode.strain_energy_share.has_value());
}

/// Within a gap every place is one of rest.
TEST(RestWithoutStiffness, APlaceWithinAGapIsNotUnique) {
  const model::System system =
      test::project(body(10, "'z'", false) +
                    "[elements.s]\ntype = \"stop\"\non = \"m\"\nat = [0, 0, 0]\naxis = \"z\"\ngaps = [1e-4, 1e-4]\n"
                    "stiffness = 1e6\n")
          .base()
          .system;
  EXPECT_THAT([&] { (void)at_rest(system, "m.z"); },
              testing::ThrowsMessage<foundation::NotComputable>(testing::HasSubstr("not unique")));
}

/// The machine is symmetric, so that its mean is zero. Amplitudes at 1 and 1.5 Hz: shooting with SciPy (DOP853, 1e-10).
TEST(RestWithoutStiffness, TheMeanOfASteadyMotionIsNoRoundOff) {
  for (const double spring : {3200.0, 3200.001}) {
    SCOPED_TRACE(spring);
    const model::System system = test::project(without_stiffness_at_rest(spring)).base().system;
    nonlinear::SteadyOptions options{.from = 0.8, .to = 14, .harmonics = 7, .of = {"m.z"}};
    options.at = {2 * std::numbers::pi, 3 * std::numbers::pi};
    const nonlinear::SteadyBranch found = nonlinear::steady_branch(system, options);
    EXPECT_EQ(found.ended, "");
    EXPECT_EQ(found.linear.rows() == 0, spring == 3200.0);
    constexpr double round_off = 1e-8, truncation = 1e-4;
    for (const nonlinear::SteadyPoint& point : found.points) {
      const nonlinear::ObservedMotion& motion = point.results[0];
      ASSERT_NEAR(motion.mean, 0, round_off * motion.largest) << point.angular_frequency;
    }
    for (const double amplitude : {0.05436216442, 0.00135065351})
      EXPECT_TRUE(std::ranges::any_of(found.at, [&](const nonlinear::SteadyPoint& point) {
        return point.stable && std::abs(point.results[0].largest - amplitude) < truncation * amplitude;
      })) << amplitude;
  }
}

/// T = 4 ∫₀ᵃ dz / √(2 (V(a) − V(z)) / m), with z = a sin t: the middle of 400 panels has every digit, as the integrand
/// is periodic and smooth.
double exact_frequency(double amplitude, double mass, const std::function<double(double)>& potential) {
  constexpr int panels = 400;
  double period = 0;
  for (int i = 0; i < panels; ++i) {
    const double t = (i + 0.5) / panels * std::numbers::pi / 2;
    period += 4 * std::sqrt(mass / 2) * amplitude * std::cos(t) /
        std::sqrt(potential(amplitude) - potential(amplitude * std::sin(t))) / panels * std::numbers::pi / 2;
  }
  return 2 * std::numbers::pi / period;
}

void expect_exact(const nonlinear::Backbone& found, double up_to, double mass,
                  const std::function<double(double)>& potential) {
  constexpr double truncation = 1e-6;  // of 15 harmonics
  EXPECT_EQ(found.ended, "");
  EXPECT_LT(found.points.size(), 400);
  EXPECT_THAT(found.points.back().deflection, RelativelyNear(up_to, 1e-9));
  for (const nonlinear::BackbonePoint& point : found.points)
    ASSERT_THAT(point.angular_frequency, RelativelyNear(exact_frequency(point.deflection, mass, potential), truncation))
        << point.deflection;
}

TEST(RestWithoutStiffness, ABackboneBeginsWithoutAFrequency) {
  for (const double spring : {3200.0, 3200.001}) {
    SCOPED_TRACE(spring);
    const model::System system = test::project(without_stiffness_at_rest(spring)).base().system;
    // Energies without what cancels: of both struts k (ρ − L)² with ρ = √(r² + z²), of which −3200 z²/2 takes away
    // the spring, and with d = ρ − r the rest is k z² (2 L / 2 r) d / (2 r + d).
    const auto potential = [&](double z) {
      const double d = z * z / (std::hypot(0.1, z) + 0.1);
      return z * z * ((spring - 3200) / 2 + 4000 * 1.4 * d / (0.2 + d));
    };
    expect_exact(nonlinear::backbone(system, {.up_to = 0.045, .harmonics = 15}), 0.045, 25, potential);
  }
}

/// ω = a √(c/m) 2π / (4 √2 ∫₀¹ du/√(1 − u⁴)) = 0.847213 a √(c/m).
TEST(RestWithoutStiffness, ACubicMountHasAFrequencyProportionalToItsAmplitude) {
  const model::System system = test::project(body(1, "'z'", false) + cubic_mount).base().system;
  const nonlinear::Backbone found = nonlinear::backbone(system, {.up_to = 0.02, .harmonics = 15});
  expect_exact(found, 0.02, 1, [](double z) { return 1e6 / 4 * std::pow(z, 4); });
  EXPECT_THAT(found.points.back().angular_frequency / found.points.back().deflection,
              RelativelyNear(847.2130848, 1e-7));
  const nonlinear::Backbone to_energy = nonlinear::backbone(system, {.up_to_energy = 0.04, .harmonics = 15});
  EXPECT_THAT(to_energy.points.back().energy, RelativelyNear(0.04, 1e-9));
  EXPECT_THAT(to_energy.points.back().deflection, RelativelyNear(0.02, 1e-6));
}

/// 1 kg, shaken with 15 m/s².
nonlinear::SteadyBranch shaken(const std::string& law, const std::string& spring) {
  const model::System system =
      test::project(body(1, "'z'", false) +
                    "[elements.g]\ntype = \"three_springs\"\non = \"m\"\nat = [0, 0, 0]\ntranslation = [0, 0, " +
                    spring + "]\nlaws.z = {" + law +
                    "}\n[excitations.b]\ntype = \"base\"\ntranslation = [0, 0, 15]\nquantity = \"acceleration\"\n")
          .base()
          .system;
  nonlinear::SteadyOptions options{.from = 6.2, .to = 6.3, .of = {"m.z"}};
  return nonlinear::steady_branch(system, options);
}

/// Friction that slides has any mean: no force determines it.
TEST(RestWithoutStiffness, ABodyThatFrictionAloneHoldsIsFreeToMove) {
  const std::string slider = "friction = {slip = 1, stiffness = 1000}";
  for (const std::string& law :
       {slider, std::string("friction.berg = {force = 1, deflection = 1e-3}"),
        std::string("bouc_wen = {stiffness = 1000, force = 1}"),
        std::string("friction.lugre = {stiffness = 1000, slip = 1, damping = 1, viscous = 1}")})
    EXPECT_THAT([&] { (void)shaken(law, "0"); },
                testing::ThrowsMessage<foundation::NotComputable>(
                    testing::AllOf(testing::HasSubstr("free to move"), testing::HasSubstr("g.deflection.z"))));
  EXPECT_NO_THROW((void)shaken(slider, "500"));
}

/// Fluid that circulates through track and floating decoupler is brought back by the least stiffness that is allowed,
/// 1e-14 of the chambers': round-off must not decide on its mean, and so on whether the decoupler closes. Without
/// quadratic losses the mount is linear: with p = K_u x − (K_u + K_l) s and s = p Y, Y = 1/Z_track + 1/Z_decoupler,
/// Z = R i ω − I ω² (+ centring), its stiffness is k + A² K_u (1 − K_u Y / (1 + (K_u + K_l) Y)).
TEST(RestWithoutStiffness, TheMeanOfCirculatingFluidIsNoRoundOff) {
  const model::System system =
      test::project(body(190, "'z'", false) +
                    "[elements.h]\ntype = \"hydromount\"\non = \"m\"\nat = [0, 0, 0]\nfrom_at = [0, 0, -0.06]\n"
                    "translation = [9e4, 9e4, 1.8e5]\nupper = 4e10\nlower = 1e9\npiston_area = 0.0032\n"
                    "track = {inertance = 2.5e6, resistance = 1.6e8}\n"
                    "decoupler = {inertance = 8e4, resistance = 2e7, play = 6e-7, centring = 4.2e-4}\n")
          .base()
          .system;
  const double omega = 2 * std::numbers::pi * 12;
  const auto stiffness = [&](double w) {
    const std::complex<double> s(0, w);
    const auto compliance = [&](double inertance, double resistance, double centring) {
      return 1.0 / (s * s * inertance + s * resistance + centring);
    };
    const std::complex<double> Y = compliance(2.5e6, 1.6e8, 0) + compliance(8e4, 2e7, 4.2e-4);
    constexpr double upper = 4e10, lower = 1e9, area = 0.0032;
    return 1.8e5 + area * area * upper * (1.0 - upper * Y / (1.0 + (upper + lower) * Y));
  };
  const auto found = nonlinear::stiffness_over_amplitude(system, 0, 0.9 * omega, 1.1 * omega, {1e-4}).front();
  EXPECT_EQ(found.ended, "");
  constexpr double rig = 1e-6;  // whose plate moves a little
  for (std::size_t i = 0; i < found.angular_frequency.size(); ++i) {
    const std::complex<double> expected = stiffness(found.angular_frequency[i]);
    ASSERT_LT(std::abs(found.stiffness(static_cast<Eigen::Index>(i)) - expected), rig * std::abs(expected));
  }
}

/// A law of zero is a parameter that begins at 0: the same machine as without it.
TEST(RestWithoutStiffness, ALawMayBeZero) {
  for (const char* law : {"cubic = 0", "quadratic = 0", "polynomial = [0, 0]"}) {
    const std::string text = body(25, "'z'") +
        "[elements.s]\ntype = \"three_springs\"\non = \"m\"\nat = [0, 0, 0]\ntranslation = [0, 0, 1e4]\nlaws.z = {" +
        law + "}\n";
    const model::System system = test::project(text).base().system;
    EXPECT_THAT(at_rest(system, "m.z"), RelativelyNear(-25 * g / 1e4, digits));
    EXPECT_THAT(natural_frequencies(system)[0], RelativelyNear(20, digits));
  }
}

}  // namespace rest_without_stiffness_test
