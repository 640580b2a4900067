// SPDX-License-Identifier: BSD-3-Clause
// Variances of random vibration by other methods: sums over a fine grid of the frequency response, the Lyapunov
// equation, limits.
#include <gmock/gmock.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "support/lyapunov.h"
#include "support/random_system.h"
#include "trivet/assembly/assembled.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/generalized_modes.h"
#include "trivet/response/random/random_response.h"
#include "trivet/response/steady/frequency_response.h"

namespace random_response_test {

using namespace trivet;
using response::RandomMethod;

/// Error of Simpson's rule on steps of a small fraction of every half width.
constexpr double truncation = 1e-7;
/// Difference of two exact methods: round-off of residues times the number of poles.
constexpr double round_off = 1e-9;
/// Allowed error of the quadrature.
constexpr double settled = 2e-8;

struct Case {
  model::System system;
  assembly::Assembled assembled = assembly::assemble(system);
  std::vector<assembly::Channel> channels(
      const std::vector<std::string>& of,
      assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement) const {
    return assembly::channels(system, assembled, of, quantity);
  }
};

Case random_case(unsigned seed, std::size_t bodies, test::RandomDamping damping) {
  return {test::checked(test::RandomSystem(seed).description(bodies, damping))};
}

assembly::Loading force(const Case& c, std::size_t body) {
  model::Action action;
  action.body = body;
  action.at = {0.1, -0.2, 0.3};
  action.amplitude << 3, -1, 2, 0.5, 0.2, -0.4;
  return assembly::loading(c.assembled, action);
}

assembly::Loading base(const Case& c, int derivative, std::optional<model::Wave> wave = {}) {
  model::Action action;
  action.amplitude << 0.3, -0.2, 1, 0.05, 0.1, 0;
  action.derivative = derivative;
  action.wave = wave;
  return assembly::loading(c.assembled, action);
}

/// A straight line, then a power law with a non-integer exponent, with a step between.
excitation::Spectrum two_pieces(double from, double middle, double to) {
  return {{{from, middle, 2, 5, true}, {middle, to, 3, 0.07, false}}};
}

/// Mean squares of the `derivative`-th derivatives of all channels, by Simpson's rule between breakpoints.
Eigen::VectorXd summed(const Case& c, const std::vector<assembly::Channel>& channels,
                       const response::RandomLoading& loading, int steps, int derivative = 0) {
  Eigen::VectorXd total = Eigen::VectorXd::Zero(to_index(channels.size()));
  const std::vector<double> ends = excitation::breakpoints(loading.inputs[0].spectrum);
  for (std::size_t piece = 1; piece < ends.size(); ++piece) {
    // Just inside, so that a step of the density is evaluated on the correct side.
    const double a = ends[piece - 1] * (1 + 1e-14), b = ends[piece] * (1 - 1e-14), h = (b - a) / steps;
    std::vector<double> omega;
    for (int i = 0; i <= steps; ++i) omega.push_back(a + h * i);
    std::vector<response::FrequencyResponse> responses;
    for (const auto& input : loading.inputs)
      responses.push_back(response::frequency_response(c.assembled, channels, input.loading, omega));
    excitation::RandomInputs inputs{{}, loading.pairs};
    for (const auto& input : loading.inputs) inputs.spectra.push_back(input.spectrum);
    for (int i = 0; i <= steps; ++i) {
      const double weight = h / 3 *
          (i == 0 || i == steps ? 1
               : i % 2 == 1     ? 4
                                : 2) *
          std::pow(omega[i], 2 * derivative);
      const Eigen::MatrixXcd density = excitation::density_matrix(inputs, omega[i]);
      for (std::size_t k = 0; k < channels.size(); ++k) {
        Eigen::VectorXcd h_k(to_index(responses.size()));
        for (std::size_t r = 0; r < responses.size(); ++r) h_k(to_index(r)) = responses[r].curves[k].value(i);
        total(to_index(k)) += weight * h_k.dot(density * h_k).real();
      }
    }
  }
  return total;
}

void expect_mean_squares(const response::RandomResponse& response, const Eigen::VectorXd& expected, double tolerance,
                         bool of_derivative = false) {
  ASSERT_EQ(response.channels.size(), to_size(expected.size()));
  for (std::size_t c = 0; c < response.channels.size(); ++c) {
    const response::RandomChannel& channel = response.channels[c];
    const std::optional<double> rms = of_derivative ? channel.rms_of_derivative : channel.rms;
    ASSERT_TRUE(rms) << channel.name << ": " << channel.reason;
    EXPECT_NEAR(*rms * *rms / expected(to_index(c)), 1, tolerance) << channel.name;
  }
}

TEST(RandomResponse, TheVarianceOverPolesIsThatOfAFineGrid) {
  const Case c = random_case(21, 2, test::RandomDamping::viscous);
  const auto channels = c.channels({"coordinates", "element 0", "element 1.deflection", "ground"});
  for (const assembly::Loading& load : {force(c, 1), base(c, 0)}) {
    const response::RandomLoading loading{{{"input", load, two_pieces(2, 40, 400)}}, {}};
    const response::RandomResponse random = response::random_response(c.assembled, channels, loading);
    EXPECT_EQ(random.method, RandomMethod::poles) << random.remark;
    expect_mean_squares(random, summed(c, channels, loading, 20000), truncation);
    expect_mean_squares(random, summed(c, channels, loading, 20000, 1), truncation, true);
  }
}

TEST(RandomResponse, AccelerationsOfABodyAreThoseOfAFineGrid) {
  const Case c = random_case(22, 1, test::RandomDamping::viscous);
  const auto channels = c.channels({"body 0", "body 0.tip.relative"}, assembly::MotionQuantity::acceleration);
  const response::RandomLoading loading{{{"floor", base(c, 2), two_pieces(3, 60, 300)}}, {}};
  expect_mean_squares(response::random_response(c.assembled, channels, loading), summed(c, channels, loading, 20000),
                      truncation);
}

TEST(RandomResponse, ProportionalDampingIsSolvedModeByModeAndAgrees) {
  const Case c = random_case(23, 2, test::RandomDamping::proportional);
  const auto channels = c.channels({"coordinates", "element 2"});
  const response::RandomLoading loading{{{"input", force(c, 0), two_pieces(2, 40, 400)}}, {}};
  const response::RandomResponse random = response::random_response(c.assembled, channels, loading);
  EXPECT_EQ(random.method, RandomMethod::poles) << random.remark;
  expect_mean_squares(random, summed(c, channels, loading, 40000), truncation);
}

TEST(RandomResponse, ALossFactorAgreesWithAFineGrid) {
  const Case c = random_case(24, 2, test::RandomDamping::loss);
  const auto channels = c.channels({"coordinates", "ground"});
  const response::RandomLoading loading{{{"input", force(c, 1), two_pieces(2, 40, 400)}}, {}};
  expect_mean_squares(response::random_response(c.assembled, channels, loading), summed(c, channels, loading, 40000),
                      truncation);
}

TEST(RandomResponse, ATravellingWaveAgreesWithAFineGrid) {
  const Case c = random_case(25, 2, test::RandomDamping::viscous);
  const auto channels = c.channels({"coordinates", "element 0.deflection"});
  const response::RandomLoading loading{
      {{"wave", base(c, 0, model::Wave{Eigen::Vector3d(0.6, 0.8, 0), 4.0}), two_pieces(2, 40, 400)}}, {}};
  expect_mean_squares(response::random_response(c.assembled, channels, loading), summed(c, channels, loading, 40000),
                      truncation);
}

TEST(RandomResponse, AVeryFastWaveIsAnInPhaseMotionOfAllGroundPoints) {
  const Case c = random_case(26, 2, test::RandomDamping::viscous);
  const auto channels = c.channels({"coordinates"});
  const excitation::Spectrum spectrum = two_pieces(2, 40, 400);
  model::Action together;
  together.amplitude << 0.3, -0.2, 1, 0.05, 0.1, 0;
  for (const auto& end : c.assembled.ground.ends) together.elements.push_back(end.element);
  const auto wave = response::random_response(
      c.assembled, channels, {{{"wave", base(c, 0, model::Wave{Eigen::Vector3d::UnitX(), 1e12}), spectrum}}, {}});
  const auto in_phase = response::random_response(c.assembled, channels,
                                                  {{{"all", assembly::loading(c.assembled, together), spectrum}}, {}});
  for (std::size_t i = 0; i < channels.size(); ++i)
    EXPECT_NEAR(*wave.channels[i].rms / *in_phase.channels[i].rms, 1, round_off);
}

/// Covariance of (q, q̇) under one white force, 0 … ∞, by the Lyapunov equation.
Eigen::MatrixXd white_noise_covariance(const Case& c, const assembly::Loading& load, double density) {
  const auto& m = c.assembled.matrices;
  const Eigen::Index n = m.size();
  const Eigen::MatrixXd inverse = m.A.inverse();
  Eigen::MatrixXd state = Eigen::MatrixXd::Zero(2 * n, 2 * n), intensity = state;
  state.topRightCorner(n, n).setIdentity();
  state.bottomLeftCorner(n, n) = -inverse * m.K;
  state.bottomRightCorner(n, n) = -inverse * m.B;
  const Eigen::VectorXd push = inverse * load.force.at(0).real();
  intensity.bottomRightCorner(n, n) = std::numbers::pi * density * push * push.transpose();
  return test::lyapunov_covariance(state, intensity);
}

TEST(RandomResponse, WhiteNoiseAgreesWithTheLyapunovEquation) {
  const Case c = random_case(27, 3, test::RandomDamping::viscous);
  const auto channels = c.channels({"coordinates"});
  const assembly::Loading load = force(c, 2);
  constexpr double density = 0.7, highest = 1e7;
  const auto random = response::random_response(
      c.assembled, channels, {{{"noise", load, excitation::flat_spectrum(density, 0, highest)}}, {}});
  const Eigen::Index n = c.assembled.matrices.size();
  const Eigen::MatrixXd covariance = white_noise_covariance(c, load, density);
  const Eigen::VectorXd push = c.assembled.matrices.A.inverse() * load.force.at(0).real();
  expect_mean_squares(random, covariance.diagonal().head(n), round_off);
  constexpr double of_velocities = 1e-7;  // in a band far above all poles; a variance is allowed an error of 1e-8
  // The band ends at `highest`: the velocities lack the tail, where the masses move as if free.
  expect_mean_squares(random, covariance.diagonal().tail(n) - density / highest * push.cwiseAbs2(), of_velocities,
                      true);
}

TEST(RandomResponse, VeryLightDampingUncouplesTheModes) {
  // A millionth of the damping: the coupling between modes is a damping ratio, 1e-8. Σ π S (φᵀh)² φ²/(2 ω² φᵀBφ).
  constexpr double of_conditioning = 1e-7,
                   estimated = 1e-6;  // the estimated error varies with the compiler
  model::Description description = test::RandomSystem(35).description(2, test::RandomDamping::viscous);
  for (model::Element& element : description.elements)
    std::get<elements::DampingMatrix>(element.law.damping).matrix *= 1e-6;
  const Case c{test::checked(description)};
  const assembly::Loading load = force(c, 1);
  const auto& m = c.assembled.matrices;
  const numerics::GeneralizedModes modes = numerics::generalized_modes(m.K, m.A, true);
  Eigen::VectorXd expected = Eigen::VectorXd::Zero(m.size());
  for (Eigen::Index k = 0; k < m.size(); ++k) {
    const Eigen::VectorXd phi = modes.shapes.col(k);
    const double push = phi.dot(load.force.at(0).real());
    expected += std::numbers::pi * push * push / (2 * modes.lambda(k) * phi.dot(m.B * phi)) * phi.cwiseAbs2();
  }
  const auto random = response::random_response(c.assembled, c.channels({"coordinates"}),
                                                {{{"noise", load, excitation::flat_spectrum(1, 0, 1e6)}}, {}});
  EXPECT_EQ(random.method, RandomMethod::poles) << random.remark;
  for (const response::RandomChannel& channel : random.channels) EXPECT_LE(channel.estimated_error, estimated);
  expect_mean_squares(random, expected, of_conditioning);
}

TEST(RandomResponse, ANarrowInputElsewhereIsNotOverlooked) {
  // Two independent machines; the input of the second has a band of 0.01 rad/s within the 400 rad/s of the first.
  model::Description description = test::RandomSystem(36).description(1, test::RandomDamping::viscous);
  test::RandomSystem other(37);
  description.bodies.push_back(other.body("other"));
  description.elements.push_back(
      other.element("its own", std::nullopt, 1, description.bodies, test::RandomDamping::viscous));
  const Case c{test::checked(description)};
  const auto channels = c.channels({"other"});
  const response::RandomInput narrow{"narrow", force(c, 1), excitation::flat_spectrum(1, 33, 33.01)};
  const auto both =
      response::random_response(c.assembled, channels, {{{"wide", force(c, 0), two_pieces(2, 40, 400)}, narrow}, {}});
  const auto alone = response::random_response(c.assembled, channels, {{narrow}, {}});
  for (std::size_t i = 0; i < channels.size(); ++i) {
    EXPECT_GT(*both.channels[i].rms, 0);
    EXPECT_NEAR(*both.channels[i].rms / *alone.channels[i].rms, 1, round_off);
  }
}

TEST(RandomResponse, CoherentEqualInputsAreOneInputAndUncorrelatedOnesAddUp) {
  const Case c = random_case(28, 2, test::RandomDamping::viscous);
  const auto channels = c.channels({"coordinates", "ground"});
  const excitation::Spectrum spectrum = two_pieces(2, 40, 400);
  const assembly::Loading one = force(c, 0), other = force(c, 1);
  assembly::Loading both = one;
  for (const auto& term : other.force.terms()) both.force.add(term);
  const response::RandomInput first{"first", one, spectrum}, second{"second", other, spectrum};
  const auto together = response::random_response(c.assembled, channels, {{{"both", both, spectrum}}, {}});
  const auto coherent =
      response::random_response(c.assembled, channels, {{first, second}, {{0, 1, {.at_zero = 1}, 0}}});
  const auto apart = response::random_response(c.assembled, channels, {{first, second}, {}});
  const auto only_first = response::random_response(c.assembled, channels, {{first}, {}}),
             only_second = response::random_response(c.assembled, channels, {{second}, {}});
  for (std::size_t i = 0; i < channels.size(); ++i) {
    EXPECT_NEAR(*coherent.channels[i].rms / *together.channels[i].rms, 1, round_off) << channels[i].name;
    const double a = std::pow(*only_first.channels[i].rms, 2), b = std::pow(*only_second.channels[i].rms, 2);
    EXPECT_NEAR(std::pow(*apart.channels[i].rms, 2) / (a + b), 1, round_off) << channels[i].name;
    EXPECT_NEAR(apart.channels[i].variance_share[0], a / (a + b), round_off);
    EXPECT_NEAR(coherent.channels[i].variance_share[0] + coherent.channels[i].variance_share[1], 1, round_off);
  }
}

TEST(RandomResponse, PartlyCoherentLateInputsAgreeWithAFineGrid) {
  const Case c = random_case(29, 2, test::RandomDamping::viscous);
  const auto channels = c.channels({"coordinates"});
  const excitation::Spectrum rising = two_pieces(2, 40, 400), flat = excitation::flat_spectrum(0.4, 2, 400);
  const response::RandomLoading loading{{{"first", force(c, 0), rising}, {"second", base(c, 0), flat}},
                                        {{0, 1, {0.8, 3.0, 2.0, 30.0}, 0.05}}};
  expect_mean_squares(response::random_response(c.assembled, channels, loading), summed(c, channels, loading, 40000),
                      truncation);
}

TEST(RandomResponse, ADelayOfAPairIsTheDelayOfItsSecondInput) {
  const Case c = random_case(30, 2, test::RandomDamping::viscous);
  const auto channels = c.channels({"coordinates"});
  const excitation::Spectrum spectrum = two_pieces(2, 40, 400);
  model::Action late;
  late.body = 1;
  late.at = {0.1, -0.2, 0.3};
  late.amplitude << 3, -1, 2, 0.5, 0.2, -0.4;
  late.delay = 0.06;
  const auto by_pair = response::random_response(
      c.assembled, channels,
      {{{"a", force(c, 0), spectrum}, {"b", force(c, 1), spectrum}}, {{0, 1, {.at_zero = 1}, 0.06}}});
  const auto other_way = response::random_response(
      c.assembled, channels,
      {{{"a", force(c, 0), spectrum}, {"b", force(c, 1), spectrum}}, {{1, 0, {.at_zero = 1}, -0.06}}});
  const auto by_action =
      response::random_response(c.assembled, channels,
                                {{{"a", force(c, 0), spectrum}, {"b", assembly::loading(c.assembled, late), spectrum}},
                                 {{0, 1, {.at_zero = 1}, 0}}});
  for (std::size_t i = 0; i < channels.size(); ++i) {
    EXPECT_NEAR(*by_pair.channels[i].rms / *by_action.channels[i].rms, 1, round_off);
    EXPECT_NEAR(*other_way.channels[i].rms / *by_action.channels[i].rms, 1, round_off);
  }
}

TEST(RandomResponse, AGroundAccelerationIsADisplacementWithItsSpectrumIntegratedTwice) {
  const Case c = random_case(31, 2, test::RandomDamping::viscous);
  const auto channels = c.channels({"coordinates", "element 0", "element 1.deflection"});
  const excitation::Spectrum acceleration = two_pieces(2, 40, 400);
  const auto given = response::random_response(c.assembled, channels, {{{"a", base(c, 2), acceleration}}, {}});
  const auto integrated = response::random_response(
      c.assembled, channels, {{{"a", base(c, 0), excitation::differentiated(acceleration, -2)}}, {}});
  EXPECT_EQ(given.method, RandomMethod::poles) << given.remark;
  for (std::size_t i = 0; i < channels.size(); ++i)
    EXPECT_NEAR(*given.channels[i].rms / *integrated.channels[i].rms, 1, round_off) << channels[i].name;
}

TEST(RandomResponse, ElementsThatDependOnFrequencyAreIntegratedToTheSameValues) {
  model::Description description = test::RandomSystem(32).description(2, test::RandomDamping::viscous);
  const Case plain{test::checked(description)};
  for (model::Element& element : description.elements) {
    const spatial::Matrix12 stiffness = elements::stiffness(element.law),
                            damping = elements::viscous_damping(element.law);
    element.law.scale = 1;
    element.law.nominal_stiffness = stiffness;
    element.law.damping = {};
    element.law.frequency_dependence =
        elements::FrequencyDependence{[=](std::complex<double> omega, double) -> elements::Matrix12c {
                                        return stiffness.cast<std::complex<double>>() +
                                            std::complex<double>(0, 1) * omega * damping.cast<std::complex<double>>();
                                      },
                                      false,
                                      0,
                                      std::numeric_limits<double>::infinity(),
                                      {}};
  }
  const Case exact{test::checked(description)};
  const std::vector<std::string> of = {"coordinates", "element 0", "ground"};
  const excitation::Spectrum spectrum = two_pieces(2, 40, 400);
  for (const auto& load : {force, +[](const Case& c, std::size_t) { return base(c, 0); }}) {
    const auto by_poles =
        response::random_response(plain.assembled, plain.channels(of), {{{"f", load(plain, 1), spectrum}}, {}});
    const auto by_quadrature =
        response::random_response(exact.assembled, exact.channels(of), {{{"f", load(exact, 1), spectrum}}, {}});
    EXPECT_EQ(by_quadrature.method, RandomMethod::quadrature);
    for (std::size_t i = 0; i < by_poles.channels.size(); ++i) {
      EXPECT_NEAR(*by_quadrature.channels[i].rms / *by_poles.channels[i].rms, 1, settled) << by_poles.channels[i].name;
      EXPECT_NEAR(*by_quadrature.channels[i].zero_crossings / *by_poles.channels[i].zero_crossings, 1, settled);
      EXPECT_LE(by_quadrature.channels[i].estimated_error, settled);
    }
  }
}

TEST(RandomResponse, TwoEqualCoherentInputsHaveFourTimesTheDensityOfOne) {
  const Case c = random_case(34, 1, test::RandomDamping::viscous);
  const auto channels = c.channels({"coordinates"});
  constexpr double last_digits = 1e-12;  // four products of the same numbers
  const response::RandomInput input{"one", force(c, 0), two_pieces(2, 40, 400)};
  const auto one = response::random_curves(c.assembled, channels, {{input}, {}}, {3, 30, 300});
  const auto two =
      response::random_curves(c.assembled, channels, {{input, input}, {{0, 1, {.at_zero = 1}, 0}}}, {3, 30, 300});
  for (std::size_t k = 0; k < channels.size(); ++k)
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(two.density[k][i] / one.density[k][i], 4, last_digits);
}

TEST(RandomResponse, TheSpectralDensitiesAddUpToTheVariance) {
  const Case c = random_case(33, 2, test::RandomDamping::viscous);
  const auto channels = c.channels({"coordinates"});
  const response::RandomLoading loading{
      {{"first", force(c, 0), two_pieces(2, 40, 400)}, {"second", base(c, 0), excitation::flat_spectrum(0.4, 5, 200)}},
      {{0, 1, {0.5}, 0.01}}};
  const auto random = response::random_response(c.assembled, channels, loading);
  const response::RandomCurves curves = response::random_curves(c.assembled, channels, loading);
  constexpr double trapezoids = 1e-2;  // error on a grid for pictures
  for (std::size_t k = 0; k < channels.size(); ++k) {
    double sum = 0;
    for (std::size_t i = 1; i < curves.angular_frequency.size(); ++i)
      sum += 0.5 * (curves.density[k][i] + curves.density[k][i - 1]) *
          (curves.angular_frequency[i] - curves.angular_frequency[i - 1]);
    EXPECT_NEAR(sum / std::pow(*random.channels[k].rms, 2), 1, trapezoids) << channels[k].name;
  }
}

}  // namespace random_response_test
