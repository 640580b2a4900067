// SPDX-License-Identifier: BSD-3-Clause
// One mass on a spring: boundaries of maps in closed form. With ζ = δω₀/2 the amplitude is largest at ω₀√(1 − 2ζ²) if
// ζ < 1/√2: F/(k·2ζ√(1 − ζ²)). Otherwise it is F/k at rest, and there is no peak. [Den Hartog, Mechanical Vibrations,
// section 2.9]
#include <gmock/gmock.h>

#include <cmath>

#include "support/projects.h"
#include "trivet/study/map/design_map.h"

namespace design_map_test {

using namespace trivet;

constexpr double mass = 4, stiffness = 900, force = 18;

std::string one_mass(const std::string& rules) {
  return R"(
trivet = 1
[bodies.mass]
mass = 4
free = ["z"]
[elements.spring]
type = "bushing"
on = "mass"
at = [0, 0, 0]
translation = [900, 900, 900]
damping = {proportional = 0.01}
[excitations.force]
type = "harmonic"
on = "mass"
at = [0, 0, 0]
force = [0, 0, 18]
[analyses.map]
x = {parameter = "elements.spring.scale", from = 0.25, to = 8, spacing = "logarithmic", points = 31}
y = {parameter = "elements.spring.damping.proportional", from = "5 ms", to = "400 ms", points = 41}
)" + rules;
}

struct OneMass {
  double k, zeta;
  OneMass(double scale, double milliseconds)
      : k(scale * stiffness), zeta(0.5 * milliseconds * 1e-3 * std::sqrt(scale * stiffness / mass)) {}
  [[nodiscard]] double rise() const { return zeta < std::sqrt(0.5) ? 1 / (2 * zeta * std::sqrt(1 - zeta * zeta)) : 1; }
  [[nodiscard]] double amplitude() const { return force / k * rise(); }
};

study::DesignMap map_of(const std::string& rules) {
  const project::Project project = test::project(one_mass(rules));
  return study::design_map(project, project.base(), *project.base().analyses.map);
}

/// The boundary is accurate to 1e-6 of each axis. The damping axis of 395 ms begins at 5 ms: its millionth is 8e-5
/// there.
constexpr double boundary_error = 1.5e-4;
constexpr double of_a_float = 2e-7;  // margins are kept in single precision

TEST(DesignMap, HasTheBoundaryOfTheAmplitudeOfOneMassInClosedForm) {
  const study::DesignMap map = map_of("limits = {\"mass.z\" = \"20 mm\"}\n");
  ASSERT_FALSE(map.feasible.lines.empty());
  std::size_t points = 0, resonant = 0;
  for (const design::MapLine& line : map.feasible.lines)
    for (const design::MapPlace& p : line) {
      const OneMass design(map.request.x.at(p.x), map.request.y.at(p.y));
      EXPECT_NEAR(design.amplitude(), 0.02, boundary_error * 0.02) << p.x << " " << p.y;
      ++points;
      resonant += design.zeta < 0.7;
    }
  EXPECT_GT(points, 20u);
  EXPECT_GT(resonant, 5u);
}

TEST(DesignMap, HasTheBoundaryOfThePeakOfOneMassInClosedForm) {
  const study::DesignMap map = map_of("no_peak = \"mass.z\"\npeak_tolerance = 0.05\n");
  ASSERT_FALSE(map.feasible.lines.empty());
  for (const design::MapLine& line : map.feasible.lines)
    for (const design::MapPlace& p : line)
      EXPECT_NEAR(OneMass(map.request.x.at(p.x), map.request.y.at(p.y)).rise(), 1.05, boundary_error)
          << p.x << " " << p.y;
}

TEST(DesignMap, WithoutToleranceRequiresADampingRatioOfHalfTheRootOfTwo) {
  const study::DesignMap map = map_of("no_peak = \"mass.z\"\npeak_tolerance = 0\n");
  ASSERT_FALSE(map.feasible.lines.empty());
  constexpr double flat = 1e-3;  // rises below 1e-6 of the curve are not peaks; the rise is (1 − 2ζ²)²/2 of it
  for (const design::MapLine& line : map.feasible.lines)
    for (const design::MapPlace& p : line)
      EXPECT_NEAR(OneMass(map.request.x.at(p.x), map.request.y.at(p.y)).zeta, std::sqrt(0.5), flat);
}

TEST(DesignMap, HasTheMarginsOfOneMassInClosedForm) {
  const study::DesignMap map = map_of("limits = {\"mass.z\" = \"20 mm\"}\n");
  for (std::size_t k = 0; k < map.outcomes.size(); ++k) {
    const design::DesignPoint p = map.point(k);
    EXPECT_NEAR(map.outcomes[k].margin, 0.02 / OneMass(p.x, p.y).amplitude(), of_a_float * map.outcomes[k].margin);
  }
}

}  // namespace design_map_test
