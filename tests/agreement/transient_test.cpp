// SPDX-License-Identifier: BSD-3-Clause
// Motions in time by the exact exponential, compared with other methods.
#include <gmock/gmock.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "support/matchers.h"
#include "support/projects.h"
#include "support/random_system.h"
#include "support/transient.h"
#include "trivet/excitation/pulses_and_sweeps.h"
#include "trivet/excitation/signal.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/response/steady/frequency_response.h"
#include "trivet/response/transient/state_space.h"
#include "trivet/response/transient/time_stepper.h"
#include "trivet/spatial/rigid_motion.h"

namespace transient_test {

using namespace trivet;
using test::along;
using test::NearVector;

constexpr double pi = std::numbers::pi;
/// Hundreds of steps, each exact to round-off, with results that are differences of larger numbers.
constexpr double round_off = 1e-9;

response::TransientOptions until(double to, double step) {
  response::TransientOptions options;
  options.to = to;
  options.step = step;
  return options;
}

/// Pulse with every kind of piece: a rounded rise, a hold, a corner, a jump, a sine.
excitation::Signal mixed() {
  excitation::Signal signal = excitation::rounded_step(1, 0.07, 0.011);
  signal.pieces.push_back({0.123, 1, -3, 0, 0});
  signal.pieces.push_back({0.2, -0.4, 0, 30, 0});
  signal.pieces.push_back({0.31, 0.2, 9, 0, 25});
  return signal;
}

/// Runge–Kutta of fourth order on A q̈ + B q̇ + K q = h(t), with steps that end at every `corner`; values at the end of
/// each of `points` steps.
template <typename Load>
Eigen::MatrixXd by_runge_kutta(const numerics::DynamicMatrices& m, const Load& load, double step, Eigen::Index points,
                               const std::vector<double>& corners, int parts) {
  const Eigen::Index n = m.size();
  const Eigen::MatrixXd inverse = m.A.inverse();
  const auto rate = [&](double t, const Eigen::VectorXd& s) -> Eigen::VectorXd {
    Eigen::VectorXd r(2 * n);
    r << s.tail(n), inverse * (load(t) - m.B * s.tail(n) - m.K * s.head(n));
    return r;
  };
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(2 * n, points);
  Eigen::VectorXd s = Eigen::VectorXd::Zero(2 * n);
  for (Eigen::Index i = 1; i < points; ++i) {
    std::vector<double> times = {step * static_cast<double>(i - 1), step * static_cast<double>(i)};
    for (const double corner : corners)
      if (corner > times.front() && corner < times.back()) times.insert(times.end() - 1, corner);
    for (std::size_t k = 0; k + 1 < times.size(); ++k) {
      const double h = (times[k + 1] - times[k]) / parts;
      for (int part = 0; part < parts; ++part) {
        // The load is evaluated inside the step, never beyond its corners.
        const double t = times[k] + part * h, inside = 1e-9 * h;
        const Eigen::VectorXd a = rate(t + inside, s), b = rate(t + h / 2, s + h / 2 * a),
                              c = rate(t + h / 2, s + h / 2 * b), d = rate(t + h - inside, s + h * c);
        s += h / 6 * (a + 2 * b + 2 * c + d);
      }
    }
    result.col(i) = s;
  }
  return result;
}

std::vector<double> corners_of(const excitation::Signal& signal) {
  std::vector<double> corners;
  for (const excitation::Piece& piece : signal.pieces) corners.push_back(piece.start);
  return corners;
}

TEST(Transient, AgreesWithRungeKuttaOnSkewBodiesUnderForcesOfAllKindsOfPieces) {
  constexpr double truncation = 1e-9;  // fourth order, 400 parts of each step
  const model::System system = test::checked(test::RandomSystem(5).description(2, test::RandomDamping::viscous));
  const assembly::Assembled assembled = assembly::assemble(system);
  spatial::Vector6 wrench;
  wrench << 30, -20, 50, 4, -6, 2;
  const auto input = test::force_on(assembled, 1, mixed(), wrench);
  const Eigen::VectorXd h = input.loading.force.terms()[0].value.real();
  const auto r = test::transient(system, assembled, {"coordinates"}, {input}, until(0.5, 0.01));
  const Eigen::MatrixXd other = by_runge_kutta(
      assembled.matrices, [&](double t) -> Eigen::VectorXd { return excitation::state(mixed(), t).value * h; }, 0.01,
      r.time.size(), corners_of(mixed()), 400);
  for (std::size_t k = 0; k < 12; ++k)
    EXPECT_THAT(r.curves[k].values, NearVector(other.row(to_index(k)).transpose().eval(), truncation))
        << r.curves[k].name;
}

TEST(Transient, SettlesIntoTheHarmonicResponseWithDelaysAtSingleGroundEnds) {
  // Two ground ends of one body move one after the other; after the transients the results are Re(ŷ e^{iωt}) of the
  // response with the same delays.
  const model::System system = test::checked(test::RandomSystem(3).description(1, test::RandomDamping::viscous));
  const assembly::Assembled assembled = assembly::assemble(system);
  const double omega = 22, delay = 0.037;
  const std::vector<std::string> words = {"coordinates", "ground", "element 0", "body 0.relative",
                                          "element 1.deflection"};
  const auto sine = excitation::sine_burst(1, omega, 1e6);
  const auto first = test::base_motion(assembled, sine, along(2, 0.01), 0, {0}),
             second = test::base_motion(assembled, sine, along(0, 0.02), 0, {1}, delay);
  for (const auto quantity : {assembly::MotionQuantity::displacement, assembly::MotionQuantity::acceleration}) {
    response::TransientOptions options = until(62, 0.05);
    options.from = 60;
    const auto r = test::transient(system, assembled, words, {first, second}, options, quantity);
    assembly::Loading both = first.loading;
    for (const auto& term : second.loading.motion.terms()) both.motion.add(term);
    const auto steady =
        response::frequency_response(assembled, assembly::channels(system, assembled, words, quantity), both, {omega});
    for (std::size_t k = 0; k < r.curves.size(); ++k) {
      Eigen::VectorXd expected(r.time.size());
      for (Eigen::Index i = 0; i < r.time.size(); ++i)
        expected(i) = std::imag(steady.curves[k].value(0) * std::polar(1.0, omega * r.time(i)));
      EXPECT_THAT(r.curves[k].values, NearVector(expected, round_off)) << r.curves[k].name;
    }
  }
}

TEST(Transient, BaseByOffDiagonalBlocksAgreesWithInertialForcesInRelativeCoordinates) {
  const model::System system = test::checked(test::RandomSystem(8).description(2, test::RandomDamping::viscous));
  const assembly::Assembled assembled = assembly::assemble(system);
  spatial::Vector6 direction;
  direction << 1, -2, 0.5, 0.3, -0.2, 0.1;
  const auto base = test::base_motion(assembled, mixed(), direction, 2);
  // r: motion of each body with the base, in its axes at its pole. q_r = q − r g, A q̈_r + B q̇_r + K q_r = −A r g̈.
  Eigen::VectorXd r(12);
  for (int b = 0; b < 2; ++b) {
    const spatial::Pose& pose = system.bodies()[b].pose;
    r.segment<6>(6 * b) =
        spatial::both_blocks(pose.rotation).transpose() * spatial::rigid_motion(pose.position) * direction;
  }
  const response::TimeInput inertia{
      "inertia", mixed(), assembly::Loading((-(assembled.matrices.A * r)).cast<std::complex<double>>().eval())};
  const auto by_blocks =
      test::transient(system, assembled, {"body 0.relative", "body 1.relative", "ground"}, {base}, until(0.6, 0.01));
  const auto by_inertia =
      test::transient(system, assembled, {"body 0", "body 1", "ground"}, {inertia}, until(0.6, 0.01));
  for (std::size_t k = 0; k < by_blocks.curves.size(); ++k)
    EXPECT_THAT(by_blocks.curves[k].values, NearVector(by_inertia.curves[k].values, round_off))
        << by_blocks.curves[k].name;
}

/// A body of 3 kg on a coil spring with mass and three internal modes, off the centre, so that all coordinates move.
std::string on_heavy_spring() {
  return "trivet = 1\n[bodies.b]\nmass = 3\ncenter_of_mass = [0, 0, 0.1]\ninertia = {about = \"center_of_mass\", xx = "
         "0.1, yy = 0.12, zz = 0.1}\n"
         "[elements.s]\ntype = \"coil_spring\"\non = \"b\"\nat = [0.02, 0, 0]\nfrom_at = [0.02, 0, "
         "-0.12]\nwire_diameter = 0.006\nmean_diameter = 0.05\n"
         "active_coils = 6\nfree_length = 0.12\nmaterial = \"spring_steel\"\nlevel = \"with_mass\"\ninternal_modes = "
         "3\ndamping = {proportional = 0.001}\n";
}

TEST(Transient, BaseGivenByAccelerationOrVelocityAgreesWithTheSameDisplacement) {
  // 1 − cos κt, its rate κ sin κt and κ² cos κt, on elements with mass, so that all three derivatives act.
  const double kappa = 30;
  const auto project = test::project(on_heavy_spring());
  const model::System& system = project.base().system;
  const assembly::Assembled assembled = assembly::assemble(system);
  ASSERT_GT(assembled.ground.A.cwiseAbs().maxCoeff(), 0);
  const excitation::Signal forms[] = {{{{0, 0, 0, kappa * kappa, kappa}}},
                                      {{{0, 0, kappa * kappa, 0, kappa}}},
                                      {{{0, kappa * kappa, 0, -std::pow(kappa, 4), kappa}}}};
  spatial::Vector6 direction;
  direction << 0.01, 0.02, -0.03, 0.1, 0.02, 0.05;
  std::vector<response::TransientResponse> results;
  for (int derivative = 0; derivative < 3; ++derivative)
    results.push_back(test::transient(system, assembled, {"coordinates", "ground", "base", "b.relative"},
                                      {test::base_motion(assembled, forms[derivative], direction, derivative)},
                                      until(0.5, 0.003)));
  for (int derivative = 1; derivative < 3; ++derivative)
    for (std::size_t k = 0; k < results[0].curves.size(); ++k)
      EXPECT_THAT(results[derivative].curves[k].values, NearVector(results[0].curves[k].values, round_off))
          << results[0].curves[k].name;
}

TEST(Transient, ImpulsesOfAJumpingOrCorneredBaseAreTheLimitOfShortMotionsAlsoThroughMass) {
  // The ground jumps or has a corner. The other signals do the same smoothly within 1 µs, too fast for the fastest mode
  // (some kHz) to respond.
  constexpr double short_time = 1e-6, seen_by_fastest_mode = 1e-4;
  const auto project = test::project(on_heavy_spring());
  const model::System& system = project.base().system;
  const assembly::Assembled assembled = assembly::assemble(system);
  spatial::Vector6 direction;
  direction << 0.01, 0.02, -0.03, 0.1, 0.02, 0.05;
  const excitation::Signal jump = excitation::step(1, 0.01), corner = excitation::ramp(1, 100, 0.01);
  // The middle of the short motion is at the jump, and the velocity of the ramp rises without corners.
  const excitation::Signal short_jump = excitation::rounded_step(1, short_time, 0.01 - short_time / 2),
                           short_corner = excitation::rounded_step(0.01, short_time, 0.01 - short_time / 2);
  const auto run = [&](const excitation::Signal& signal, int derivative) {
    return test::transient(system, assembled, {"coordinates"},
                           {test::base_motion(assembled, signal, direction, derivative)}, until(0.1, 0.004),
                           assembly::MotionQuantity::velocity);
  };
  const auto a = run(jump, 0), b = run(short_jump, 0), c = run(corner, 0), d = run(short_corner, 1);
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_THAT(b.curves[k].values, NearVector(a.curves[k].values, seen_by_fastest_mode)) << a.curves[k].name;
    EXPECT_THAT(d.curves[k].values, NearVector(c.curves[k].values, seen_by_fastest_mode)) << a.curves[k].name;
  }
}

