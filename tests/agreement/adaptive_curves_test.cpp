// SPDX-License-Identifier: BSD-3-Clause
// A curve drawn from few solves agrees with 100,000 uniform points and with all peaks.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "support/projects.h"
#include "support/random_system.h"
#include "trivet/foundation/index.h"
#include "trivet/judging/read_project.h"
#include "trivet/response/steady/curve_model.h"
#include "trivet/response/steady/frequency_grid.h"

namespace adaptive_curves_test {

using namespace trivet;

constexpr int most_solves = 120;
constexpr int uniform_points = 100000;
constexpr double picture_tolerance = 1e-3;  // of the value of the curve
constexpr double peak_tolerance = 1e-8;     // peaks are drawn points: round-off over damping ratios from 1e-6 on
// Differences that no picture shows are allowed: values below a millionth of the largest of their curve, and, near a
// zero, less than a thousandth of the higher of the two neighbouring drawn points.
constexpr double invisible = 1e-6, near_zero = 1e-3;
// A curve so small compared with the others of its unit is half round-off.
constexpr double round_off_share = 1e-10;

/// Everything that is drawn of one system, and the system for the exact values.
struct Picture {
  assembly::Assembled assembled;
  std::vector<assembly::Channel> channels;
  assembly::Loading loading;
  response::Peaks peaks;
  response::CurveModel model;
  response::FrequencyResponse drawn;
};

Picture picture(const model::System& system, const assembly::Band& band,
                const std::vector<std::string>& of = {"coordinates"}) {
  assembly::Assembled assembled = assembly::assemble(system);
  const modal::Modes modes = modal::modes(system, assembled);
  const modal::Roots roots = modal::roots(system, assembled, modes);
  auto channels = assembly::channels(system, assembled, of, assembly::MotionQuantity::displacement);
  assembly::Loading loading = assembly::harmonic_loading(system, assembled);
  response::Peaks peaks = response::peaks(assembled, channels, loading, modes, roots, {.search_to = band.to});
  response::CurveModel model = response::curve_model(assembled, channels, loading, roots.poles, peaks, band);
  response::FrequencyResponse drawn =
      response::interpolated(model, channels, peaks, response::drawing_grid(model, peaks));
  return {std::move(assembled), std::move(channels), std::move(loading),
          std::move(peaks),     std::move(model),    std::move(drawn)};
}

/// Straight lines between the drawn points, and the higher end of each as the scale for values between them.
class Lines {
 public:
  Lines(const response::FrequencyResponse& drawn, std::size_t curve)
      : omega_(drawn.angular_frequency), y_(drawn.curves[curve].value.cwiseAbs()) {}

  struct Point {
    double value = 0, higher = 0;
  };
  [[nodiscard]] Point at(double w) const {
    const auto above = std::upper_bound(omega_.begin(), omega_.end() - 1, w) - omega_.begin();
    const double a = y_(above - 1), b = y_(above), from = omega_[above - 1], to = omega_[above];
    if (w == from) return {a, a};
    if (w == to) return {b, b};
    return {a + (b - a) * (w - from) / (to - from), std::max(a, b)};
  }

