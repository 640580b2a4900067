// SPDX-License-Identifier: BSD-3-Clause
// The coil spring by other methods: flexibility summed numerically, straight beam elements, its limits.
#include <gmock/gmock.h>

#include <Eigen/Geometry>

#include "support/coil_springs.h"
#include "support/matchers.h"
#include "trivet/elements/checks.h"
#include "trivet/elements/coil_dynamics.h"
#include "trivet/elements/coil_reduction.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/eigenvalues.h"
#include "trivet/spatial/rigid_motion.h"

namespace coil_spring_test {

using namespace trivet;
using elements::CoilSpring;
using elements::Matrix12;
using elements::Matrix6;
using test::literature_spring;
using test::random_spring;
using test::scaled_difference;
constexpr double pi = std::numbers::pi;
constexpr int springs_tried = 60;
constexpr double round_off = 1e-12;          // closed forms of some hundred operations
constexpr double transfer_round_off = 1e-9;  // along the wire, up to 20 turns

struct Point {
  Eigen::Vector3d place, tangent;
};

/// The wire's centre line from the seat at N, directly from the definition.
Point on_wire(const CoilSpring& s, double fraction) {
  const double hand = s.hand == elements::Hand::right ? 1 : -1, sweep = 2 * pi * s.active_coils * hand,
               radius = s.mean_diameter / 2;
  const double angle = s.start_angle + sweep * fraction;
  return {{radius * std::cos(angle), radius * std::sin(angle),
           s.dead_coils_n * wire_height(s) + s.active_length * fraction},
          {-radius * sweep * std::sin(angle), radius * sweep * std::cos(angle), s.active_length}};
}

/// Section axes: along the wire, radial in the plane normal to it, and the third.
Eigen::Matrix3d axes_at(const Point& p) {
  Eigen::Matrix3d axes;
  const Eigen::Vector3d radial = Eigen::Vector3d(p.place.x(), p.place.y(), 0).normalized(), t = p.tangent.normalized();
  axes << t, radial, t.cross(radial);
  return axes;
}

elements::Vector6 section_flexibility(const CoilSpring& s) {
  const elements::WireSection w = wire_section(s);
  const double E = s.youngs_modulus, G = s.shear_modulus;
  elements::Vector6 f;
  f << 1 / (E * w.area), 1 / (w.shear_factor * G * w.area), 1 / (w.shear_factor * G * w.area),
      1 / (G * w.torsion_constant), 1 / (E * w.second_moments(0)), 1 / (E * w.second_moments(1));
  return f;
}

/// Castigliano's integral over the wire, eight-point Gauss on panels of a quarter turn.
Matrix6 stiffness_by_quadrature(const CoilSpring& s) {
  constexpr double node[] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
  constexpr double weight[] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};
  const int panels = 4 * int(std::ceil(s.active_coils)) + 4;
  const Eigen::Vector3d seat(0, 0, seat_distance(s));
  Matrix6 flexibility = Matrix6::Zero();
  for (int panel = 0; panel < panels; ++panel)
    for (int k = 0; k < 8; ++k) {
      const Point p = on_wire(s, (panel + 0.5 + (k % 2 ? 0.5 : -0.5) * node[k / 2]) / panels);
      const Matrix6 to_section =
          spatial::both_blocks(axes_at(p).transpose()) * spatial::rigid_motion(seat - p.place).transpose();
      flexibility += 0.5 * weight[k / 2] / panels * p.tangent.norm() * to_section.transpose() *
          section_flexibility(s).asDiagonal() * to_section;
    }
  return numerics::inverse(flexibility);
}

TEST(CoilSpring, ClosedFormIsTheQuadratureOfItsFlexibility) {
  constexpr double quadrature = 1e-10;  // eight-point Gauss is exact to round-off on a quarter turn
  const CoilSpring published = literature_spring();
  EXPECT_LE(
      scaled_difference(stiffness(published).bottomRightCorner<6, 6>().eval(), stiffness_by_quadrature(published)),
      quadrature);
  std::mt19937 random(1);
  for (int i = 0; i < springs_tried; ++i) {
    const CoilSpring spring = random_spring(random);
    EXPECT_LE(scaled_difference(stiffness(spring).bottomRightCorner<6, 6>().eval(), stiffness_by_quadrature(spring)),
              quadrature)
        << i;
  }
}