TEST(Transient, TwoDelayedWheelsHaveTheInPhaseAndAntiPhaseLimits) {
  const model::System system = test::checked(test::RandomSystem(3).description(1, test::RandomDamping::viscous));
  const assembly::Assembled assembled = assembly::assemble(system);
  const double omega = 18, period = 2 * pi / omega;
  const auto sine = excitation::sine_burst(0.01, omega, 1e6), reversed = excitation::scaled(sine, -1);
  response::TransientOptions options = until(62, 0.02);
  options.from = 60;
  const auto motion = [&](const excitation::Signal& second, double delay) {
    return test::transient(system, assembled, {"coordinates"},
                           {test::base_motion(assembled, sine, along(2), 0, {0}),
                            test::base_motion(assembled, second, along(2), 0, {1}, delay)},
                           options);
  };
  const auto together = motion(sine, 0), one_period = motion(sine, period), against = motion(reversed, 0),
             half = motion(sine, period / 2);
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_THAT(one_period.curves[k].values, NearVector(together.curves[k].values, round_off));
    EXPECT_THAT(half.curves[k].values, NearVector(against.curves[k].values, round_off));
  }
}

TEST(Transient, NegativeDelayBeginsBeforeTimeZero) {
  const model::System system = test::checked(test::RandomSystem(3).description(1, test::RandomDamping::viscous));
  const assembly::Assembled assembled = assembly::assemble(system);
  const auto early = test::transient(system, assembled, {"coordinates"},
                                     {test::base_motion(assembled, mixed(), along(2), 0, {0}, -0.2)}, until(0.5, 0.01));
  response::TransientOptions later = until(0.7, 0.01);
  later.from = 0.2;
  const auto shifted = test::transient(system, assembled, {"coordinates"},
                                       {test::base_motion(assembled, mixed(), along(2), 0, {0})}, later);
  for (std::size_t k = 0; k < 6; ++k)
    EXPECT_THAT(early.curves[k].values, NearVector(shifted.curves[k].values, round_off));
}

