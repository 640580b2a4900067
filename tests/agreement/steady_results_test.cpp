// SPDX-License-Identifier: BSD-3-Clause
// Power, transmissibility, orders and deflection shapes of random systems, each by two methods.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/matchers.h"
#include "support/random_system.h"
#include "trivet/elements/viscoelastic.h"
#include "trivet/foundation/index.h"
#include "trivet/response/machinery/deflection_shape.h"
#include "trivet/response/machinery/limit_line.h"
#include "trivet/response/machinery/power.h"
#include "trivet/response/machinery/run_up.h"
#include "trivet/response/machinery/transmissibility.h"
#include "trivet/spatial/rigid_motion.h"

namespace steady_results_test {

using namespace trivet;
using test::RandomDamping;
using test::RandomSystem;
using test::RelativelyNear;
using Complex = std::complex<double>;
constexpr double round_off = 1e-9;  // ε times the condition of small random systems
const std::vector<double> frequencies = {3, 17, 40, 90, 250};

/// The ground moves as a whole, and one foot in addition, with phases and a delay.
void shake_the_ground(RandomSystem& random, model::Description& d) {
  model::Action base;
  base.at = random.vector(0.5);
  for (int j = 0; j < 6; ++j) base.amplitude(j) = 1e-3 * random.number(0.2, 1) * std::polar(1.0, random.number(-3, 3));
  d.excitations.push_back({"shaken ground", base, model::Harmonic{}});
  model::Action foot = base;
  foot.elements = {0};
  foot.delay = 0.01;
  foot.derivative = 2;
  d.excitations.push_back({"shaken foot", foot, model::Harmonic{}});
}

/// A flexible foundation under the second element: six coordinates with mass, damping and stiffness.
void stand_on_foundation(RandomSystem& random, model::Description& d) {
  model::Foundation deck;
  deck.name = "deck";
  deck.mass = 1e-4 * random.stiffness(1e5, 0.3);
  deck.damping = 1e-3 * random.stiffness(1e5, 0.3);
  deck.stiffness = random.stiffness(2e5, 0.3);
  model::OnFoundation on{0, Eigen::Matrix<double, 6, Eigen::Dynamic>::Identity(6, 6)};
  d.elements[1].n.foundation = on;
  d.foundations = {deck};
  for (model::Excitation& excitation :
       d.excitations)  // a rigid motion of the whole ground would need to define the motion of the deck
    if (!excitation.action.body && excitation.action.elements.empty()) excitation.action.elements = {0};
}

enum class Damping {
  none,
  proportional,
  viscous,
  loss,
  loss_beside_law,
  rayleigh,
  modal,
  zener,
  fractional,
  foundation
};

model::Description random_description(unsigned seed, Damping damping) {
  RandomSystem random(seed);
  const RandomDamping of_elements = damping == Damping::none            ? RandomDamping::none
      : damping == Damping::viscous || damping == Damping::foundation   ? RandomDamping::viscous
      : damping == Damping::loss || damping == Damping::loss_beside_law ? RandomDamping::loss
                                                                        : RandomDamping::proportional;
  model::Description d = random.description(2, of_elements);
  if (damping == Damping::loss_beside_law)
    d.elements[0].law.nonlinear = elements::Linearization{.tangent = 0.5 * d.elements[0].law.nominal_stiffness};
  if (damping == Damping::rayleigh) d.damping = model::RayleighDamping{0.7, 2e-4};
  if (damping == Damping::modal) d.damping = model::ModalDamping{{0.03}};
  if (damping == Damping::zener) d.elements[0].law.damping = elements::Viscoelastic{elements::Zener{2, 0.01}};
  if (damping == Damping::fractional)
    d.elements[0].law.damping = elements::Viscoelastic{elements::FractionalZener{2, 0.01, 0.4}};
  shake_the_ground(random, d);
  if (damping == Damping::foundation) stand_on_foundation(random, d);
  return d;
}

const Damping all_kinds[] = {
    Damping::none,     Damping::proportional, Damping::viscous, Damping::loss,       Damping::loss_beside_law,
    Damping::rayleigh, Damping::modal,        Damping::zener,   Damping::fractional, Damping::foundation};

TEST(PowerBalance, PowerOfForcesAndGroundIsDissipated) {
  for (const Damping damping : all_kinds)
    for (unsigned seed = 1; seed <= 3; ++seed) {
      const model::System system = test::checked(random_description(seed, damping));
      const assembly::Assembled assembled = assembly::assemble(system);
      const response::PowerFlow flow =
          response::power_flow(system, assembled, assembly::harmonic_loading(system, assembled), frequencies);
      for (Eigen::Index i = 0; i < to_index(frequencies.size()); ++i) {
        const double in = flow.by_forces(i) + flow.by_ground(i);
        const double out =
            flow.dissipated.col(i).sum() + flow.dissipated_by_foundations(i) + flow.dissipated_by_system(i);
        const double scale =
            std::abs(flow.by_forces(i)) + std::abs(flow.by_ground(i)) + flow.dissipated.col(i).cwiseAbs().sum();
        EXPECT_NEAR(in, out, round_off * scale) << static_cast<int>(damping) << " " << seed << " " << frequencies[i];
        EXPECT_GE(flow.dissipated.col(i).minCoeff(), -round_off * scale);
        EXPECT_EQ(out > round_off * scale, damping != Damping::none);
        EXPECT_EQ(flow.dissipated_by_foundations(i) > 0, damping == Damping::foundation);
        EXPECT_EQ(flow.dissipated_by_system(i) != 0, damping == Damping::rayleigh || damping == Damping::modal);
      }
    }
}

TEST(PowerIntoTheGround, IsHalfTheRealPartOfForceTimesConjugateVelocity) {
  for (const Damping damping : all_kinds) {
    const model::System system = test::checked(random_description(5, damping));
    const assembly::Assembled assembled = assembly::assemble(system);
    const assembly::Loading loading = assembly::harmonic_loading(system, assembled);
    const response::PowerFlow flow = response::power_flow(system, assembled, loading, frequencies);
    ASSERT_EQ(flow.mounts.size(), 2u);
    for (std::size_t m = 0; m < flow.mounts.size(); ++m) {
      const auto forces =
          assembly::channels(system, assembled, {flow.mounts[m]}, assembly::MotionQuantity::displacement);
      const auto velocities =
          assembly::channels(system, assembled, {flow.mounts[m] + ".foot"}, assembly::MotionQuantity::velocity);
      const auto force = response::frequency_response(assembled, forces, loading, frequencies);
      const auto velocity = response::frequency_response(assembled, velocities, loading, frequencies);
      for (Eigen::Index i = 0; i < flow.into_ground.cols(); ++i) {
        double power = 0, size = 0;
        for (std::size_t j = 0; j < 6; ++j) {
          const Complex product = 0.5 * force.curves[j].value(i) * std::conj(velocity.curves[j].value(i));
          power += product.real();
          size += std::abs(product);
        }
        EXPECT_NEAR(flow.into_ground(to_index(m), i), power, round_off * size) << static_cast<int>(damping);
      }
    }
    EXPECT_THAT(flow.into_ground_in_total(0),
                RelativelyNear(flow.into_ground(0, 0) + flow.into_ground(1, 0), round_off));
  }
}

TEST(PowerIntoTheGround, IsZeroWhileItRests) {
  model::Description d = random_description(2, Damping::viscous);
  d.excitations.resize(1);
  const model::System system = test::checked(d);
  const assembly::Assembled assembled = assembly::assemble(system);
  const response::PowerFlow flow =
      response::power_flow(system, assembled, assembly::harmonic_loading(system, assembled), frequencies);
  EXPECT_TRUE(flow.into_ground.isZero(0));
  EXPECT_TRUE(flow.by_ground.isZero(0));
  EXPECT_GT(flow.by_forces.minCoeff(), 0);
}

TEST(Transmissibility, ForceAndDisplacementAgree) {
  // Reciprocity: the force on the ground by a unit force at a point equals the motion of the point by a unit motion of
  // the ground, in any two directions.
  for (const Damping damping :
       {Damping::none, Damping::proportional, Damping::viscous, Damping::loss, Damping::zener, Damping::fractional}) {
    RandomSystem random(11);
    const model::System system = test::checked(random_description(4, damping));
    const assembly::Assembled assembled = assembly::assemble(system);
    for (const bool rotation : {false, true}) {
      const model::Direction here{random.vector(2), rotation}, there{random.vector(2), rotation};
      const auto force =
          response::force_transmission(system, assembled, {1, system.bodies()[1].points[0].at, here}, there);
      const auto motion = response::displacement_transmission(system, assembled, {"body 1.tip"}, there, here);
      const auto felt = response::frequency_response(assembled, force.channels, force.loading, frequencies);
      const auto followed = response::frequency_response(assembled, motion.channels, motion.loading, frequencies);
      for (Eigen::Index i = 0; i < to_index(frequencies.size()); ++i)
        EXPECT_NEAR(std::abs(felt.curves[0].value(i) - followed.curves[0].value(i)), 0,
                    round_off * (1 + std::abs(felt.curves[0].value(i))));
      constexpr double near_rest = 1e-6;  // (ω/ω₁)²
      const auto slowly = response::frequency_response(assembled, force.channels, force.loading, {1e-3});
      EXPECT_NEAR(std::abs(slowly.curves[0].value(0) - here.axis.normalized().dot(there.axis.normalized())), 0,
                  near_rest)
          << "at rest the ground answers the load";
      if (rotation) continue;
      const Complex mounts = felt.curves[1].value(0) + felt.curves[2].value(0);
      EXPECT_NEAR(std::abs(felt.curves[0].value(0) - mounts), 0, round_off) << "the mounts add up to the total";
    }
  }
}

TEST(Crossover, IsTheLastFrequencyAboveOne) {
  for (unsigned seed = 1; seed <= 4; ++seed)
    for (const Damping damping : {Damping::proportional, Damping::fractional}) {
      RandomSystem random(seed + 20);
      const model::System system = test::checked(random_description(seed, damping));
      const assembly::Assembled assembled = assembly::assemble(system);
      const auto force =
          response::force_transmission(system, assembled, {0, Eigen::Vector3d::Zero(), {random.vector(1), false}});
      const modal::Modes modes = modal::modes(system, assembled);
      const response::Peaks peaks = response::peaks(assembled, force.channels, force.loading, modes,
                                                    modal::roots(system, assembled, modes), {1e-6, 3000});
      const auto found = response::crossovers(assembled, force, peaks);
      constexpr double scan_step = 0.003;  // of the frequency: ln 30,000 / 4000
      const std::vector<double> scan = response::logarithmic_grid({0.1, 3000}, 4000);
      const auto curves = response::frequency_response(assembled, force.channels, force.loading, scan);
      for (std::size_t c = 0; c < found.size(); ++c) {
        double last_above = 0;
        for (std::size_t i = 0; i < scan.size(); ++i)
          if (std::abs(curves.curves[c].value(to_index(i))) > 1 + round_off) last_above = scan[i];
        ASSERT_TRUE(found[c].angular_frequency.has_value());
        EXPECT_NEAR(*found[c].angular_frequency, last_above, scan_step * last_above);
        EXPECT_GE(*found[c].angular_frequency, last_above);
        if (last_above == 0) continue;
        const auto there =
            response::frequency_response(assembled, {force.channels[c]}, force.loading, {*found[c].angular_frequency});
        EXPECT_THAT(std::abs(there.curves[0].value(0)), RelativelyNear(1.0, round_off));
      }
    }
}

TEST(RunUp, IsTheHarmonicResponseToEachOrderAtItsSpeed) {
  for (const Damping damping : {Damping::viscous, Damping::fractional}) {
    RandomSystem random(31);
    model::Description d = random_description(6, damping);
    d.excitations.clear();
    excitation::Order order{1.5};
    for (int j = 0; j < 6; ++j) {
      order.per_speed_squared(j) = random.number(-1e-3, 1e-3) * std::polar(1.0, random.number(-3, 3));
      order.fixed(j) = random.number(-2, 2) * std::polar(1.0, random.number(-3, 3));
    }
    model::Action action;
    action.body = 1;
    action.at = random.vector(0.3);
    d.excitations = {{"machine", action, model::Orders{{order}}}};
    const model::System system = test::checked(d);
    const assembly::Assembled assembled = assembly::assemble(system);
    const modal::Modes modes = modal::modes(system, assembled);
    const auto channels =
        assembly::channels(system, assembled, {"coordinates", "ground"}, assembly::MotionQuantity::displacement);
    const response::RunUp found = response::run_up(assembled, channels, response::order_loadings(system, assembled),
                                                   modes, modal::roots(system, assembled, modes), {{20, 100}, 1e-6, 5});
    EXPECT_FALSE(found.critical.empty());
    for (std::size_t i = 0; i < found.speed.size(); i += 3) {
      model::Action harmonic = action;
      harmonic.amplitude = found.speed[i] * found.speed[i] * order.per_speed_squared + order.fixed;
      const auto single = response::frequency_response(assembled, channels, assembly::loading(assembled, harmonic),
                                                       {1.5 * found.speed[i]});
      for (std::size_t c = 0; c < channels.size(); ++c)
        EXPECT_NEAR(std::abs(found.orders[0].curves[c].value(to_index(i)) - single.curves[c].value(0)), 0,
                    round_off * std::abs(single.curves[c].value(0)));
    }
  }
}

TEST(DeflectionShape, AgreesWithTheResults) {
  for (const Damping damping : {Damping::loss, Damping::fractional, Damping::foundation}) {
    const model::System system = test::checked(random_description(8, damping));
    const assembly::Assembled assembled = assembly::assemble(system);
    const assembly::Loading loading = assembly::harmonic_loading(system, assembled);
    const response::DeflectionShape shape = response::deflection_shape(system, assembled, loading, 40);
    const auto expect = [&](const std::string& word, const response::MovingPlace& place, const Eigen::Matrix3d& axes) {
      const auto channels = assembly::channels(system, assembled, {word}, assembly::MotionQuantity::displacement);
      const auto curves = response::frequency_response(assembled, channels, loading, {40});
      Eigen::Matrix<Complex, 6, 1> motion;
      for (int j = 0; j < 6; ++j) motion(j) = curves.curves[j].value(0);
      motion.head<3>() = (axes * motion.head<3>()).eval();
      motion.tail<3>() = (axes * motion.tail<3>()).eval();
      EXPECT_EQ(place.name, word);
      EXPECT_LT((place.motion - motion).norm(), round_off * motion.norm()) << word;
    };
    for (std::size_t b = 0; b < 2; ++b) {
      expect(system.bodies()[b].name, shape.bodies[b], system.bodies()[b].pose.rotation);
      expect(system.bodies()[b].name + ".tip", shape.points[b], system.bodies()[b].pose.rotation);
    }
    for (std::size_t e = 0; e < system.elements().size(); ++e)
      expect(system.elements()[e].name + ".foot", shape.feet[e], Eigen::Matrix3d::Identity());
    // The head of the first element is rigidly attached to its body.
    const Eigen::Vector3d arm = shape.heads[0].position - shape.bodies[0].position;
    const Eigen::Matrix<Complex, 6, 1> carried = spatial::rigid_motion(arm).cast<Complex>() * shape.bodies[0].motion;
    EXPECT_LT((shape.heads[0].motion - carried).norm(), round_off * carried.norm());
  }
}

TEST(DeflectionShape, FindsTheFarthestPointOfAnEllipse) {
  constexpr double scan_step = 1e-6;  // half of 0.1°, squared
  RandomSystem random(3);
  for (int trial = 0; trial < 5; ++trial) {
    Eigen::Vector3cd u;
    for (int j = 0; j < 3; ++j) u(j) = std::polar(random.number(0, 1), random.number(-3, 3));
    response::MovingPlace place;
    place.motion.head<3>() = u;
    double farthest = 0;
    for (int step = 0; step < 3600; ++step)
      farthest = std::max(farthest, response::displaced(place, step * std::numbers::pi / 1800, 1).norm());
    EXPECT_THAT(response::excursion(u), RelativelyNear(farthest, scan_step));
  }
}

TEST(LimitLine, IsExceededWhereADenseScanExceedsIt) {
  constexpr double between_points = 1e-4;  // of the scan, in steps of 2e-4
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const model::System system =
        test::checked(random_description(seed, seed == 4 ? Damping::fractional : Damping::proportional));
    const assembly::Assembled assembled = assembly::assemble(system);
    const modal::Modes modes = modal::modes(system, assembled);
    const modal::Roots roots = modal::roots(system, assembled, modes);
    const assembly::Loading loading = assembly::harmonic_loading(system, assembled);
    const auto channels = assembly::channels(system, assembled, {"body 1.tip.z"}, assembly::MotionQuantity::velocity);
    const std::vector<double> scan = response::logarithmic_grid({10, 500}, 20000);
    const Eigen::VectorXd level =
        response::frequency_response(assembled, channels, loading, scan).curves[0].value.cwiseAbs();
    const assembly::LimitLine line{
        "user's",
        "m/s",
        false,
        {10, 60, 60, 500},
        {0.3 * level.maxCoeff(), 0.6 * level.maxCoeff(), 0.2 * level.maxCoeff(), 0.05 * level.maxCoeff()}};
    const response::Peaks peaks = response::peaks(assembled, channels, loading, modes, roots, {1e-6, 500});
    const auto found =
        response::compared_with_limit(assembled, channels[0], loading, roots.poles, peaks, line, {10, 500});
    double least = 1e300;
    for (std::size_t i = 0; i < scan.size(); ++i) {
      const double margin = response::zero_to_peak_limit(line, std::clamp(scan[i], 10.0, 500.0)) / level(to_index(i));
      least = std::min(least, margin);
      const bool inside = std::ranges::any_of(
          found.exceeded, [&](const assembly::Band& b) { return scan[i] >= b.from && scan[i] <= b.to; });
      EXPECT_EQ(inside, margin < 1) << scan[i];
    }
    EXPECT_THAT(found.least_margin, RelativelyNear(least, between_points));
    EXPECT_LE(found.least_margin, least * (1 + round_off));
  }
}

}  // namespace steady_results_test