/// Stiffness of a chain of straight shear-flexible beams with nodes on the wire, condensed node by node.
Matrix6 stiffness_of_chords(const CoilSpring& s, int count) {
  Matrix6 moved_end = Matrix6::Zero();
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d from = on_wire(s, double(i) / count).place, to = on_wire(s, (i + 1.0) / count).place;
    const Eigen::Vector3d middle = on_wire(s, (i + 0.5) / count).place;
    const Eigen::Matrix3d axes = axes_at({middle, to - from});
    const double L = (to - from).norm();
    Matrix6 at_end = section_flexibility(s).asDiagonal();
    at_end *= L;
    const Eigen::Vector3d bend = section_flexibility(s).tail<3>();
    at_end(1, 1) += bend(2) * L * L * L / 3, at_end(2, 2) += bend(1) * L * L * L / 3;
    at_end(1, 5) = at_end(5, 1) = bend(2) * L * L / 2, at_end(2, 4) = at_end(4, 2) = -bend(1) * L * L / 2;
    const Matrix6 turn = spatial::both_blocks(axes);
    const Matrix6 carry = spatial::rigid_motion(to - from);
    // Flexibility of the chain so far, transformed to the new end, plus that of the new piece.
    moved_end = carry * moved_end * carry.transpose() + turn * at_end * turn.transpose();
  }
  const Matrix6 to_seat = spatial::rigid_motion(Eigen::Vector3d(0, 0, seat_distance(s)) - on_wire(s, 1).place);
  return numerics::inverse(Matrix6(to_seat * moved_end * to_seat.transpose()));
}

TEST(CoilSpring, StraightBeamElementsConvergeToItWithSecondOrder) {
  const Matrix6 exact = stiffness(literature_spring()).bottomRightCorner<6, 6>();
  constexpr double higher_orders = 0.02, truncation = 1e-4;  // of 2432 chords
  double previous = scaled_difference(stiffness_of_chords(literature_spring(), 152), exact);
  for (const int count : {304, 608, 1216, 2432}) {
    const double error = scaled_difference(stiffness_of_chords(literature_spring(), count), exact);
    EXPECT_THAT(previous / error, test::RelativelyNear(4.0, higher_orders)) << count;
    previous = error;
  }
  EXPECT_LE(previous, truncation);
}

TEST(CoilSpring, ARigidMotionStoresNoEnergyInAnySpring) {
  std::mt19937 random(2);
  for (int i = 0; i < springs_tried; ++i) {
    CoilSpring spring = random_spring(random);
    spring.seat_n = i % 2 ? elements::Seat::pivoted : elements::Seat::clamped;
    spring.seat_k = i % 3 ? elements::Seat::pivoted : elements::Seat::clamped;
    const elements::MatrixVerdict verdict = elements::examine(
        stiffness(spring), elements::rigid_motions({0, 0, seat_distance(spring)}, Eigen::Matrix3d::Identity()));
    EXPECT_LE(verdict.rigid_residual, round_off) << i;
    EXPECT_LE(verdict.asymmetry, round_off) << i;
    EXPECT_TRUE(elements::is_semidefinite(verdict)) << i;
  }
}

TEST(CoilSpring, DynamicStiffnessTendsToTheStaticOne) {
  std::mt19937 random(3);
  for (int i = 0; i < springs_tried; ++i) {
    CoilSpring spring = random_spring(random);
    spring.seat_k = i % 2 ? elements::Seat::pivoted : elements::Seat::clamped;
    Matrix12 expected = stiffness(spring);
    if (i % 2) expected(9, 9) = expected(10, 10) = 1;  // rows of a pivot are zero in both
    Matrix12 dynamic = dynamic_stiffness(spring, 0.0);
    if (i % 2) dynamic(9, 9) = dynamic(10, 10) = 1;
    EXPECT_LE(scaled_difference(dynamic, expected), transfer_round_off) << i;
  }
}

TEST(CoilSpring, TurningTheSpringTurnsItsMatrix) {
  CoilSpring spring = literature_spring();
  const Matrix12 k = stiffness(spring);
  spring.start_angle = 1.1;
  Matrix12 turn = Matrix12::Zero();
  turn.topLeftCorner<6, 6>() = turn.bottomRightCorner<6, 6>() =
      spatial::both_blocks(spatial::rotation_about({0, 0, 1}, 1.1));
  EXPECT_LE(scaled_difference(stiffness(spring), (turn * k * turn.transpose()).eval()), round_off);
}

