// SPDX-License-Identifier: BSD-3-Clause
// Hard cases and rejections of random vibration, and its building blocks.
#include <gmock/gmock.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <numbers>

#include "support/lyapunov.h"
#include "support/random_system.h"
#include "trivet/assembly/assembled.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/pole_residue.h"
#include "trivet/numerics/linalg/polynomial_roots.h"
#include "trivet/response/random/basis_integrals.h"
#include "trivet/response/random/random_response.h"

namespace random_response_test {

using namespace trivet;
using Complex = std::complex<double>;
constexpr double pi = std::numbers::pi;
constexpr double round_off = 1e-9;              // sums over poles, whose terms cancel in part
constexpr double matrix_round_off = 1e-12;      // a few hundred operations on numbers near 1
constexpr double covariance_round_off = 1e-13;  // a few dozen operations on numbers up to 3

model::Body mass(const std::string& name, double kilograms) {
  model::Body body;
  body.name = name;
  body.mass.mass = kilograms;
  body.has_inertia = false;
  body.free = {true, false, false, false, false, false};
  return body;
}

model::Element strut(const std::string& name, std::optional<std::size_t> from, std::size_t on, double stiffness,
                     elements::Damping damping) {
  model::Element element;
  element.name = name;
  element.type = "matrix";
  element.n.body = from;
  element.k.body = on;
  element.law.nominal_stiffness =
      elements::constant_along_line(stiffness, Eigen::Vector3d::UnitX(), Eigen::Vector3d::Zero(), 0);
  element.law.damping = std::move(damping);
  return element;
}

elements::Damping dashpot(double damping) {
  return elements::DampingMatrix{
      elements::constant_along_line(damping, Eigen::Vector3d::UnitX(), Eigen::Vector3d::Zero(), 0)};
}

struct Case {
  model::System system;
  assembly::Assembled assembled = assembly::assemble(system);
  response::RandomResponse random(const response::RandomLoading& loading,
                                  const response::RandomOptions& options = {}) const {
    return response::random_response(
        assembled, assembly::channels(system, assembled, {"coordinates"}, assembly::MotionQuantity::displacement),
        loading, options);
  }
  assembly::Loading force(std::size_t body = 0) const {
    model::Action action;
    action.body = body;
    action.amplitude(0) = 1;
    return assembly::loading(assembled, action);
  }
};

Case one_mass(double stiffness, elements::Damping damping) {
  model::Description d;
  d.bodies = {mass("m", 1)};
  d.elements = {strut("spring", std::nullopt, 0, stiffness, std::move(damping))};
  return {test::checked(d)};
}

response::RandomLoading white(const Case& c, double from = 0, double to = 1e7) {
  return {{{"force", c.force(), excitation::flat_spectrum(1, from, to)}}, {}};
}

TEST(RandomHardCases, AnyDampingOfOneMassAgreesWithItsClosedForm) {
  // ∫₀^∞ S dω/|Z|² = π S/(2 k c), in velocity π S/(2 m c).
  for (const double ratio : {1e-8, 1e-5, 1e-3, 0.1, 0.7, 0.999999, 1.000001, 1.5, 300.0}) {
    const Case c = one_mass(100, dashpot(2 * ratio * 10));
    const response::RandomChannel result = c.random(white(c, 0, 1e9)).channels[0];
    constexpr double quadrature_error = 2e-8;  // it integrates if two poles nearly coincide
    const double tolerance = std::abs(ratio - 1) < 1e-3 ? quadrature_error : round_off;
    const double beyond_band = 2 * ratio * 10 / 1e9;  // c/m over the end of the band
    EXPECT_NEAR(*result.rms * std::sqrt(2 * 100 * 2 * ratio * 10 / pi), 1, tolerance) << ratio;
    EXPECT_NEAR(*result.zero_crossings * 2 * pi / 10, 1, tolerance + beyond_band) << ratio;
  }
}

TEST(RandomHardCases, EqualMachinesSideBySideRespondLikeOne) {
  model::Description d;
  for (std::size_t i = 0; i < 4; ++i) {
    d.bodies.push_back(mass("m" + std::to_string(i), 1));
    d.elements.push_back(strut("s" + std::to_string(i), std::nullopt, i, 100, dashpot(0.2)));
  }
  // A dashpot between equal machines: their undamped modes are arbitrary, their damped ones are not.
  d.elements.push_back(strut("between", 0, 1, 0.001, dashpot(0.5)));
  const Case c{test::checked(d)};
  const auto random = c.random({{{"a", c.force(0), excitation::flat_spectrum(1, 0, 1e7)},
                                 {"c", c.force(2), excitation::flat_spectrum(1, 0, 1e7)}},
                                {}});
  EXPECT_EQ(random.method, response::RandomMethod::poles) << random.remark;
  EXPECT_NEAR(*random.channels[2].rms, std::sqrt(pi / (2 * 100 * 0.2)), round_off);
  EXPECT_NEAR(random.channels[2].variance_share[1], 1, round_off);
  EXPECT_TRUE(random.channels[3].vanishes);
  EXPECT_EQ(*random.channels[3].rms, 0);
  EXPECT_FALSE(random.channels[3].zero_crossings);
}

TEST(RandomHardCases, AFreeBodyDriftsWithinAFiniteBand) {
  model::Description d;
  d.bodies = {mass("free", 2)};
  const Case c{test::checked(d)};
  const response::RandomResponse random = c.random(white(c, 1, 10));
  EXPECT_EQ(random.method, response::RandomMethod::poles) << random.remark;
  EXPECT_NEAR(*random.channels[0].rms, std::sqrt((1 - 1e-3) / 3) / 2, round_off);  // ∫₁¹⁰ dω/(m² ω⁴)
  const response::RandomChannel from_rest = c.random(white(c, 0, 10)).channels[0];
  EXPECT_FALSE(from_rest.rms || from_rest.rms_of_derivative);
  EXPECT_THAT(from_rest.reason, testing::HasSubstr("begins at 0 Hz"));
}

TEST(RandomHardCases, ABodyOnADashpotAloneHasAFiniteVelocityOnly) {
  const Case c = one_mass(0, dashpot(3));
  const response::RandomChannel result = c.random(white(c, 0, 1e8)).channels[0];
  EXPECT_FALSE(result.rms);
  ASSERT_TRUE(result.rms_of_derivative) << result.reason;
  constexpr double beyond_band = 1e-7;  // c/m over the end of the band is 3e-8
  EXPECT_NEAR(*result.rms_of_derivative, std::sqrt(pi / (2 * 3)), beyond_band);
  const response::RandomChannel band = c.random(white(c, 1, 10)).channels[0];  // ∫ dω/(ω²(ω² + 9))
  EXPECT_NEAR(*band.rms, std::sqrt(((1 - 0.1) - (std::atan(10.0 / 3) - std::atan(1.0 / 3)) / 3) / 9), round_off);
}

TEST(RandomHardCases, AMaxwellBranchKeepsTheFormOfItsPoles) {
  const Case c = one_mass(100, elements::Viscoelastic(elements::GeneralizedMaxwell{{0.6}, {0.08}}));
  const auto random = c.random(white(c, 0, 50));
  EXPECT_EQ(random.method, response::RandomMethod::poles) << random.remark;
  double sum = 0;
  constexpr int steps = 20000;
  for (int i = 0; i <= steps; ++i) {
    const double omega = 50.0 * i / steps;
    const Complex stiffness = 100.0 * (1.0 + 0.6 * Complex(0, omega * 0.08) / (1.0 + Complex(0, omega * 0.08)));
    sum += 50.0 / steps / 3 * (i == 0 || i == steps ? 1 : i % 2 == 1 ? 4 : 2) / std::norm(stiffness - omega * omega);
  }
  EXPECT_NEAR(*random.channels[0].rms / std::sqrt(sum), 1, round_off);
}

TEST(RandomHardCases, AGrowingMotionHasNoStationaryVibration) {
  // A circulatory force: the motion of the mass grows.
  model::Description d;
  d.bodies = {mass("m", 1)};
  d.bodies[0].free[1] = true;
  spatial::Matrix6 follower = spatial::Matrix6::Zero();
  follower.topLeftCorner<2, 2>() << 100, 50, -50, 100;
  model::Element element = strut("follower", std::nullopt, 0, 0, dashpot(1));
  element.symmetric = false;
  element.law.nominal_stiffness = elements::from_moved_end(follower, Eigen::Vector3d::Zero());
  d.elements = {element};
  const Case c{test::checked(d)};
  const response::RandomChannel result = c.random(white(c, 1, 10)).channels[0];
  EXPECT_FALSE(result.rms);
  EXPECT_THAT(result.reason, testing::HasSubstr("grows"));
}

TEST(RandomHardCases, AVeryLongDelayIsIntegratedInPortions) {
  model::Description d;
  d.bodies = {mass("a", 1)};
  d.elements = {strut("one", std::nullopt, 0, 50, dashpot(1)), strut("two", std::nullopt, 0, 50, dashpot(1))};
  const Case c{test::checked(d)};
  const auto ground = [&](double delay) {
    assembly::Loading total{numerics::Load(c.assembled.layout.size()), numerics::Load(c.assembled.ground.size())};
    for (std::size_t e = 0; e < 2; ++e) {
      model::Action action;
      action.elements = {e};
      action.amplitude(0) = 1;
      action.delay = e == 0 ? 0 : delay;
      const assembly::Loading one = assembly::loading(c.assembled, action);
      for (const auto& term : one.motion.terms()) total.motion.add(term);
    }
    return total;
  };
  const excitation::Spectrum spectrum = excitation::flat_spectrum(1, 5, 20);
  const double in_phase = *c.random({{{"g", ground(0), spectrum}}, {}}).channels[0].rms;
  // With a long delay the two are as if uncorrelated, except for the ends of the band, which fall like 1/delay.
  const double apart = *c.random({{{"g", ground(1e5), spectrum}}, {}}).channels[0].rms;
  constexpr double of_the_ends = 1e-5;  // 1/delay, over 1 rad/s
  EXPECT_NEAR(apart / in_phase, std::sqrt(0.5), of_the_ends);
}

TEST(RandomResponse, RejectsInvalidInput) {
  const Case c = one_mass(100, dashpot(1));
  const excitation::Spectrum flat = excitation::flat_spectrum(1, 1, 10);
  EXPECT_THROW((void)c.random({}), foundation::InvalidInput);
  EXPECT_THROW((void)c.random({{{"none", c.force(), {}}}, {}}), foundation::InvalidInput);
  EXPECT_THROW((void)c.random({{{"rest", assembly::Loading(Eigen::VectorXd::Zero(1).eval()), flat}}, {}}),
               foundation::InvalidInput);
  EXPECT_THROW((void)c.random({{{"negative", c.force(), {{{1, 2, -1, 1, true}}}}}, {}}), foundation::InvalidInput);
  EXPECT_THROW((void)c.random({{{"nan", c.force(), {{{1, 2, std::nan(""), 1, true}}}}}, {}}), foundation::InvalidInput);
  EXPECT_THROW((void)c.random({{{"a", c.force(), flat}, {"b", c.force(), flat}}, {{0, 1, {.at_zero = 1.5}, 0}}}),
               foundation::InvalidInput);
  EXPECT_THROW((void)c.random({{{"a", c.force(), flat}}, {}}, {.weighted = {{1, excitation::Weighting::Wk}}}),
               foundation::InvalidInput);
  const auto forces = assembly::channels(c.system, c.assembled, {"spring"}, assembly::MotionQuantity::displacement);
  EXPECT_THROW((void)response::random_response(c.assembled, forces, {{{"a", c.force(), flat}}, {}},
                                               {.weighted = {{0, excitation::Weighting::Wk}}}),
               foundation::InvalidInput);
  EXPECT_EQ(response::check(response::RandomLoading{}, "random").errors(), 1U);
}

TEST(RandomResponse, StopsOnAnInterruption) {
  const Case c = one_mass(100, dashpot(1));
  const auto channels =
      assembly::channels(c.system, c.assembled, {"coordinates"}, assembly::MotionQuantity::displacement);
  EXPECT_THROW((void)response::random_response(c.assembled, channels, white(c), {},
                                               [](std::string_view, double) { throw foundation::Interrupted(); }),
               foundation::Interrupted);
}

TEST(RandomLoading, ContainsEachRandomExcitationAndEachPairOnce) {
  model::Description d;
  d.bodies = {mass("m", 1)};
  d.elements = {strut("spring", std::nullopt, 0, 100, dashpot(1))};
  model::Action push;
  push.body = 0;
  push.amplitude(0) = 1;
  const excitation::Spectrum flat = excitation::flat_spectrum(1, 1, 10);
  d.excitations = {{"a", push, model::Random{flat, {{"b", {.at_zero = 0.5}}}}},
                   {"steady", push, model::Harmonic{}},
                   {"b", push, model::Random{flat, {{"a", {.at_zero = 0.5}}}}}};
  const Case c{test::checked(d)};
  const response::RandomLoading loading = response::random_loading(c.system, c.assembled);
  ASSERT_EQ(loading.inputs.size(), 2U);
  ASSERT_EQ(loading.pairs.size(), 1U);
  EXPECT_EQ(loading.pairs[0].coherence.at_zero, 0.5);
  EXPECT_EQ(response::random_loading(c.system, c.assembled, {"b"}).inputs.size(), 1U);
  EXPECT_THROW((void)response::random_loading(c.system, c.assembled, {"steady"}), foundation::InvalidInput);
}

TEST(PoleResidueForm, IsTheInverseOfTheDynamicStiffnessAlsoWithCoordinatesHeldByStiffnessOnly) {
  numerics::DynamicMatrices m;
  m.A = Eigen::Vector4d(2, 3, 0, 0).asDiagonal();
  m.B = Eigen::Matrix4d::Zero();
  m.B.topLeftCorner(3, 3) << 0.3, -0.1, -0.1, -0.1, 0.4, 0, -0.1, 0, 0.5;
  m.K.resize(4, 4);
  m.K << 30, -10, -4, -5, -10, 25, 0, -6, -4, 0, 9, 0, -5, -6, 0, 12;
  const numerics::PoleResidueForm form = numerics::pole_residue_form(m, Eigen::MatrixXcd::Identity(4, 4));
  EXPECT_EQ(form.poles.size(), 5);
  for (const double omega : {0.5, 3.0, 40.0}) {
    Eigen::MatrixXcd sum = form.static_part;
    for (Eigen::Index k = 0; k < form.poles.size(); ++k)
      sum += form.shapes.col(k) * form.participation.row(k) / (Complex(0, omega) - form.poles(k));
    EXPECT_LE((sum - m.at(omega).inverse()).cwiseAbs().maxCoeff(), matrix_round_off) << omega;
  }
}

TEST(LyapunovCovariance, IsEquipartitionForOneMassAndRejectsGrowth) {
  Eigen::Matrix2d state, intensity = Eigen::Vector2d(0, 3).asDiagonal();
  state << 0, 1, -16, -0.5;
  const Eigen::MatrixXd covariance = test::lyapunov_covariance(state, intensity);
  EXPECT_NEAR(covariance(1, 1), 3 / (2 * 0.5), covariance_round_off);
  EXPECT_NEAR(covariance(0, 0), covariance(1, 1) / 16, covariance_round_off);
  EXPECT_NEAR(covariance(0, 1), 0, covariance_round_off);
  EXPECT_THROW((void)test::lyapunov_covariance(-state, intensity), foundation::NotComputable);
  EXPECT_THROW((void)test::lyapunov_covariance(state, Eigen::MatrixXd::Zero(3, 3)), foundation::InvalidInput);
}

TEST(IntegrationPanels, IntegrateANarrowResonanceAndAWaveToRoundOff) {
  constexpr double node_round_off = 2e-12;  // a node is uncertain by ε 7 in 1e-4
  constexpr double few_roundings = 1e-15;   // sums of 15 products below 1
  const Complex pole(-1e-4, 7);
  const response::IntegrationNodes nodes =
      response::gauss_nodes(response::graded_panels(Eigen::VectorXcd::Constant(1, pole), 0, 20, 3));
  const Eigen::VectorXd lorentz = ((nodes.omega.array() - 7).square() + 1e-8).inverse();
  EXPECT_NEAR(nodes.weight.dot(lorentz) / ((std::atan(13 / 1e-4) + std::atan(7 / 1e-4)) / 1e-4), 1, node_round_off);
  EXPECT_NEAR(nodes.weight.dot((3 * nodes.omega).array().cos().matrix()), std::sin(60.0) / 3, matrix_round_off);
  const response::KronrodRule rule = response::kronrod_rule();
  EXPECT_NEAR((rule.kronrod * rule.node.pow(22)).sum(), 2.0 / 23, few_roundings);
  EXPECT_NEAR((rule.gauss * rule.node.pow(12)).sum(), 2.0 / 13, few_roundings);
}

TEST(PolynomialRoots, AreFoundInAnyUnit) {
  const std::vector<Complex> roots = numerics::polynomial_roots({6e12, -5e6, 1});
  constexpr double sum_round_off = 1e-6, product_round_off = 1;  // 2e-13 of 5e6 and of 6e12
  EXPECT_NEAR(std::abs(roots[0] + roots[1]), 5e6, sum_round_off);
  EXPECT_NEAR(std::abs(roots[0] * roots[1]), 6e12, product_round_off);
}

}  // namespace random_response_test