 private:
  const std::vector<double>& omega_;
  Eigen::VectorXd y_;
};

void expect_like_uniform_points(const Picture& p, int allowed_solves = most_solves) {
  EXPECT_LE(p.model.solves, allowed_solves);
  EXPECT_EQ(p.drawn.solves, p.model.solves);
  EXPECT_LE(p.model.worst_error, picture_tolerance);
  EXPECT_GT(p.model.tests, 0);
  std::vector<double> omega = response::linear_grid(p.model.band, uniform_points);
  for (const auto& of_curve : response::extrema(p.peaks, p.model.band))
    for (const response::Extremum& e : of_curve)
      for (int k = -9; k <= 9; ++k) omega.push_back(e.angular_frequency * (1 + k * std::abs(k) * 1e-6));
  std::erase_if(
      omega, [&](double w) { return w < p.drawn.angular_frequency.front() || w > p.drawn.angular_frequency.back(); });
  const response::FrequencyResponse truth = response::frequency_response(p.assembled, p.channels, p.loading, omega);
  std::vector<double> highest;
  for (const response::Curve& curve : truth.curves)
    highest.push_back(curve.value.cwiseAbs().unaryExpr([](double a) { return std::isfinite(a) ? a : 0.0; }).maxCoeff());
  for (std::size_t c = 0; c < p.channels.size(); ++c) {
    double of_unit = 0;
    for (std::size_t other = 0; other < p.channels.size(); ++other)
      if (p.channels[other].unit == p.channels[c].unit) of_unit = std::max(of_unit, highest[other]);
    if (p.peaks.curves[c].vanishes || highest[c] < round_off_share * of_unit) continue;
    const Lines lines(p.drawn, c);
    double worst = 0, worst_at = 0;
    for (std::size_t i = 0; i < omega.size(); ++i) {
      const double y = std::abs(truth.curves[c].value(to_index(i)));
      const Lines::Point point = lines.at(omega[i]);
      if (!std::isfinite(y) || !std::isfinite(point.higher) || y < invisible * highest[c]) continue;
      const double deviation = std::abs(point.value - y) / std::max(y, near_zero * point.higher);
      if (deviation > worst) worst = deviation, worst_at = omega[i];
    }
    EXPECT_LE(worst, picture_tolerance) << p.channels[c].name << " at " << worst_at << " rad/s";
  }
  for (const response::Peak& peak : p.peaks.list) {
    if (!std::isfinite(peak.amplitude) || peak.angular_frequency > p.model.band.to ||
        peak.angular_frequency < p.model.band.from)
      continue;
    EXPECT_NEAR(Lines(p.drawn, peak.curve).at(peak.angular_frequency).value / peak.amplitude, 1, peak_tolerance)
        << p.channels[peak.curve].name << " at " << peak.angular_frequency << " rad/s";
  }
}

/// The system with the damping of all elements scaled so that the least damping ratio is `ratio`.
model::System with_damping_ratio(model::Description description, double ratio) {
  const auto least = [&] {
    double smallest = 1;
    for (const modal::Root& root : modal::roots(test::checked(description)).list)
      smallest = std::min(smallest, root.damping_ratio.value_or(1));
    return smallest;
  };
  const double factor = ratio / least();
  for (model::Element& element : description.elements)
    std::get<elements::DampingMatrix>(element.law.damping).matrix *= factor;
  return test::checked(description);
}

assembly::Band band_of(const model::System& system) {
  double highest = 0;
  for (const modal::Mode& mode : modal::modes(system, assembly::assemble(system)).list)
    highest = std::max(highest, mode.angular_frequency.value_or(0));
  return {0, 1.3 * highest};
}

class GeneralDamping : public testing::TestWithParam<double> {};

TEST_P(GeneralDamping, IsDrawnFromFewSolves) {
  for (const unsigned seed : {1u, 2u}) {
    const model::System system =
        with_damping_ratio(test::RandomSystem(seed).description(1, test::RandomDamping::viscous), GetParam());
    expect_like_uniform_points(picture(system, band_of(system)));
  }
}

INSTANTIATE_TEST_SUITE_P(Ratios, GeneralDamping, testing::Values(0.1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6));

TEST(AdaptiveCurves, FollowProportionalDampingOfTwoBodies) {
  const model::System system = test::checked(test::RandomSystem(3).description(2, test::RandomDamping::proportional));
  expect_like_uniform_points(picture(system, band_of(system)));
}

TEST(AdaptiveCurves, FollowLossFactorsOfThreeBodies) {
  const model::System system = test::checked(test::RandomSystem(4).description(3, test::RandomDamping::loss));
  expect_like_uniform_points(picture(system, band_of(system)));
}

TEST(AdaptiveCurves, FollowUndampedResonancesAndRigidBodyModes) {
  const model::System system = test::checked(test::RandomSystem(5).description(2, test::RandomDamping::none, false));
  expect_like_uniform_points(picture(system, {band_of(system).to / 1000, band_of(system).to}));
}

/// A sample project with a force on its frame.
model::System sample(const std::string& file) {
  auto project = judging::read_project(std::string(TRIVET_SOURCE_DIR) + "/tests/samples/" + file,
                                       {"excitations.push.type=\"harmonic\"", "excitations.push.on=\"frame\"",
                                        "excitations.push.at=[0.1,0,0.2]", "excitations.push.force=[1,2,5]"});
  if (!project) throw std::runtime_error(foundation::message(project.error().list().front()));
  return project->base().system;
}

TEST(AdaptiveCurves, FollowAnExactCoilSpring) {
  expect_like_uniform_points(picture(sample("coil_spring.toml"), {1, 2000}));
}

TEST(AdaptiveCurves, FollowTheCornersOfATable) {
  expect_like_uniform_points(picture(sample("air_spring.toml"), {13, 620}));
}

TEST(AdaptiveCurves, FollowAFractionalRubberLaw) {
  const auto project = test::project(R"(
trivet = 1
[bodies.b]
mass = 205
center_of_mass = [0.1, -0.05, 0.2]
inertia = {about = "center_of_mass", xx = 6.6, yy = 9.1, zz = 8.5, xy = 0.65, xz = 0.28, yz = 0.23}
[elements.m]
type = "bushing"
on = "b"
at = [0.1, 0.05, 0]
translation = [4e5, 5e5, 9e5]
rotation = [4e4, 5e4, 3e4]
damping = {fractional_zener = {ratio = 2, time = "5 ms", order = 0.5}}
[excitations.push]
type = "harmonic"
on = "b"
at = [0.1, 0, 0.2]
force = [1, 2, 5]
)");
  expect_like_uniform_points(picture(project.base().system, {1, 600}));
}

TEST(AdaptiveCurves, FollowGroundThatMovesWithDelays) {
  std::string text =
      "trivet = 1\n[bodies.b]\nmass = 2600\ninertia = {about = \"center_of_mass\", xx = 1850, yy = 1450, zz = 2900}\n";
  for (const auto& [name, x, y] : {std::tuple{"fl", 1.25, 1.0}, std::tuple{"fr", 1.25, -1.0},
                                   std::tuple{"rl", -1.25, 1.0}, std::tuple{"rr", -1.25, -1.0}})
    text += std::string("[elements.") + name + "]\ntype = \"bushing\"\non = \"b\"\nat = [" + std::to_string(x) + ", " +
        std::to_string(y) +
        ", -0.3]\ntranslation = [4e5, 5e5, 9e5]\nrotation = [0, 0, 0]\ndamping = {proportional = 0.001}\n";
  text += "[excitations.front]\ntype = \"base\"\nelements = [\"fl\", \"fr\"]\ntranslation = [0, 0, 0.001]\n";
  // A second wheelset, 2.5 m behind at 20 m/s: the phases turn 12 times over the band.
  text +=
      "[excitations.rear]\ntype = \"base\"\nelements = [\"rl\", \"rr\"]\ntranslation = [0, 0, 0.001]\ndelay = \"0.125 "
      "s\"\n";
  const auto project = test::project(text);
  const Picture p = picture(project.base().system, {0, 600}, {"b", "ground"});
  EXPECT_EQ(p.model.delays.size(), 2u);
  expect_like_uniform_points(p);
}

/// A mass on a square of springs, pushed at its centre of mass: only its vertical mode moves, z = F/(k − m ω²).
TEST(AdaptiveCurves, UndampedModesThatNoCurveSeesLeaveNoTrace) {
  std::string text =
      "trivet = 1\n[bodies.m]\nmass = 1000\ncenter_of_mass = [0, 0, 0.1]\n"
      "inertia = {about = \"center_of_mass\", xx = 100, yy = 100, zz = 150}\n";
  for (const auto& [name, at] :
       {std::pair{"a", "0.5, 0.5"}, {"b", "0.5, -0.5"}, {"c", "-0.5, 0.5"}, {"d", "-0.5, -0.5"}})
    text += std::string("[elements.") + name + "]\ntype = \"bushing\"\non = \"m\"\nat = [" + at +
        ", 0]\ntranslation = [1e6, 1e6, 1e7]\nrotation = [0, 0, 0]\n";
  text += "[excitations.f]\ntype = \"harmonic\"\non = \"m\"\nat = [0, 0, 0]\nforce = [0, 0, 1000]\n";
  const auto project = test::project(text);
  const model::System& system = project.base().system;
  const assembly::Band band{6, 380};
  const Picture p = picture(system, band, {"m.z"});
  const modal::Modes modes = modal::modes(system, p.assembled);
  const modal::Roots roots = modal::roots(system, p.assembled, modes);
  const response::CurveModel draft =
      response::curve_model(p.assembled, p.channels, p.loading, roots.poles, response::Peaks(), band);
  constexpr double vertical = 200;                                    // √(4e7/1000) rad/s
  constexpr double fitted = response::CurveModelOptions().tolerance;  // the false resonances were 1e5 m high
  int unseen = 0;
  for (const modal::Mode& mode : modes.list) {
    const double w = *mode.angular_frequency;
    if (std::abs(w - vertical) < 1) continue;
    ++unseen;
    for (const double aside : {0.0, 1e-15, -1e-12, 1e-9, -1e-6, 1e-4}) {
      const double at = w * (1 + aside), exact = 1000 / (4e7 - 1000 * at * at);
      for (const response::CurveModel* model : {&p.model, &draft})
        EXPECT_NEAR(model->at({at})(0, 0).real(), exact, fitted * std::abs(exact)) << at << " rad/s";
    }
  }
  EXPECT_EQ(unseen, 5);
  for (const double aside : {-1e-6, 1e-3}) {  // the seen one stays
    const double at = vertical * (1 + aside), exact = 1000 / (4e7 - 1000 * at * at);
    EXPECT_NEAR(p.model.at({at})(0, 0).real(), exact, fitted * std::abs(exact));
  }
}

study::CaseResults results_of_a_push(const std::string& elements, const std::string& band) {
  const auto project = test::project(
      "trivet = 1\n[bodies.b]\nmass = 10\nfree = [\"z\"]\n[elements.m]\ntype = \"bushing\"\non = \"b\"\nat = [0, 0, "
      "0]\n"
      "translation = [1e4, 1e4, 1e4]\nrotation = [1, 1, 1]\n" +
      elements +
      "[excitations.push]\ntype = \"harmonic\"\non = \"b\"\nat = [0, 0, 0]\nforce = [0, 0, 1]\n[analyses]\nresponse = "
      "{band = " +
      band + "}\n");
  return study::case_results(project.base(), project.base().analyses);
}

TEST(AdaptiveCurves, EveryRowOfATableIsSolvedIfMatricesAreConstant) {
  const study::ResponseResult result = *results_of_a_push("damping = {proportional = 1e-3}\n", "[0, 100]").response;
  EXPECT_EQ(result.curves.solves, static_cast<int>(result.curves.angular_frequency.size()));
  EXPECT_EQ(result.curves.interpolation_error, 0);
  ASSERT_TRUE(result.model.has_value());
  EXPECT_LE(result.model->solves, most_solves);
}

TEST(AdaptiveCurves, RowsBetweenSolvesOfAFrequencyDependentLawStateTheirError) {
  const study::ResponseResult result =
      *results_of_a_push("damping = {fractional_zener = {ratio = 2, time = \"5 ms\", order = 0.5}}\n", "[1, 100]")
           .response;
  EXPECT_LE(result.curves.solves, most_solves);
  EXPECT_GT(result.curves.angular_frequency.size(), to_size(result.curves.solves));
  EXPECT_GT(result.curves.interpolation_error, 0);
  constexpr double between_solves = 1e-4;  // a tenth of what a picture may be off
  EXPECT_LE(result.curves.interpolation_error, between_solves);
}

}  // namespace adaptive_curves_test