TEST(Transient, MaxwellBranchAgreesWithRungeKuttaOnItsOwnEquations) {
  // m q̈ = u − k q − g k (q − z); z has no mass, and its dashpot gives gkτ ż = gk (q − z).
  constexpr double truncation = 1e-9;  // fourth order, 2000 parts of each step
  const double k = 800, ratio = 1.5, time = 0.03, mass = 2;
  const auto project = test::project(
      "trivet = 1\n[bodies.b]\nmass = 2\nfree = [\"x\"]\n[elements.s]\ntype = \"three_springs\"\non = \"b\"\nat = [0, "
      "0, 0]\n"
      "translation = [800, 0, 0]\ndamping = {zener = {ratio = 1.5, time = 0.03}}\n");
  const model::System& system = project.base().system;
  const assembly::Assembled assembled = assembly::assemble(system);
  const auto r = test::transient(system, assembled, {"b.x", "s"}, {test::force_on(assembled, 0, mixed(), along(0))},
                                 until(0.6, 0.02));
  Eigen::Vector3d s = Eigen::Vector3d::Zero();
  const auto rate = [&](double t, const Eigen::Vector3d& y) -> Eigen::Vector3d {
    return {y(1), (excitation::state(mixed(), t).value - k * y(0) - ratio * k * (y(0) - y(2))) / mass,
            (y(0) - y(2)) / time};
  };
  Eigen::VectorXd q = Eigen::VectorXd::Zero(r.time.size()), force = q;
  constexpr int parts = 2000;
  constexpr double h = 0.02 / parts;  // the corners of the signal, in milliseconds, are at ends of parts
  for (Eigen::Index i = 1; i < r.time.size(); ++i) {
    for (int part = 0; part < parts; ++part) {
      const double t = 0.02 * static_cast<double>(i - 1) + part * h, inside = 1e-9 * h;
      const Eigen::Vector3d a = rate(t + inside, s), b = rate(t + h / 2, s + h / 2 * a),
                            c = rate(t + h / 2, s + h / 2 * b), d = rate(t + h - inside, s + h * c);
      s += h / 6 * (a + 2 * b + 2 * c + d);
    }
    q(i) = s(0);
    force(i) = k * s(0) + ratio * k * (s(0) - s(2));
  }
  EXPECT_THAT(test::curve(r, "b.x").values, NearVector(q, truncation));
  EXPECT_THAT(test::curve(r, "s.force.x").values, NearVector(force, truncation));
}

