// SPDX-License-Identifier: BSD-3-Clause
// Motions of the ground through the off-diagonal blocks, compared with other methods.
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "support/matchers.h"
#include "support/projects.h"
#include "support/random_system.h"
#include "trivet/assembly/loads.h"
#include "trivet/foundation/index.h"
#include "trivet/modal/roots.h"
#include "trivet/numerics/sweep/frequency_sweep.h"
#include "trivet/response/steady/deep_check.h"
#include "trivet/response/steady/frequency_response.h"
#include "trivet/response/steady/peaks.h"
#include "trivet/spatial/rigid_motion.h"

namespace base_motion_test {

using namespace trivet;
using test::RandomDamping;
using Complex = std::complex<double>;

constexpr double round_off = 1e-9;  // up to 18 coordinates with condition up to 1e5, near resonances
const std::vector<double> frequencies = {0.5, 7, 33, 90, 210, 500};

model::Excitation base(test::RandomSystem& draw, int derivative = 0) {
  model::Excitation excitation{"base", {}, model::Harmonic{}};
  excitation.action.at = draw.vector(0.5);
  excitation.action.derivative = derivative;
  for (int j = 0; j < 6; ++j) excitation.action.amplitude(j) = std::polar(draw.number(1e-4, 1e-3), draw.number(-3, 3));
  return excitation;
}

/// Largest difference over all coordinates and frequencies, relative to the largest value.
double difference(const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

Eigen::MatrixXcd coordinates(const model::System& system) {
  const assembly::Assembled assembled = assembly::assemble(system);
  return numerics::sweep(assembled.matrices,
                         assembly::right_side(assembled, assembly::harmonic_loading(system, assembled)), frequencies)
      .response;
}

/// Motion of the bodies rigidly attached to the ground: their six coordinates, one below the other, per unit of g about
/// the ground origin.
Eigen::MatrixXd followed(const model::System& system) {
  Eigen::MatrixXd r(6 * to_index(system.bodies().size()), 6);
  for (std::size_t b = 0; b < system.bodies().size(); ++b) {
    const spatial::Pose& pose = system.bodies()[b].pose;
    r.middleRows<6>(6 * to_index(b)) =
        spatial::both_blocks(pose.rotation).transpose() * spatial::rigid_motion(pose.position);
  }
  return r;
}

TEST(BaseMotion, IsThatOfRelativeCoordinatesUnderInertialForces) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    test::RandomSystem draw(seed);
    model::Description d = draw.description(1 + seed % 3, static_cast<RandomDamping>(seed % 4));
    d.excitations = {base(draw)};
    const model::System system = test::checked(d);
    const assembly::Assembled assembled = assembly::assemble(system);
    const Eigen::MatrixXd r = followed(system);
    const Eigen::VectorXcd g = assembly::harmonic_loading(system, assembled).motion.at(1).head<6>();
    // A z̈ + B ż + K z = −A R g̈ with q = z + R g.
    const numerics::Load inertial = [&] {
      numerics::Load load(assembled.matrices.size());
      load.add({2, 0, -(assembled.matrices.A * r).cast<Complex>() * g});
      return load;
    }();
    const Eigen::MatrixXcd relative = numerics::sweep(assembled.matrices, inertial, frequencies).response;
    const Eigen::MatrixXcd absolute = relative.colwise() + r.cast<Complex>() * g;
    EXPECT_LT(difference(coordinates(system), absolute), round_off) << "seed " << seed;
  }
}

TEST(BaseMotion, RelativeChannelsAreAbsoluteOnesLessTheGround) {
  test::RandomSystem draw(3);
  model::Description d = draw.description(2, RandomDamping::viscous);
  d.excitations = {base(draw)};
  const model::System system = test::checked(d);
  const assembly::Assembled assembled = assembly::assemble(system);
  const assembly::Loading loading = assembly::harmonic_loading(system, assembled);
  const auto curves = response::frequency_response(assembled,
                                                   assembly::channels(system, assembled, {"body 1", "body 1.relative"},
                                                                      assembly::MotionQuantity::displacement),
                                                   loading, frequencies)
                          .curves;
  const Eigen::VectorXcd g = loading.motion.at(1).head<6>();
  const Eigen::VectorXcd carried = followed(system).bottomRows<6>().cast<Complex>() * g;
  for (Eigen::Index j = 0; j < 6; ++j)
    for (Eigen::Index i = 0; i < curves[0].value.size(); ++i)
      EXPECT_NEAR(std::abs(curves[j].value(i) - carried(j) - curves[6 + j].value(i)), 0,
                  round_off * std::abs(carried(j)));
}

