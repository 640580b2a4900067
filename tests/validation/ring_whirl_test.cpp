// SPDX-License-Identifier: BSD-3-Clause
// A disc that whirls around within a ring and rubs on its wall all the time: circular motions and their stability have
// closed forms, as in the frame that turns with the whirl nothing depends on time.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <vector>

#include "support/projects.h"
#include "trivet/nonlinear/branch/steady_branch.h"
#include "trivet/nonlinear/rest/rest_position.h"

namespace ring_whirl_test {

using namespace trivet;
using Complex = std::complex<double>;

struct Disc {
  double mass = 20, stiffness = 8e4, damping = 90, force = 150;
  double play = 1e-3, wall = 3e5, coefficient = 0.15, sticks_with = 4e5;
  double asymmetry = 0;  ///< of the stiffness along y

  [[nodiscard]] std::string project() const {
    return fmt::format(R"(trivet = 1
[bodies.disc]
mass = {0}
free = ["x", "y", "z"]
[elements.shaft]
type = "three_springs"
on = "disc"
at = [0, 0, 0]
translation = [{1}, {8}, 1e6]
damping = {{translation = [{2}, {2}, 100]}}
[elements.ring]
type = "stop"
on = "disc"
at = [0, 0, 0]
axis = "z"
ring = {3}
stiffness = {4}
friction = {{coefficient = {5}, stiffness = {6}}}
[excitations.unbalance]
type = "harmonic"
on = "disc"
at = [0, 0, 0]
force = [{7}, {7}, 0]
phase = [0, "-90 deg", 0, 0, 0, 0]
)",
                       mass, stiffness, damping, play, wall, coefficient, sticks_with, force,
                       stiffness * (1 + asymmetry));
  }

  /// The upper one of both frequencies at which a free whirl just meets the ring: |k − mω² + i c ω| play = F.
  [[nodiscard]] double meets() const {
    const double half = stiffness * mass - damping * damping / 2,
                 constant = stiffness * stiffness - force * force / (play * play);
    return std::sqrt(half + std::sqrt(half * half - mass * mass * constant)) / mass;
  }
  /// |(k − mω² + i c ω) r + (1 + i μ) k_w (r − play)| = F; the whirl is along with the force.
  [[nodiscard]] std::vector<double> radii(double omega) const {
    const Complex pressed = Complex(1, coefficient) * wall,
                  a = Complex(stiffness - mass * omega * omega, damping * omega) + pressed, b = pressed * play;
    const double square = std::norm(a), half = std::real(a * std::conj(b)), constant = std::norm(b) - force * force;
    std::vector<double> found;
    if (const double root = half * half - square * constant; root > 0)
      for (const double sign : {-1.0, 1.0})
        if (const double r = (half + sign * std::sqrt(root)) / square; r > play) found.push_back(r);
    return found;
  }
  /// Magnitudes of the multipliers of the four states of the disc across the axis, descending: with ξ = x + i y beside
  /// r in the turning frame, m(ξ̈ + 2iωξ̇ − ω²ξ) + c(ξ̇ + iωξ) + kξ + (1 + iμ)(k_w x + i N y/r) = 0.
  [[nodiscard]] std::vector<double> multipliers(double omega, double r) const {
    const double pressure = wall * (r - play);
    Eigen::Matrix2d by_place, by_rate;
    by_place << stiffness - mass * omega * omega + wall, -damping * omega - coefficient * pressure / r,
        damping * omega + coefficient * wall, stiffness - mass * omega * omega + pressure / r;
    by_rate << damping, -2 * mass * omega, 2 * mass * omega, damping;
    Eigen::Matrix4d states = Eigen::Matrix4d::Zero();
    states.topRightCorner<2, 2>().setIdentity();
    states.bottomRows<2>() << -by_place / mass, -by_rate / mass;
    std::vector<double> found;
    for (const Complex& exponent : Eigen::EigenSolver<Eigen::Matrix4d>(states).eigenvalues())
      found.push_back(std::exp(exponent.real() * 2 * std::numbers::pi / omega));
    std::sort(found.rbegin(), found.rend());
    return found;
  }
};

nonlinear::SteadyBranch whirls(const Disc& disc, const std::vector<double>& at, bool deep = false) {
  const nonlinear::RestPosition rest = nonlinear::rest_position(test::project(disc.project()).base().system);
  nonlinear::SteadyOptions options{.from = at.front() - 2, .to = at.back() + 1};
  options.harmonics = 1;  // exact: the forces are of one harmonic
  options.of = {"disc.x", "disc.y", "ground.force.x"};
  options.at = at;
  options.deep = deep;
  return nonlinear::steady_branch(rest.system, options);
}