TEST(Transient, DoesNotDependOnTheStepOfItsChannels) {
  // Samples at irregular times, points between them, and points so coarse that many corners are between two.
  const model::System system = test::checked(test::RandomSystem(5).description(2, test::RandomDamping::viscous));
  const assembly::Assembled assembled = assembly::assemble(system);
  excitation::Samples samples;
  for (int i = 0; i < 300; ++i) {
    samples.times.push_back(0.0037 * i + 0.001 * std::sin(i));
    samples.values.push_back(i == 0 ? 0 : std::sin(0.3 * i) + 0.2 * std::cos(1.7 * i * i));
  }
  const auto signal = excitation::from_samples(samples);
  const auto force = test::force_on(assembled, 1, signal, along(2)),
             base = test::base_motion(assembled, signal, along(0, 1e-3));
  const auto fine = test::transient(system, assembled, {"coordinates", "ground"}, {force, base}, until(1.2, 0.0005));
  const auto coarse = test::transient(system, assembled, {"coordinates", "ground"}, {force, base}, until(1.2, 0.06));
  for (std::size_t k = 0; k < fine.curves.size(); ++k) {
    Eigen::VectorXd expected(coarse.time.size());
    for (Eigen::Index i = 0; i < expected.size(); ++i) expected(i) = fine.curves[k].values(120 * i);
    EXPECT_THAT(coarse.curves[k].values, NearVector(expected, round_off)) << fine.curves[k].name;
  }
}

