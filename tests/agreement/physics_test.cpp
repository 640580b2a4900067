// SPDX-License-Identifier: BSD-3-Clause
// Properties of every model, on random systems (fixed seeds) with skew axes everywhere.
#include <gmock/gmock.h>

#include <Eigen/LU>

#include "support/matchers.h"
#include "support/random_system.h"
#include "trivet/assembly/channels.h"
#include "trivet/assembly/loads.h"
#include "trivet/elements/checks.h"
#include "trivet/elements/law.h"
#include "trivet/foundation/index.h"
#include "trivet/modal/roots.h"
#include "trivet/numerics/sweep/frequency_sweep.h"
#include "trivet/response/steady/deep_check.h"
#include "trivet/response/steady/frequency_response.h"
#include "trivet/spatial/rigid_motion.h"

namespace physics_test {

using namespace trivet;
using test::RandomDamping;

constexpr unsigned seeds = 12;
constexpr double round_off = 1e-10;      // systems of up to 18 coordinates with condition up to 1e5
constexpr double sum_round_off = 1e-9;   // sums of such results over bodies or roots
constexpr double last_digits = 1e-12;    // one matrix, or a sum of a few dozen positive terms
constexpr double of_the_matrix = 1e-12;  // backward error of an eigenpair

struct Variant {
  unsigned seed;
  std::size_t bodies;
  RandomDamping damping;
};

std::vector<Variant> variants() {
  std::vector<Variant> all;
  for (unsigned seed = 1; seed <= seeds; ++seed)
    all.push_back({seed, 1 + seed % 3, static_cast<RandomDamping>(seed % 4)});
  return all;
}

Eigen::MatrixXcd receptance(const assembly::Assembled& assembled, double omega) {
  const Eigen::Index n = assembled.matrices.size();
  Eigen::MatrixXcd result(n, n);
  for (Eigen::Index j = 0; j < n; ++j)
    result.col(j) = numerics::sweep(assembled.matrices, Eigen::VectorXcd::Unit(n, j), {omega}).response.col(0);
  return result;
}

std::vector<response::Curve> curves(const model::System& system, const std::vector<std::string>& of,
                                    const std::vector<double>& omega,
                                    assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement) {
  const assembly::Assembled assembled = assembly::assemble(system);
  return response::frequency_response(assembled, assembly::channels(system, assembled, of, quantity),
                                      assembly::harmonic_loading(system, assembled), omega)
      .curves;
}

TEST(Physics, ReceptancesAreReciprocal) {
  for (const Variant& v : variants()) {
    const assembly::Assembled assembled =
        assembly::assemble(test::checked(test::RandomSystem(v.seed).description(v.bodies, v.damping)));
    for (const double omega : {3.0, 40.0, 200.0}) {
      const Eigen::MatrixXcd r = receptance(assembled, omega);
      const Eigen::VectorXd scale = r.diagonal().cwiseAbs().cwiseSqrt();
      EXPECT_THAT(r, test::NearInUnits(r.transpose().eval(), scale, round_off)) << "seed " << v.seed;
    }
  }
}

TEST(Physics, ARigidMotionStoresNoEnergyInAnyElement) {
  for (const Variant& v : variants()) {
    const model::Description d = test::RandomSystem(v.seed).description(v.bodies, v.damping);
    for (const model::Element& element : d.elements) {
      const model::Span span = model::span(d.bodies, element.n, element.k);
      const auto verdict =
          elements::examine(element.law.nominal_stiffness, elements::rigid_motions(span.arm, span.n_from_k));
      EXPECT_LE(verdict.rigid_residual, last_digits);
    }
  }
}

TEST(Physics, AFreeSystemHasSixRigidModes) {
  for (const Variant& v : variants()) {
    const model::System system = test::checked(test::RandomSystem(v.seed).description(v.bodies + 1, v.damping, false));
    const modal::Modes modes = modal::modes(system);
    const auto rigid = std::ranges::count_if(modes.list, [](const auto& m) { return m.eigenvalue_squared == 0; });
    EXPECT_EQ(rigid, 6) << "seed " << v.seed;
    const modal::Roots roots = modal::roots(system);
    const auto zero = std::ranges::count_if(roots.list, [](const auto& r) { return r.kind == modal::RootKind::rigid; });
    EXPECT_EQ(zero, 12) << "seed " << v.seed;
  }
}

/// The same machine in a turned and shifted ground frame.
model::Description moved(model::Description d, const spatial::Pose& by) {
  for (auto& body : d.bodies)
    body.pose = {by.position + by.rotation * body.pose.position, by.rotation * body.pose.rotation};
  for (auto& element : d.elements)
    if (!element.n.body) {
      element.n.at = by.position + by.rotation * element.n.at;
      element.n.axes = (by.rotation * element.n.axes).eval();
    }
  return d;
}

TEST(Physics, TurningAndShiftingTheGroundFrameChangesNothing) {
  for (const Variant& v : variants()) {
    test::RandomSystem random(v.seed);
    const model::Description d = random.description(v.bodies, v.damping);
    const model::System here = test::checked(d), there = test::checked(moved(d, {random.vector(3), random.rotation()}));
    const auto a = curves(here, {"coordinates"}, {0, 10, 50}), b = curves(there, {"coordinates"}, {0, 10, 50});
    for (std::size_t c = 0; c < a.size(); ++c)
      EXPECT_THAT(b[c].value, test::NearVector(a[c].value, round_off)) << "seed " << v.seed << " " << a[c].name;
  }
}

/// The same machine described from another pole and in turned body axes.
model::Description from_other_pole(model::Description d, std::size_t index, const spatial::Pose& new_frame) {
  model::Body& body = d.bodies[index];
  const Eigen::Matrix3d back = new_frame.rotation.transpose();
  const auto point = [&](const Eigen::Vector3d& r) -> Eigen::Vector3d { return back * (r - new_frame.position); };
  body.pose = {body.pose.position + body.pose.rotation * new_frame.position, body.pose.rotation * new_frame.rotation};
  body.mass.centre = point(body.mass.centre);
  body.mass.inertia_about_centre = (back * body.mass.inertia_about_centre * new_frame.rotation).eval();
  for (auto& p : body.points) p.at = point(p.at);
  for (auto& element : d.elements)
    for (model::End* end : {&element.n, &element.k})
      if (end->body == index) {
        end->at = point(end->at);
        end->axes = (back * end->axes).eval();
      }
  return d;
}

TEST(Physics, MovingThePoleAndTurningTheBodyAxesChangesNothingPhysical) {
  for (const Variant& v : variants()) {
    test::RandomSystem random(v.seed);
    model::Description d = random.description(v.bodies, v.damping);
    d.excitations[0].action.amplitude =
        d.excitations[0].action.amplitude.cwiseAbs().cast<std::complex<double>>().eval();
    const std::size_t index = v.bodies - 1;
    const spatial::Pose frame{random.vector(0.8), random.rotation()};
    model::Description other = from_other_pole(d, index, frame);
    auto& force = other.excitations[0].action;
    const Eigen::Matrix3d back = frame.rotation.transpose();
    force.at = back * (force.at - frame.position);
    force.amplitude = (spatial::both_blocks(back).cast<std::complex<double>>() * force.amplitude).eval();
    const model::System one = test::checked(d), two = test::checked(other);
    const auto a = modal::modes(one), b = modal::modes(two);
    for (std::size_t i = 0; i < a.list.size(); ++i)
      EXPECT_THAT(b.list[i].eigenvalue_squared, test::RelativelyNear(a.list[i].eigenvalue_squared, round_off));
    const auto ground_a = curves(one, {"ground"}, {5, 60}), ground_b = curves(two, {"ground"}, {5, 60});
    for (std::size_t c = 0; c < ground_a.size(); ++c)
      EXPECT_THAT(ground_b[c].value, test::NearVector(ground_a[c].value, round_off)) << ground_a[c].name;
  }
}

TEST(Physics, EnergySharesSumToOne) {
  for (const Variant& v : variants()) {
    const modal::Modes modes = modal::modes(test::checked(test::RandomSystem(v.seed).description(v.bodies, v.damping)));
    for (const modal::Mode& mode : modes.list) {
      EXPECT_NEAR(mode.kinetic_energy_share.sum(), 1, last_digits);
      EXPECT_NEAR(mode.principal_kinetic_energy_share.sum(), 1, last_digits);
      EXPECT_GE(mode.principal_kinetic_energy_share.minCoeff(), 0);
      EXPECT_NEAR(mode.strain_energy_share->sum(), 1, last_digits);
    }
  }
}

TEST(Physics, EveryRootMakesTheDynamicMatrixSingular) {
  for (const Variant& v : variants()) {
    const model::System system = test::checked(test::RandomSystem(v.seed).description(v.bodies, v.damping));
    const numerics::DynamicMatrices m = assembly::assemble(system).matrices;
    const modal::Roots roots = modal::roots(system);
    EXPECT_EQ(roots.list.size(), to_size(m.lossy() ? m.size() : 2 * m.size()));
    for (const modal::Root& root : roots.list) {
      const Eigen::MatrixXcd z = root.eigenvalue * root.eigenvalue * m.A.cast<std::complex<double>>() +
          root.eigenvalue * m.B.cast<std::complex<double>>() + m.complex_stiffness();
      EXPECT_LE((z * root.shape).norm() / (z.norm() * root.shape.norm()), of_the_matrix) << "seed " << v.seed;
    }
  }
}

TEST(Physics, TwoSolversAgreeWithinRoundOffTimesCondition) {
  for (const Variant& v : variants()) {
    const model::System system = test::checked(test::RandomSystem(v.seed).description(v.bodies, v.damping));
    const assembly::Assembled assembled = assembly::assemble(system);
    const auto check = response::deep_check(system, assembled, assembly::harmonic_loading(system, assembled),
                                            {0, 1, 7, 33, 90, 210, 500});
    EXPECT_TRUE(check.passed) << "seed " << v.seed << ": " << check.worst_difference << " against " << check.allowed;
    EXPECT_EQ(check.frequencies, 7);
  }
}

TEST(Physics, TheSecondSolverNoticesAWrongFirstOne) {
  const model::System system = test::checked(test::RandomSystem(4).description(2, RandomDamping::viscous));
  assembly::Assembled wrong = assembly::assemble(system);
  const Eigen::VectorXcd load = assembly::harmonic_loading(system, wrong).force.at(0);
  wrong.matrices.K(0, 0) *= 1 + 1e-6;
  EXPECT_FALSE(response::deep_check(system, wrong, load, {1, 20, 60}).passed);
}

TEST(Physics, GroundForceAndAppliedForceMakeTheMomentumChange) {
  // Newton for the whole system in ground axes: applied − on the ground = Σ m a_C.
  for (const Variant& v : variants()) {
    model::Description d = test::RandomSystem(v.seed).description(v.bodies, v.damping);
    for (auto& body : d.bodies) body.points = {{"centre", body.mass.centre}};
    const model::System system = test::checked(d);
    const model::Action& force = d.excitations[0].action;
    Eigen::Vector3cd applied;
    applied = force.amplitude.head<3>();
    applied = (d.bodies[*force.body].pose.rotation.cast<std::complex<double>>() * applied).eval();
    for (const double omega : {4.0, 45.0}) {
      const auto ground = curves(system, {"ground"}, {omega});
      Eigen::Vector3cd momentum_change = Eigen::Vector3cd::Zero();
      for (const auto& body : d.bodies) {
        const auto a = curves(system, {body.name + ".centre"}, {omega}, assembly::MotionQuantity::acceleration);
        const Eigen::Vector3cd acceleration(a[0].value(0), a[1].value(0), a[2].value(0));
        momentum_change += body.mass.mass * (body.pose.rotation.cast<std::complex<double>>() * acceleration);
      }
      const Eigen::Vector3cd on_ground(ground[0].value(0), ground[1].value(0), ground[2].value(0));
      EXPECT_LE((applied - on_ground - momentum_change).norm(), sum_round_off * (applied.norm() + on_ground.norm()))
          << "seed " << v.seed;
    }
  }
}

TEST(Physics, UnitsScaleAsTheyMust) {
  // Millimetres, tonnes, seconds: lengths × 1000, masses / 1000; forces stay newtons.
  const model::Description d = test::RandomSystem(5).description(2, RandomDamping::viscous);
  model::Description mm = d;
  const double length = 1000;
  spatial::Vector6 unit;
  unit << 1, 1, 1, length, length, length;
  spatial::Vector12 units;
  units << unit, unit;
  const auto rescale = [&](const spatial::Matrix12& c) -> spatial::Matrix12 {
    return units.asDiagonal() * c * units.asDiagonal() / length;
  };
  for (auto& body : mm.bodies) {
    body.pose.position *= length;
    body.mass.mass /= length;
    body.mass.centre *= length;
    body.mass.inertia_about_centre *= length * length / length;
  }
  for (auto& element : mm.elements) {
    element.n.at *= length;
    element.k.at *= length;
    element.law.nominal_stiffness = rescale(element.law.nominal_stiffness);
    std::get<elements::DampingMatrix>(element.law.damping).matrix =
        rescale(std::get<elements::DampingMatrix>(element.law.damping).matrix);
  }
  const auto a = modal::modes(test::checked(d)), b = modal::modes(test::checked(mm));
  for (std::size_t i = 0; i < a.list.size(); ++i)
    EXPECT_THAT(b.list[i].eigenvalue_squared, test::RelativelyNear(a.list[i].eigenvalue_squared, round_off));
}

TEST(Physics, DampedResponseIsTheSumOverItsRoots) {
  // q(ω) = Σ v vᵀh / ((iω − λ) vᵀ(2λA + B)v) for a symmetric system with simple roots: poles against the direct solver.
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    const model::System system =
        test::checked(test::RandomSystem(seed).description(1 + seed % 2, RandomDamping::viscous));
    const assembly::Assembled assembled = assembly::assemble(system);
    const Eigen::VectorXcd h = assembly::harmonic_loading(system, assembled).force.at(0);
    const modal::Roots roots = modal::roots(system);
    for (const double omega : {2.0, 30.0, 120.0}) {
      Eigen::VectorXcd sum = Eigen::VectorXcd::Zero(h.size());
      for (const modal::Root& root : roots.list) {
        const Eigen::VectorXcd& v = root.shape;
        const std::complex<double> slope =
            v.transpose() * (2.0 * root.eigenvalue * assembled.matrices.A + assembled.matrices.B) * v;
        const std::complex<double> drive = v.transpose() * h;
        sum += v * drive / ((std::complex<double>(0, omega) - root.eigenvalue) * slope);
      }
      EXPECT_THAT(
          sum, test::NearVector(numerics::sweep(assembled.matrices, h, {omega}).response.col(0).eval(), sum_round_off))
          << "seed " << seed;
    }
  }
}

}  // namespace physics_test