TEST(RingWhirl, HasTheRadiusAndStabilityOfItsClosedForm) {
  const Disc disc;
  const std::vector<double> at = {58, 66, 75, 90, 105};
  const nonlinear::SteadyBranch found = whirls(disc, at, true);
  std::size_t rubbing = 0;
  for (const nonlinear::SteadyPoint& point : found.at) {
    SCOPED_TRACE(point.angular_frequency);
    if (point.results[0].largest <= disc.play) continue;
    ++rubbing;
    const double r = point.results[0].largest;
    const std::vector<double> radii = disc.radii(point.angular_frequency);
    constexpr double exact = 1e-9;  // of the whirl; Newton's method stops there
    EXPECT_TRUE(std::ranges::any_of(radii, [&](double one) { return std::abs(one - r) < exact * r; }))
        << r << " " << testing::PrintToString(radii);
    EXPECT_NEAR(point.results[1].largest, r, exact * r);
    std::vector<double> ours;
    for (const Complex& value : point.multipliers) ours.push_back(std::abs(value));
    std::sort(ours.rbegin(), ours.rend());
    // Those of the motion along the axis are among ours: the four of the closed form must be there.
    constexpr double of_steps = 1e-6;
    for (const double expected : disc.multipliers(point.angular_frequency, r))
      EXPECT_TRUE(std::ranges::any_of(ours, [&](double one) { return std::abs(one - expected) < of_steps; }))
          << expected << " " << testing::PrintToString(ours);
    EXPECT_EQ(point.stable, disc.multipliers(point.angular_frequency, r)[0] < 1);
  }
  EXPECT_GE(rubbing, 4u);
  EXPECT_TRUE(found.winding.differs_at.empty());
  EXPECT_EQ(found.winding.undecided, 0);
  EXPECT_GT(found.winding.points, 10);
}

/// Without friction whirls are stable that friction makes unstable: it drives the disc back around the ring.
TEST(RingWhirl, LosesItsStabilityByFriction) {
  Disc smooth, rough;
  smooth.coefficient = 1e-9;
  rough.coefficient = 0.6;
  std::size_t lost = 0;
  const std::vector<double> at = {75, 90, 105};
  for (const nonlinear::SteadyPoint& point : whirls(rough, at).at) {
    if (point.results[0].largest <= rough.play) continue;
    const double expected = rough.multipliers(point.angular_frequency, point.results[0].largest)[0];
    EXPECT_EQ(point.stable, expected < 1) << expected;
    if (expected > 1) ++lost;
  }
  EXPECT_GT(lost, 0u);
  std::size_t kept = 0;
  for (const nonlinear::SteadyPoint& point : whirls(smooth, at).at)
    if (point.results[0].largest > smooth.play) {
      EXPECT_LT(smooth.multipliers(point.angular_frequency, point.results[0].largest)[0], 1);
      EXPECT_TRUE(point.stable);
      ++kept;
    }
  EXPECT_GT(kept, 0u);
}

/// An ellipse that just meets its ring touches it for a part of the turn within a tiny range only.
TEST(RingWhirl, ThatIsAlmostACircleGoesOnIntoItsRing) {
  Disc disc;
  disc.force = 40;
  disc.asymmetry = 3e-5;
  nonlinear::SteadyOptions options{.from = 38, .to = 88};
  options.harmonics = 5;
  options.of = {"disc.x"};
  options.at = {55, 80};
  const nonlinear::SteadyBranch found =
      nonlinear::steady_branch(nonlinear::rest_position(test::project(disc.project()).base().system).system, options);
  EXPECT_EQ(found.ended, "");
  for (const nonlinear::SteadyPoint& point : found.points) EXPECT_TRUE(std::isfinite(point.largest_multiplier()));
  ASSERT_EQ(found.at.size(), 2u);
  for (const nonlinear::SteadyPoint& point : found.at) {
    constexpr double of_asymmetry = 1e-3;
    const double r = point.results[0].largest;
    const std::vector<double> radii = disc.radii(point.angular_frequency);
    EXPECT_TRUE(std::ranges::any_of(radii, [&](double one) { return std::abs(one - r) < of_asymmetry * r; }))
        << r << " " << testing::PrintToString(radii);
  }
}

/// Above its resonance the disc whirls free outside the frequency at which it just meets the ring, pressed and free:
/// the curve turns there, by almost half a turn, over as many kinks as an ellipse needs to touch the ring all around.
TEST(RingWhirl, ThatIsAlmostACircleComesFreeOfItsRing) {
  for (const double asymmetry : {1e-6, 1e-5, 3e-5, 1e-4, 1e-2}) {
    SCOPED_TRACE(asymmetry);
    Disc disc;
    disc.force = 40;
    disc.asymmetry = asymmetry;
    disc.coefficient = 0.03;
    nonlinear::SteadyOptions options{.from = 38, .to = 200};
    options.harmonics = 5;
    options.of = {"disc.x"};
    const nonlinear::SteadyBranch found =
        nonlinear::steady_branch(nonlinear::rest_position(test::project(disc.project()).base().system).system, options);
    EXPECT_EQ(found.ended, "");
    double jumps_up = 0, jumps_down = options.to;
    for (const nonlinear::Fold& fold : found.folds) {
      if (fold.upper) jumps_up = std::max(jumps_up, fold.point.angular_frequency);
      if (!fold.upper) jumps_down = std::min(jumps_down, fold.point.angular_frequency);
    }
    constexpr double of_whirl = 1e-6;
    EXPECT_NEAR(jumps_down, disc.meets(), (of_whirl + asymmetry) * disc.meets());
    const double around = (of_whirl + asymmetry) * jumps_up;
    EXPECT_EQ(disc.radii(jumps_up - around).size(), 2u);
    EXPECT_EQ(disc.radii(jumps_up + around).size(), 0u);
  }
}

}  // namespace ring_whirl_test
