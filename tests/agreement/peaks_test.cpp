// SPDX-License-Identifier: BSD-3-Clause
// Exact peaks against closed forms of one degree of freedom, and against a dense scan of random systems.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>

#include "support/matchers.h"
#include "support/projects.h"
#include "support/random_system.h"
#include "trivet/assembly/loads.h"
#include "trivet/modal/roots.h"
#include "trivet/response/steady/frequency_response.h"
#include "trivet/response/steady/resonant_mode.h"

namespace peaks_test {

using namespace trivet;
using test::RelativelyNear;
constexpr double amplitude_digits = 1e-10;  // from poles and residues of one coordinate
constexpr double frequency_digits = 1e-8;   // the place of a maximum is known to the root of round-off
constexpr double last_digits = 1e-14;       // a pole without damping
constexpr double over_the_damping = 1e-9;   // ε/ζ with ζ = 1e-6, and room

response::Peaks peaks_of(const model::System& system, const std::vector<std::string>& of,
                         assembly::MotionQuantity quantity) {
  const assembly::Assembled assembled = assembly::assemble(system);
  const modal::Modes modes = modal::modes(system, assembled);
  const std::vector<assembly::Channel> channels = assembly::channels(system, assembled, of, quantity);
  const assembly::Loading loading = assembly::harmonic_loading(system, assembled);
  response::Peaks found = response::peaks(assembled, channels, loading, modes, modal::roots(system, assembled, modes));
  response::set_nearest_modes(assembled, channels, loading, modes, found);
  return found;
}

/// m = 2 kg, ω0 = 30 rad/s, F = 5 N.
response::Peaks single_mass(double ratio, double loss, assembly::MotionQuantity quantity,
                            const std::string& of = "coordinates") {
  const auto project =
      test::project(test::chain({2}, {1800}, {2 * ratio * 60}, {loss}) +
                    "[excitations.f]\ntype = \"harmonic\"\non = \"m1\"\nat = [0, 0, 0]\nforce = [5, 0, 0]\n");
  return peaks_of(project.base().system, {of}, quantity);
}

TEST(PeaksOfOneMass, DisplacementForEveryDamping) {
  for (const double ratio : {1e-6, 1e-5, 1e-3, 0.05, 0.3, 0.6, 0.7}) {
    const response::Peaks found = single_mass(ratio, 0, assembly::MotionQuantity::displacement);
    ASSERT_EQ(found.list.size(), 1u) << ratio;
    EXPECT_THAT(found.list[0].angular_frequency,
                RelativelyNear(30 * std::sqrt(1 - 2 * ratio * ratio), frequency_digits))
        << ratio;
    EXPECT_THAT(found.list[0].amplitude,
                RelativelyNear(5 / 1800.0 / (2 * ratio * std::sqrt(1 - ratio * ratio)), amplitude_digits))
        << ratio;
    EXPECT_THAT(*found.list[0].ratio_to_static,
                RelativelyNear(1 / (2 * ratio * std::sqrt(1 - ratio * ratio)), amplitude_digits));
    EXPECT_EQ(found.list[0].nearest_mode, 1);
  }
}

TEST(PeaksOfTwoModes, BelongToTheModeThatResonatesNotToTheNearestInFrequency) {
  // 11 rad/s along z with ζ = 0.35 peaks at 11 √(1 − 2ζ²) = 9.56 rad/s, below the 10 rad/s along x, which a force along
  // z does not excite. A point slightly off the vertical shows both.
  const auto found = [](const std::string& force, const std::string& of) {
    return peaks_of(
        test::project("trivet = 1\n[bodies.b]\nmass = 1\nfree = [\"x\", \"z\"]\ninertia = {about = \"pole\", xx = 1, "
                      "yy = 1, zz = 1}\n"
                      "[elements.x]\ntype = \"bushing\"\non = \"b\"\nat = [0, 0, 0]\ntranslation = [100, 0, "
                      "0]\nrotation = [0, 0, 0]\ndamping = {translation = [0.01, 0, 0], rotation = [0, 0, 0]}\n"
                      "[elements.z]\ntype = \"bushing\"\non = \"b\"\nat = [0, 0, 0]\ntranslation = [0, 0, "
                      "121]\nrotation = [0, 0, 0]\ndamping = {translation = [0, 0, 7.7], rotation = [0, 0, 0]}\n"
                      "[excitations.f]\ntype = \"harmonic\"\non = \"b\"\nat = [0, 0, 0]\nforce = " +
                      force + "\n")
            .base()
            .system,
        {of}, assembly::MotionQuantity::displacement);
  };
  const response::Peaks z = found("[0, 0, 1]", "b.z");
  ASSERT_EQ(z.list.size(), 1u);
  EXPECT_THAT(z.list[0].angular_frequency, RelativelyNear(11 * std::sqrt(1 - 2 * 0.35 * 0.35), frequency_digits));
  EXPECT_EQ(z.list[0].nearest_mode, 2);
  const response::Peaks x = found("[1, 0, 1]", "b.x");
  ASSERT_EQ(x.list.size(), 1u);
  EXPECT_EQ(x.list[0].nearest_mode, 1);
}

TEST(PeaksOfOneMass, NoneAboveTheKnownDamping) {
  for (const double ratio : {0.708, 1.0, 2.5})
    EXPECT_TRUE(single_mass(ratio, 0, assembly::MotionQuantity::displacement).list.empty()) << ratio;
}

TEST(PeaksOfOneMass, VelocityAndAcceleration) {
  for (const double ratio : {1e-4, 0.2, 0.65}) {
    const auto velocity = single_mass(ratio, 0, assembly::MotionQuantity::velocity);
    ASSERT_EQ(velocity.list.size(), 1u);
    EXPECT_THAT(velocity.list[0].angular_frequency, RelativelyNear(30.0, frequency_digits));
    EXPECT_THAT(velocity.list[0].amplitude, RelativelyNear(5 / (2 * ratio * 60), amplitude_digits));
    EXPECT_FALSE(velocity.list[0].ratio_to_static.has_value());
    const auto acceleration = single_mass(ratio, 0, assembly::MotionQuantity::acceleration);
    ASSERT_EQ(acceleration.list.size(), 1u);
    EXPECT_THAT(acceleration.list[0].angular_frequency,
                RelativelyNear(30 / std::sqrt(1 - 2 * ratio * ratio), frequency_digits));
    EXPECT_THAT(acceleration.list[0].amplitude,
                RelativelyNear(5 / 2.0 / (2 * ratio * std::sqrt(1 - ratio * ratio)), amplitude_digits));
  }
  EXPECT_TRUE(single_mass(0.75, 0, assembly::MotionQuantity::acceleration).list.empty()) << "it only rises to F/m";
}

TEST(PeaksOfOneMass, TransmittedForce) {
  // |F_t/F|² = (1 + (2ζr)²)/((1 − r²)² + (2ζr)²) is largest at r² = (√(1 + 8ζ²) − 1)/(4ζ²), for any damping.
  for (const double ratio : {0.01, 0.5, 2.0}) {
    const auto found = single_mass(ratio, 0, assembly::MotionQuantity::displacement, "k1.force.x");
    ASSERT_EQ(found.list.size(), 1u) << ratio;
    const double r2 = (std::sqrt(1 + 8 * ratio * ratio) - 1) / (4 * ratio * ratio), c = 4 * ratio * ratio * r2;
    EXPECT_THAT(found.list[0].angular_frequency, RelativelyNear(30 * std::sqrt(r2), frequency_digits));
    EXPECT_THAT(found.list[0].amplitude,
                RelativelyNear(5 * std::sqrt((1 + c) / ((1 - r2) * (1 - r2) + c)), amplitude_digits));
  }
}

TEST(PeaksOfOneMass, LossFactor) {
  for (const double loss : {1e-6, 0.1, 1.0, 5.0}) {
    const auto found = single_mass(0, loss, assembly::MotionQuantity::displacement);
    ASSERT_EQ(found.list.size(), 1u);
    EXPECT_THAT(found.list[0].angular_frequency, RelativelyNear(30.0, frequency_digits)) << loss;
    EXPECT_THAT(found.list[0].amplitude, RelativelyNear(5 / 1800.0 / loss, amplitude_digits)) << loss;
  }
}

TEST(PeaksOfOneMass, UndampedIsUnbounded) {
  const auto found = single_mass(0, 0, assembly::MotionQuantity::displacement);
  ASSERT_EQ(found.list.size(), 1u);
  EXPECT_TRUE(std::isinf(found.list[0].amplitude));
  EXPECT_THAT(found.list[0].angular_frequency, RelativelyNear(30.0, last_digits));
}

TEST(PeaksOfOneMass, LightDampingBesideAHeavyDashpotIsNoUndampedPole) {
  // ω0 = 1 rad/s with ζ = 1e-6, and a second mass on a dashpot whose root is 1e8 times larger.
  const auto project =
      test::project(test::chain({1}, {1}, {2e-6}) +
                    "[bodies.other]\nmass = 1\nfree = [\"x\"]\n[elements.d]\ntype = \"damper\"\non = \"other\"\nat = "
                    "[0, 0, 0]\naxis = \"x\"\n" +
                    "coefficient = 1e8\n[elements.s]\ntype = \"three_springs\"\non = \"other\"\nat = [0, 0, "
                    "0]\ntranslation = [1, 0, 0]\n" +
                    "[excitations.f]\ntype = \"harmonic\"\non = \"m1\"\nat = [0, 0, 0]\nforce = [1, 0, 0]\n");
  const auto found = peaks_of(project.base().system, {"m1"}, assembly::MotionQuantity::displacement);
  ASSERT_EQ(found.list.size(), 1u);
  EXPECT_THAT(found.list[0].amplitude, RelativelyNear(5e5, over_the_damping));
  EXPECT_TRUE(found.list[0].ratio_to_static.has_value()) << "the system is held: it has a static answer";
}

TEST(PeaksOfOneMass, FreeMassHasNone) {
  const auto project = test::project(
      "trivet = 1\n[bodies.m]\nmass = 2\nfree = [\"x\"]\n[excitations.f]\ntype = \"harmonic\"\non = \"m\"\nat = [0, 0, "
      "0]\nforce = [5, 0, 0]\n");
  EXPECT_TRUE(peaks_of(project.base().system, {"coordinates"}, assembly::MotionQuantity::displacement).list.empty());
}

/// A grid that is dense around every pole and extends well beyond the last.
std::vector<double> dense_grid(const Eigen::VectorXcd& poles) {
  std::vector<double> grid;
  const double top = 4 * poles.cwiseAbs().maxCoeff();
  for (int i = 1; i <= 20000; ++i) grid.push_back(top * i / 20000.0);
  for (Eigen::Index k = 0; k < poles.size(); ++k)
    for (int i = -400; i <= 400; ++i) grid.push_back(poles(k).imag() + std::abs(poles(k).real()) * std::sinh(i / 60.0));
  std::erase_if(grid, [](double w) { return w <= 0; });
  std::ranges::sort(grid);
  return grid;
}

/// Local maxima of sampled amplitudes with a prominence above 1e-5 of the largest: frequency and amplitude.
std::vector<std::pair<double, double>> scanned_maxima(const std::vector<double>& grid, const Eigen::VectorXd& y) {
  std::vector<std::pair<double, double>> found;
  const double floor = 1e-5 * y.maxCoeff();
  for (Eigen::Index i = 1; i + 1 < y.size(); ++i)
    if (y(i) > y(i - 1) && y(i) >= y(i + 1)) {
      Eigen::Index a = i, b = i;
      double left = y(i), right = y(i);
      while (a > 0 && y(a - 1) <= y(i)) left = std::min(left, y(--a));
      while (b + 1 < y.size() && y(b + 1) <= y(i)) right = std::min(right, y(++b));
      if (y(i) - std::max(left, right) > floor) found.emplace_back(grid[i], y(i));
    }
  return found;
}

TEST(PeaksOfRandomSystems, AreThoseOfADenseScan) {
  constexpr double frequency_step = 0.02, between_points = 1e-3;  // of the scan, around flat maxima
  constexpr double round_off = 1e-9;                              // solved by poles and directly
  using enum test::RandomDamping;
  int compared = 0;
  for (unsigned seed = 1; seed <= 16; ++seed) {
    const model::System system = test::checked(
        test::RandomSystem(seed).description(1 + seed % 2, std::array{proportional, viscous, loss}[seed % 3]));
    const assembly::Assembled assembled = assembly::assemble(system);
    const modal::Modes modes = modal::modes(system, assembled);
    const modal::Roots roots = modal::roots(system, assembled, modes);
    const Eigen::VectorXcd load = assembly::harmonic_loading(system, assembled).force.at(0);
    const auto channels = assembly::channels(system, assembled, {"coordinates", "ground", "body 0.tip"},
                                             static_cast<assembly::MotionQuantity>(seed % 3));
    const response::Peaks found = response::peaks(assembled, channels, load, modes, roots, {1e-5});
    const std::vector<double> grid = dense_grid(roots.poles);
    const response::FrequencyResponse scan = response::frequency_response(assembled, channels, load, grid);
    for (std::size_t c = 0; c < channels.size(); ++c) {
      std::vector<response::Peak> mine;
      for (const auto& peak : found.list)
        if (peak.curve == c) mine.push_back(peak);
      const auto scanned = scanned_maxima(grid, scan.curves[c].value.cwiseAbs());
      ASSERT_EQ(mine.size(), scanned.size()) << "seed " << seed << " " << channels[c].name;
      for (std::size_t i = 0; i < mine.size(); ++i) {
        EXPECT_THAT(mine[i].angular_frequency, RelativelyNear(scanned[i].first, frequency_step));
        EXPECT_GE(mine[i].amplitude, scanned[i].second * (1 - round_off)) << "no scanned point is above the exact peak";
        EXPECT_THAT(mine[i].amplitude, RelativelyNear(scanned[i].second, between_points));
        EXPECT_TRUE(mine[i].refined);
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 300);
}

}  // namespace peaks_test