TEST(CoilSpring, ALeftHandIsTheMirrorImage) {
  CoilSpring spring = literature_spring();
  spatial::Vector12 mirror;
  mirror << 1, -1, 1, -1, 1, -1, 1, -1, 1, -1, 1, -1;
  const double omega = 2 * pi * 700;
  const Matrix12 expected = mirror.asDiagonal() * dynamic_stiffness(spring, omega) * mirror.asDiagonal();
  spring.hand = elements::Hand::left;
  EXPECT_LE(scaled_difference(dynamic_stiffness(spring, omega), expected), round_off);
}

TEST(CoilSpring, LossAlwaysDissipatesEnergy) {
  std::mt19937 random(4);
  for (int i = 0; i < springs_tried; ++i) {
    CoilSpring spring = random_spring(random);
    spring.loss_factor = 0.02;
    const elements::SeatedCoil coil = seated_coil(spring);
    const double surge = natural_frequencies(coil, elements::SeatsHeld::both, 1)[0];
    for (double ratio : {0.01, 0.9, 1.0, 3.3, 20.0}) {
      const Matrix12 loss = dynamic_stiffness(coil, std::complex<double>(ratio * surge, 0)).imag();
      const spatial::Vector12 scale = loss.diagonal().cwiseSqrt().cwiseInverse();
      const Matrix12 unit = scale.asDiagonal() * loss * scale.asDiagonal();
      EXPECT_GE(numerics::symmetric_eigenvalues(unit)(0), -transfer_round_off) << i << ", " << ratio;
    }
  }
}

TEST(CoilSpring, CountedFrequenciesAreZerosOfTheFreeEndsDeterminant) {
  constexpr double of_a_zero = 1e-6;  // a frequency is known to round-off, and the determinant is steep there
  // Between two natural frequencies with K free, det D_KK keeps its sign except at the poles of the clamped spring.
  std::mt19937 random(5);
  for (int i = 0; i < 10; ++i) {
    const elements::SeatedCoil coil = seated_coil(random_spring(random));
    const std::vector<double> free = natural_frequencies(coil, elements::SeatsHeld::n_only, 12);
    const std::vector<double> clamped = natural_frequencies(coil, elements::SeatsHeld::both, 12);
    for (std::size_t k = 0; k < 12; ++k) {
      EXPECT_LE(free[k], clamped[k] * (1 + round_off)) << "holding an end raises every frequency";
      EXPECT_GE(free[k], k < 6 ? 0 : clamped[k - 6] * (1 - round_off)) << "six constraints shift by six at most";
      const Matrix6 d = dynamic_stiffness(coil, free[k]).bottomRightCorner<6, 6>();
      const elements::Vector6 scale = d.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse();
      const Matrix6 unit = scale.asDiagonal() * d * scale.asDiagonal();
      EXPECT_LE(numerics::symmetric_eigenvalues(unit).cwiseAbs().minCoeff(), of_a_zero) << i << ", " << k;
    }
  }
}

/// Rigid-body inertia of the wire and its dead coils about the seat at N, summed point by point.
Matrix6 rigid_mass(const CoilSpring& s) {
  constexpr int points = 20000;
  const double line_mass = s.density * wire_section(s).area;
  Matrix6 total = Matrix6::Zero();
  for (int i = 0; i < points; ++i) {
    const Point p = on_wire(s, (i + 0.5) / points);
    Matrix6 local = line_mass * Matrix6::Identity();
    const Eigen::Matrix3d axes = axes_at(p);
    const Eigen::Vector3d moments(wire_section(s).second_moments(2), wire_section(s).second_moments(0),
                                  wire_section(s).second_moments(1));
    local.bottomRightCorner<3, 3>() = s.density * axes * moments.asDiagonal() * axes.transpose();
    total +=
        p.tangent.norm() / points * spatial::rigid_motion(p.place).transpose() * local * spatial::rigid_motion(p.place);
  }
  return total;
}

TEST(ReducedCoil, CarriesTheRigidInertiaOfTheWire) {
  constexpr double summation = 1e-7;  // midpoint rule on 20,000 points of up to 20 turns
  std::mt19937 random(6);
  for (int i = 0; i < 10; ++i) {
    CoilSpring spring = random_spring(random);
    spring.dead_coils_n = spring.dead_coils_k = 0;
    const Matrix12 mass = reduced(spring, 0).mass;
    Eigen::Matrix<double, 12, 6> about_n;
    about_n << Matrix6::Identity(), spatial::rigid_motion({0, 0, seat_distance(spring)});
    EXPECT_LE(scaled_difference((about_n.transpose() * mass * about_n).eval(), rigid_mass(spring)), summation) << i;
  }
}

