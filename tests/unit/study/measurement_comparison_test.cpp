// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/analyses/measurement_comparison.h"

#include <gmock/gmock.h>

#include <chrono>
#include <complex>
#include <memory>
#include <utility>

#include "support/projects.h"
#include "trivet/study/analyses/case_context.h"

namespace measurement_comparison_test {

using namespace trivet;

/// Receptance of a single mass with a loss factor, at equal steps.
struct Resonance {
  std::vector<double> angular_frequency;
  Eigen::VectorXcd value;
};

Resonance resonance(double natural, double loss, double step) {
  Resonance result;
  for (double omega = 0.5 * natural; omega < 1.5 * natural; omega += step) result.angular_frequency.push_back(omega);
  result.value.resize(static_cast<Eigen::Index>(result.angular_frequency.size()));
  for (Eigen::Index i = 0; i < result.value.size(); ++i) {
    const double omega = result.angular_frequency[static_cast<std::size_t>(i)];
    result.value(i) = 1.0 / std::complex<double>(natural * natural - omega * omega, loss * natural * natural);
  }
  return result;
}

TEST(Assurance, IsOneForCurvesThatDifferByAFactor) {
  const Eigen::VectorXcd curve = resonance(10, 0.1, 0.1).value;
  constexpr double round_off = 1e-14;
  EXPECT_NEAR(study::assurance(std::complex<double>(-2, 3) * curve, curve), 1, round_off);
}

TEST(Assurance, IsZeroForOrthogonalShapes) {
  Eigen::VectorXcd one(2), other(2);
  one << 1, std::complex<double>(0, 1);
  other << 1, std::complex<double>(0, -1);
  EXPECT_EQ(study::assurance(one, other), 0);
}

TEST(Assurance, DoesNotExistForACurveThatIsZero) {
  EXPECT_TRUE(std::isnan(study::assurance(Eigen::VectorXcd::Zero(3), Eigen::VectorXcd::Ones(3))));
}

TEST(MeasuredPeaks, LieBetweenTheLines) {
  constexpr double natural = 10, loss = 0.05;
  for (const double step : {0.1, 0.037, 0.05}) {
    const Resonance curve = resonance(natural, loss, step);
    const auto peaks = study::measured_peaks(curve.angular_frequency, curve.value);
    ASSERT_EQ(peaks.size(), 1);
    // The parabola neglects the third power of ω − ω₀: an error of second order in step/ω₀.
    EXPECT_NEAR(peaks[0].angular_frequency, natural, step * step / natural);
    EXPECT_NEAR(peaks[0].amplitude * loss * natural * natural, 1, 0.02);
    EXPECT_NEAR(peaks[0].resolution, step, 1e-9);
  }
}

TEST(MeasuredPeaks, NeedARiseOfAFifth) {
  Eigen::VectorXcd values(7);
  values << 1, 1.15, 1, 0.9, 1.3, 0.95, 1;
  const auto peaks = study::measured_peaks({1, 2, 3, 4, 5, 6, 7}, values);
  ASSERT_EQ(peaks.size(), 1);
  EXPECT_NEAR(peaks[0].angular_frequency, 5, 0.5);
}

TEST(MeasuredPeaks, OfALongRisingNoiseNeedNoLongTime) {
  // Each of 100 000 maxima is higher than all before it; to visit all of them again takes a minute.
  constexpr int count = 200'000;
  std::vector<double> omega;
  Eigen::VectorXcd values(count);
  for (int i = 0; i < count; ++i) {
    omega.push_back(1 + i);
    values(i) = (1 + 10.0 * i / count) * (i % 2 == 0 ? 1 : 0.5);
  }
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(study::measured_peaks(omega, values).size(), count / 2 - 1);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

TEST(MeasuredPeaks, NeedCoherence) {
  const Resonance curve = resonance(10, 0.05, 0.1);
  const Eigen::VectorXd poor = Eigen::VectorXd::Constant(curve.value.size(), 0.3);
  EXPECT_TRUE(study::measured_peaks(curve.angular_frequency, curve.value, poor).empty());
}

/// Heave and pitch of a plate, measured at one place or more along z.
study::ShapeComparison compared(double measured_frequency, const std::vector<double>& places,
                                const Eigen::VectorXcd& shape) {
  const project::Project plate = test::project(R"(
trivet = 1
[bodies.plate]
mass = 10
inertia = {about = "center_of_mass", xx = 1, yy = 1, zz = 1}
free = ["z", "ry"]
[elements.k]
type = "bushing"
on = "plate"
at = [0, 0, 0]
translation = [0, 0, 9000]
rotation = [0, 8100, 0]
[excitations.f]
type = "harmonic"
on = "plate"
at = [0, 0, 0]
force = [0, 0, 1]
[analyses.response]
of = ["plate"]
band = ["1 Hz", "20 Hz"]
)");
  project::Measurement measurement;
  for (const double x : places) measurement.components.push_back({0, {x, 0, 0}, 2});
  measurement.modes.push_back({1, measured_frequency, 0.01, shape});
  project::Analyses analyses = plate.base().analyses;
  analyses.measurements = {std::make_shared<const project::Measurement>(measurement)};
  const foundation::Progress silent;
  const study::CaseContext context(plate.base().system, silent);
  return study::measurement_comparisons(context, analyses, *analyses.response->band).at(0).shapes.at(0);
}

TEST(MeasuredModes, AreThoseOfTheNearestFrequencyWhereShapesAreAlike) {
  constexpr double heave = 30, pitch = 90, round_off = 1e-12;   // √(k/m) [rad/s]
  const Eigen::VectorXcd anything = Eigen::VectorXcd::Ones(1);  // one component is like every mode that it sees
  for (const auto& [measured, mode] : {std::pair{28.0, 1}, {33.0, 1}, {80.0, 2}, {95.0, 2}, {53.0, 2}, {51.0, 1}}) {
    const auto found = compared(measured, {0.5}, anything);
    EXPECT_EQ(found.mode, mode) << measured << ": √(30 · 90) = 51.96 is as far from both";
    EXPECT_NEAR(found.assurance, 1, round_off);
    EXPECT_NEAR(*found.angular_frequency, mode == 1 ? heave : pitch, round_off * pitch);
  }
  // Nearly alike: places far to one side of the axis; the shape is that of heave with 1 % of noise.
  Eigen::VectorXcd nearly(2);
  nearly << 1.0, 1.01;
  EXPECT_EQ(compared(88, {9.9, 10.1}, nearly).mode, 2);
  EXPECT_EQ(compared(31, {9.9, 10.1}, nearly).mode, 1);
  // Shapes that tell modes apart decide, whatever the frequency.
  Eigen::VectorXcd turning(2);
  turning << 1.0, -1.0;
  EXPECT_EQ(compared(29, {0.5, -0.5}, turning).mode, 2);
  EXPECT_EQ(compared(29, {0}, anything).mode, 1) << "pitch does not move this place";
  EXPECT_EQ(compared(91, {0}, anything).mode, 1);
}

}  // namespace measurement_comparison_test
