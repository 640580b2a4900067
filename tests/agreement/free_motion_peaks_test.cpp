// SPDX-License-Identifier: BSD-3-Clause
// Peaks of machines with a rigid-body mode, against the same machines with a very soft spring in that direction.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/projects.h"
#include "trivet/assembly/loads.h"
#include "trivet/modal/roots.h"
#include "trivet/response/steady/peaks.h"

namespace free_motion_peaks_test {

using namespace trivet;

constexpr double visible = 1e-6;      // of its height: prominence of a peak that counts
constexpr double round_off = 1e-9;    // poles, residues and heights of three coordinates
constexpr double soft_spring = 1e-7;  // 1e-5 N/m over 3000 N/m is 3e-9
/// Of a machine with a rigid-body mode: at most a hundredth of the lowest |λ|, see docs/theory.md.
constexpr double start_of_the_search = 1e-4;

response::Peaks peaks_of(const std::string& text) {
  const project::Project project = test::project(text);
  const model::System& system = project.base().system;
  const assembly::Assembled assembled = assembly::assemble(system);
  const modal::Modes modes = modal::modes(system, assembled);
  response::PeakOptions options;
  options.min_prominence = 1e-12;  // of the highest, which is at rest if the machine is nearly free
  response::Peaks peaks = response::peaks(
      assembled, assembly::channels(system, assembled, {"coordinates"}, assembly::MotionQuantity::displacement),
      assembly::harmonic_loading(system, assembled), modes, modal::roots(system, assembled, modes), options);
  std::erase_if(peaks.list, [](const response::Peak& peak) { return peak.prominence < visible * peak.amplitude; });
  return peaks;
}

/// Held softly along y, stiffly along z, by `along_x` [N/m] along x, all of it turned about the diagonal if `skew`.
std::string sled(double along_x, double stiff, double damping, bool skew) {
  return fmt::format(R"(trivet = 1
[bodies.b]
mass = 6
center_of_mass = [0, 0, 0]
inertia = {{about = "center_of_mass", xx = 2.5, yy = 3, zz = 3.5}}
free = ["x", "y", "z"]
[elements.e]
type = "bushing"
on = "b"
at = [0, 0, 0]
{}
translation = [{}, 3000, {}]
damping = {{translation = [{}, {}, {}]}}
[excitations.f]
type = "harmonic"
on = "b"
at = [0, 0, 0]
force = [0, 1, 1]
)",
                     skew ? "orientation = {axis = [3, 4, -5], angle = 0.7}" : "", along_x, stiff,
                     skew ? 0.1 * damping : 0.0, damping, 20 * damping);
}

void expect_same_peaks(const response::Peaks& found, const response::Peaks& expected, double tolerance,
                       const std::string& what) {
  ASSERT_EQ(found.list.size(), expected.list.size()) << what;
  for (std::size_t k = 0; k < found.list.size(); ++k) {
    const response::Peak &a = found.list[k], &b = expected.list[k];
    EXPECT_EQ(a.curve, b.curve) << what;
    EXPECT_NEAR(a.angular_frequency, b.angular_frequency, tolerance * b.angular_frequency) << what;
    EXPECT_NEAR(a.amplitude, b.amplitude, tolerance * b.amplitude) << what;
  }
}

/// Decoupled directions: the spring in the third direction changes nothing.
TEST(PeaksWithARigidBodyMode, AreThoseOfTheSameMachineHeldThere) {
  for (const double stiff : {3e3, 3e5, 3e6, 3e9}) {
    const response::Peaks found = peaks_of(sled(0, stiff, 1, false));
    EXPECT_EQ(found.list.size(), 2U);
    expect_same_peaks(found, peaks_of(sled(1e-3, stiff, 1, false)), round_off, fmt::format("{} N/m", stiff));
    for (std::size_t c = 1; c < 3; ++c)
      EXPECT_NEAR(found.curves[c].highest, peaks_of(sled(1e-3, stiff, 1, false)).curves[c].highest, round_off) << stiff;
  }
}

/// Heavily damped directions have no peaks, and the highest value is at rest: F/k.
TEST(PeaksWithARigidBodyMode, HeightsAtRestAreThoseOfTheSprings) {
  const response::Peaks found = peaks_of(sled(0, 3e4, 3e4, false));
  EXPECT_TRUE(found.list.empty());
  EXPECT_NEAR(found.curves[1].highest, 1 / 3e3, start_of_the_search / 3e3);
  EXPECT_NEAR(found.curves[2].highest, 1 / 3e4, start_of_the_search / 3e4);
}

/// In turned axes the rigid-body mode moves all coordinates, which rise towards rest. A spring of 1e-5 N/m along that
/// direction, which is damped, adds no resonance.
TEST(PeaksWithARigidBodyMode, CoupledOnesAreThoseOfTheSameMachineHeldThere) {
  for (const double stiff : {3e4, 3e5, 3e6}) {
    const response::Peaks found = peaks_of(sled(0, stiff, 1, true));
    EXPECT_GE(found.list.size(), 6U) << stiff;
    expect_same_peaks(found, peaks_of(sled(1e-5, stiff, 1, true)), soft_spring, fmt::format("{} N/m", stiff));
  }
}

}  // namespace free_motion_peaks_test