TEST(BaseMotion, ByAccelerationIsThatByDisplacement) {
  test::RandomSystem draw(5);
  model::Description d = draw.description(2, RandomDamping::proportional);
  d.excitations = {base(draw)};
  const Eigen::MatrixXcd by_displacement = coordinates(test::checked(d));
  for (const int derivative : {1, 2}) {
    model::Description other = d;
    other.excitations[0].action.derivative = derivative;
    const Eigen::MatrixXcd given = coordinates(test::checked(other));
    for (Eigen::Index i = 0; i < given.cols(); ++i) {
      const Complex factor = std::pow(Complex(0, frequencies[i]), derivative);
      EXPECT_LT(difference(given.col(i) * factor, by_displacement.col(i)), round_off);
    }
  }
}

/// Two ends on the ground, 3 m apart along x, under one body.
std::string two_legs(const std::string& excitations) {
  return R"(trivet = 1
[bodies.frame]
mass = 10
inertia = {about = "center_of_mass", xx = 3, yy = 8, zz = 9}
[elements.front]
type = "bushing"
on = "frame"
at = [1.5, 0, 0]
translation = [3000, 2000, 9000]
rotation = [50, 60, 70]
damping = {proportional = 0.004}
[elements.rear]
type = "bushing"
on = "frame"
at = [-1.5, 0, 0]
translation = [2000, 4000, 7000]
rotation = [50, 60, 70]
damping = {loss_factor = 0.1}
)" + excitations;
}

std::complex<double> at_40(const std::string& excitations, const std::string& name) {
  const project::Project project =
      test::project(two_legs(excitations) + "[analyses]\nresponse = {at = [40], of = [\"frame\"]}\n");
  const study::CaseResults results = study::case_results(project.base(), project.base().analyses);
  return test::value(*results.response, name, 0);
}

constexpr double digits_of_the_speed = 1e-6;  // std::to_string writes six decimals

TEST(TravellingGround, OneWavelengthBetweenTheLegsLiftsThemTogether) {
  // Delay of the front leg against the rear: 3 m / c = one period 2π/40 s; `turned` removes the phase at x = 1.5 m.
  const double speed = 3 * 40 / (2 * std::numbers::pi);
  const std::string wave =
      "[excitations.wave]\ntype = \"base\"\ntranslation = [0, 0, 0.001]\nwave = {direction = \"x\", speed = " +
      std::to_string(speed) + "}\n";
  const std::string together =
      "[excitations.both]\ntype = \"base\"\ntranslation = [0, 0, 0.001]\nelements = [\"front\", \"rear\"]\n";
  for (const char* name : {"frame.z", "frame.ry"}) {
    const Complex turned = at_40(wave, name) * std::polar(1.0, 40 * 1.5 / speed);
    EXPECT_NEAR(std::abs(turned - at_40(together, name)), 0, digits_of_the_speed * std::abs(at_40(together, "frame.z")))
        << name;
  }
}

TEST(TravellingGround, HalfAWavelengthLiftsThemAgainstEachOther) {
  const double speed = 3 * 40 / std::numbers::pi;
  const std::string wave =
      "[excitations.wave]\ntype = \"base\"\ntranslation = [0, 0, 0.001]\nwave = {direction = \"x\", speed = " +
      std::to_string(speed) + "}\n";
  const std::string against =
      "[excitations.front]\ntype = \"base\"\ntranslation = [0, 0, 0.001]\nelements = [\"front\"]\nphase = \"-90 deg\"\n"
      "[excitations.rear]\ntype = \"base\"\ntranslation = [0, 0, 0.001]\nelements = [\"rear\"]\nphase = \"90 deg\"\n";
  for (const char* name : {"frame.z", "frame.ry"})
    EXPECT_NEAR(std::abs(at_40(wave, name) - at_40(against, name)), 0,
                digits_of_the_speed * std::abs(at_40(against, "frame.z")))
        << name;
}