/// Dynamic stiffness of the reduced spring.
Matrix12 condensed(const elements::ReducedCoil& r, double omega) {
  const Eigen::VectorXd factor =
      std::pow(omega, 4) * (r.natural_frequencies.array().square() - omega * omega).inverse();
  return r.stiffness - omega * omega * r.mass - r.coupling * factor.asDiagonal() * r.coupling.transpose();
}

TEST(ReducedCoil, ConvergesToTheExactDynamicStiffness) {
  constexpr double truncation = 0.02;  // 40 modes at the first frequency; it grows with the fourth power
  constexpr double gain = 0.1;         // ten times as many modes leave less than a tenth
  std::mt19937 random(7);
  for (int i = 0; i < 12; ++i) {
    CoilSpring spring = random_spring(random);
    if (i % 3 == 1) spring.seat_k = elements::Seat::pivoted;
    const elements::SeatedCoil coil = seated_coil(spring);
    const elements::ReducedCoil few = reduced(spring, 4), many = reduced(spring, 40);
    CoilSpring clamped = spring;
    clamped.seat_k = elements::Seat::clamped;
    const spatial::Vector12 scale = stiffness(clamped).diagonal().cwiseSqrt();
    for (const double ratio : {0.2, 0.8, 1.3}) {
      const double omega = ratio * few.natural_frequencies(0);
      const Matrix12 exact = dynamic_stiffness(coil, omega);
      EXPECT_THAT(condensed(many, omega), test::NearInUnits(exact, scale, truncation * std::pow(ratio, 4)))
          << i << ", " << ratio;
      const auto error = [&](const elements::ReducedCoil& r) {
        return (scale.cwiseInverse().asDiagonal() * (condensed(r, omega) - exact) * scale.cwiseInverse().asDiagonal())
            .eval()
            .norm();
      };
      EXPECT_LE(error(many), gain * error(few)) << i << ", " << ratio;
    }
  }
}

TEST(ReducedCoil, ExtendedMatricesHaveTheFrequenciesOfTheFreeSpring) {
  constexpr double truncation = 2e-3,
                   order = 3.5;  // error of the sixth with 16 modes; twice as many divide it at least by `order`
  constexpr double eigen_round_off = 1e-10;  // of the lowest of 38 frequencies
  const std::vector<double> exact = natural_frequencies(literature_spring(), elements::SeatsHeld::n_only, 6);
  const auto errors = [&](int modes) -> Eigen::VectorXd {
    const elements::ReducedCoil r = reduced(literature_spring(), modes);
    const Eigen::MatrixXd k = r.extended_stiffness().bottomRightCorner(6 + modes, 6 + modes);
    const Eigen::MatrixXd a = r.extended_mass().bottomRightCorner(6 + modes, 6 + modes);
    const Eigen::VectorXd lambda = numerics::symmetric_eigen(k, a).values;
    return lambda.head<6>()
               .cwiseSqrt()
               .cwiseQuotient(Eigen::Map<const Eigen::Matrix<double, 6, 1>>(exact.data()))
               .array() -
        1;
  };
  const Eigen::VectorXd few = errors(16), many = errors(32);
  EXPECT_LE(few.maxCoeff(), truncation);
  EXPECT_GE(many.minCoeff(), -eigen_round_off) << "left-out modes can only stiffen";
  EXPECT_LE(many.maxCoeff(), few.maxCoeff() / order);
}

TEST(ReducedCoil, FrequenciesThatNearlyCoincideKeepTheirOwnCouplings) {
  // Sixty whole turns: the first two lateral modes differ by 4e-5.
  constexpr double truncation = 1e-3, pair = 1e-4;
  CoilSpring spring = literature_spring();
  spring.active_length *= 60 / spring.active_coils;
  spring.active_coils = 60;
  const elements::ReducedCoil r = reduced(spring, 40);
  const double first = r.natural_frequencies(0), second = r.natural_frequencies(1);
  ASSERT_LT(second / first - 1, pair);
  for (const double omega : {0.5 * first, 0.9999 * first, 0.5 * (first + second), 1.0001 * second})
    EXPECT_LE(scaled_difference(condensed(r, omega), dynamic_stiffness(seated_coil(spring), omega)), truncation)
        << omega / first;
}

}  // namespace coil_spring_test