TEST(Transient, SeparatedStatesAgreeWithTheExponentialOfTheWholeMatrix) {
  // Two skew bodies with dampers that couple all modes; steps between corners, so that all levels and the series act.
  const model::System system = test::checked(test::RandomSystem(5).description(2, test::RandomDamping::viscous));
  const assembly::Assembled assembled = assembly::assemble(system);
  response::Drive drive{response::InputMatrix::Zero(12, 5), response::InputMatrix::Zero(assembled.ground.size(), 5)};
  drive.force.col(response::of_value) = Eigen::VectorXd::LinSpaced(12, -1, 2);
  const excitation::Signal signal = mixed();
  const std::vector<response::InputCourse> courses = {response::InputCourse(signal, 0)};
  const response::StateSpace whole(assembled.matrices, {drive}), separated = whole.decoupled();
  EXPECT_THAT(separated.groups().dense, testing::IsEmpty());
  Eigen::MatrixXd found[2];
  for (const auto* space : {&whole, &separated}) {
    response::TimeStepper stepper(*space, courses, 0.013, 1e-15);
    response::StepperState state{0, Eigen::VectorXd::Zero(space->size()), {-1}};
    stepper.apply_corners(state);
    Eigen::MatrixXd& q = found[space == &whole ? 0 : 1];
    q.resize(12, 50);
    for (Eigen::Index i = 0; i < 50; ++i) {
      stepper.advance(state, 0.013 * static_cast<double>(i + 1));
      q.col(i) = space->displacements().on_state * state.x;
    }
  }
  for (Eigen::Index k = 0; k < 12; ++k)
    EXPECT_THAT(found[1].row(k).transpose().eval(), NearVector(found[0].row(k).transpose().eval(), round_off));
}

TEST(Transient, FindsTheExtremesOfAFineCurveFromACoarseOne) {
  constexpr double between_fine_points = 3e-4;  // h²ω²/8 of the fastest mode, 700 rad/s, is 6e-4 of its own share
  const model::System system = test::checked(test::RandomSystem(5).description(2, test::RandomDamping::viscous));
  const assembly::Assembled assembled = assembly::assemble(system);
  const auto force = test::force_on(assembled, 1, mixed(), along(2));
  for (const auto quantity : {assembly::MotionQuantity::displacement, assembly::MotionQuantity::acceleration}) {
    const auto fine = test::transient(system, assembled, {"coordinates"}, {force}, until(1.2, 0.0001), quantity);
    const auto coarse = test::transient(system, assembled, {"coordinates"}, {force}, until(1.2, 0.002), quantity);
    for (std::size_t k = 0; k < fine.curves.size(); ++k) {
      const double range = fine.curves[k].values.maxCoeff() - fine.curves[k].values.minCoeff();
      EXPECT_NEAR(coarse.curves[k].largest.value, fine.curves[k].values.maxCoeff(), between_fine_points * range)
          << fine.curves[k].name;
      EXPECT_NEAR(coarse.curves[k].smallest.value, fine.curves[k].values.minCoeff(), between_fine_points * range)
          << fine.curves[k].name;
      EXPECT_GE(coarse.curves[k].largest.value, coarse.curves[k].values.maxCoeff());
    }
  }
}

}  // namespace transient_test