TEST(BaseMotion, PassesTheSecondSolver) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    test::RandomSystem draw(seed);
    model::Description d = draw.description(1 + seed % 2, static_cast<RandomDamping>(seed % 4));
    d.excitations.push_back(base(draw, static_cast<int>(seed % 3)));
    d.excitations.push_back(base(draw));
    d.excitations.back().name = "wave";
    d.excitations.back().action.wave = model::Wave{Eigen::Vector3d::UnitX(), 20};
    if (seed % 2 == 0) d.damping = model::RayleighDamping{0.3, 1e-4};
    const model::System system = test::checked(d);
    const assembly::Assembled assembled = assembly::assemble(system);
    const auto check =
        response::deep_check(system, assembled, assembly::harmonic_loading(system, assembled), frequencies);
    EXPECT_TRUE(check.passed) << "seed " << seed << ": " << check.worst_difference << " > " << check.allowed;
    EXPECT_EQ(check.frequencies, static_cast<int>(frequencies.size()));
  }
}

/// Compares each peak with the highest point of a fine scan around it; every scanned local maximum must be a peak.
void expect_peaks_of_a_scan(const model::System& system, double to) {
  const assembly::Assembled assembled = assembly::assemble(system);
  const modal::Modes modes = modal::modes(system, assembled);
  const modal::Roots roots = modal::roots(system, assembled, modes);
  const assembly::Loading loading = assembly::harmonic_loading(system, assembled);
  std::vector<std::string> of = {"coordinates"};
  for (const model::Element& element : system.elements()) of.push_back(element.name);
  const auto channels = assembly::channels(system, assembled, of, assembly::MotionQuantity::velocity);
  const response::Peaks peaks =
      response::peaks(assembled, channels, loading, modes, roots, {1e-12, to});  // shallow ones too
  std::vector<double> scan;
  constexpr int points = 8000;
  for (int i = 1; i <= points; ++i) scan.push_back(to * i / points);
  const auto curves = response::frequency_response(assembled, channels, loading, scan).curves;
  int found = 0;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const Eigen::VectorXd y = curves[c].value.cwiseAbs();
    for (Eigen::Index i = 1; i + 1 < y.size(); ++i) {
      if (!(y(i) > y(i - 1) * (1 + round_off) && y(i) > y(i + 1) * (1 + round_off))) continue;
      const double w = scan[i];
      bool there = false;
      for (const response::Peak& peak : peaks.list)
        if (peak.curve == c && std::abs(peak.angular_frequency - w) <= to / points &&
            peak.amplitude >= y(i) * (1 - round_off))
          there = true;
      std::string near;
      for (const response::Peak& peak : peaks.list)
        if (peak.curve == c && std::abs(peak.angular_frequency - w) < 0.02 * to)
          near += std::to_string(peak.angular_frequency) + " ";
      EXPECT_TRUE(there) << curves[c].name << " at " << w << ", " << y(i) << " of " << y.maxCoeff() << ", rises "
                         << y(i) - y(i - 1) << " " << y(i) - y(i + 1) << ", peaks near: " << near;
      ++found;
    }
  }
  EXPECT_GT(found, 3);
}

TEST(PeaksOfMovingGround, AreThoseOfAFineScan) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    test::RandomSystem draw(seed);
    model::Description d = draw.description(2, static_cast<RandomDamping>(1 + seed % 3));
    d.excitations = {base(draw, static_cast<int>(seed % 3))};
    if (seed % 2 == 0) d.excitations[0].action.wave = model::Wave{Eigen::Vector3d::UnitY(), 3};
    const model::System system = test::checked(d);
    expect_peaks_of_a_scan(system, 400);
  }
}

TEST(PeaksOfUnbalance, AreThoseOfAFineScan) {
  test::RandomSystem draw(9);
  model::Description d = draw.description(2, RandomDamping::viscous);
  d.excitations[0].course = model::Harmonic{2};
  expect_peaks_of_a_scan(test::checked(d), 400);
}

}  // namespace base_motion_test
