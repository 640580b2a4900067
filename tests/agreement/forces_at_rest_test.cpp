// SPDX-License-Identifier: BSD-3-Clause
// The stiffness of machines under gravity, against second differences of their energy in finite rotations.
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "support/matchers.h"
#include "support/random_system.h"
#include "trivet/assembly/assembled.h"
#include "trivet/foundation/index.h"
#include "trivet/modal/modes.h"

namespace forces_at_rest_test {

using namespace trivet;
using test::RelativelyNear;

using Real = long double;
using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
using Vector3 = Eigen::Matrix<Real, 3, 1>;
using Matrix3 = Eigen::Matrix<Real, 3, 3>;
using Six = Eigen::Matrix<Real, 6, 1>;

/// Differences of the eighth order over ± 4 steps of 1e-2 in extended precision.
constexpr double of_differences = 1e-10;
constexpr double of_modes = 1e-9;  // squares of frequencies of turned and moved models

Matrix3 rotation(const Vector3& about) {
  const Real angle = about.norm();
  return angle > 0 ? Eigen::AngleAxis<Real>(angle, about / angle).toRotationMatrix() : Matrix3(Matrix3::Identity());
}

/// Rotation vector of a rotation by less than π/2.
Vector3 rotation_vector(const Matrix3& r) {
  const Vector3 twice(r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1));
  const Real sine = twice.norm() / 2;
  return sine > 0 ? Vector3(std::asin(sine) / (2 * sine) * twice) : Vector3(Vector3::Zero());
}

/// A machine of bodies and elements with a 12×12, whose laws are those of end K seen from axes that turn with end N.
class FiniteMachine {
 public:
  explicit FiniteMachine(const model::System& system) : system_(system), layout_(system.description()) {
    for (std::size_t e = 0; e < system.elements().size(); ++e) on_k_.push_back(Six::Zero());
  }

  [[nodiscard]] Eigen::Index size() const { return layout_.size(); }

  /// Takes the forces that balance the load to first order, K₀ q = Q, as those of the elements at rest.
  void load() {
    const Matrix stiffness = second_differences([&](const Vector& q) { return of_elements(q); });
    const auto weight = [&](const Vector& q) { return of_loads(q); };
    Vector forces(size());
    for (Eigen::Index i = 0; i < size(); ++i) forces(i) = -first_difference(weight, i);
    const Vector rest = stiffness.fullPivLu().solve(forces);
    std::vector<Six> found;
    for (std::size_t e = 0; e < on_k_.size(); ++e) {
      Six moved = Six::Zero();
      for (int j = 0; j < 6; ++j)
        moved(j) = slope([&](Real step) { return deflection(e, step * rest)(j); }, small / rest.norm());
      found.push_back(at_k(e) * moved);
    }
    on_k_ = found;
  }

  /// Second derivative of the whole energy.
  [[nodiscard]] Eigen::MatrixXd stiffness() const {
    return second_differences([&](const Vector& q) { return of_elements(q) + of_loads(q); }).cast<double>();
  }

 private:
  static constexpr Real small = 1e-2L;
  static constexpr std::array<std::pair<int, Real>, 4> first_weights = {
      {{1, 4.0L / 5}, {2, -1.0L / 5}, {3, 4.0L / 105}, {4, -1.0L / 280}}};

  template <typename Function>
  static Real slope(const Function& f, Real step) {
    Real sum = 0;
    for (const auto& [node, weight] : first_weights) sum += weight * (f(node * step) - f(-node * step));
    return sum / step;
  }
  template <typename Function>
  [[nodiscard]] Real first_difference(const Function& f, Eigen::Index i) const {
    return slope([&](Real step) { return f(Vector(step * Vector::Unit(size(), i))); }, small);
  }
  template <typename Function>
  [[nodiscard]] Matrix second_differences(const Function& f) const {
    Matrix all(size(), size());
    for (Eigen::Index i = 0; i < size(); ++i)
      for (Eigen::Index j = 0; j <= i; ++j)
        all(i, j) = all(j, i) = slope(
            [&](Real a) {
              return slope([&](Real b) { return f(Vector(a * Vector::Unit(size(), i) + b * Vector::Unit(size(), j))); },
                           small);
            },
            small);
    return all;
  }

  struct Place {
    Vector3 at;
    Matrix3 axes;
  };
  [[nodiscard]] Place place(const std::optional<std::size_t>& body, const Eigen::Vector3d& at,
                            const Eigen::Matrix3d& axes, const Vector& q) const {
    if (!body) return {at.cast<Real>(), axes.cast<Real>()};
    const model::Body& own = system_.bodies()[*body];
    const Six moved = layout_.of_body(*body, q);
    const Matrix3 turned = rotation(Vector3(moved.tail<3>())), pose = own.pose.rotation.cast<Real>();
    return {own.pose.position.cast<Real>() + pose * (Vector3(moved.head<3>()) + turned * at.cast<Real>()),
            pose * turned * axes.cast<Real>()};
  }

  /// Of end K seen from end N, in the axes of K at rest.
  [[nodiscard]] Six deflection(std::size_t e, const Vector& q) const {
    const model::Element& element = system_.elements()[e];
    const Vector none = Vector::Zero(size());
    const auto seen = [&](const Vector& at) {
      const Place n = place(element.n.body, element.n.at, element.n.axes, at),
                  k = place(element.k.body, element.k.at, element.k.axes, at);
      return Place{n.axes.transpose() * (k.at - n.at), n.axes.transpose() * k.axes};
    };
    const Place before = seen(none), now = seen(q);
    Six result;
    result << before.axes.transpose() * (now.at - before.at),
        before.axes.transpose() * rotation_vector(now.axes * before.axes.transpose());
    return result;
  }
  [[nodiscard]] Eigen::Matrix<Real, 6, 6> at_k(std::size_t e) const {
    const elements::Law& law = system_.elements()[e].law;
    return (law.scale * law.nominal_stiffness.bottomRightCorner<6, 6>()).cast<Real>();
  }
  [[nodiscard]] Real of_elements(const Vector& q) const {
    Real energy = 0;
    for (std::size_t e = 0; e < on_k_.size(); ++e) {
      const Six moved = deflection(e, q);
      energy += on_k_[e].dot(moved) + moved.dot(at_k(e) * moved) / 2;
    }
    return energy;
  }
  [[nodiscard]] Real of_loads(const Vector& q) const {
    Real energy = 0;
    const Vector3 gravity = system_.description().gravity->cast<Real>();
    for (std::size_t b = 0; b < system_.bodies().size(); ++b) {
      const spatial::MassProperties& mass = system_.bodies()[b].mass;
      energy -= Real(mass.mass) * gravity.dot(place(b, mass.centre, Eigen::Matrix3d::Identity(), q).at);
    }
    for (const model::ConstantForce& force : system_.description().constant_forces) {
      const Matrix3 pose = system_.bodies()[force.body].pose.rotation.cast<Real>();
      energy -=
          (pose * force.wrench.force.cast<Real>()).dot(place(force.body, force.at, Eigen::Matrix3d::Identity(), q).at);
    }
    return energy;
  }

  const model::System& system_;
  assembly::Layout layout_;
  std::vector<Six> on_k_;
};

/// Two stages on full matrices with skew axes, the weight large against their stiffness; one element between the
/// bodies has end N on the upper one, one joins that to the ground.
model::Description two_stages(unsigned seed) {
  test::RandomSystem random(seed);
  model::Description d = random.description(2, test::RandomDamping::none);
  std::swap(d.elements[2].n, d.elements[2].k);
  const model::Span span = model::span(d.bodies, d.elements[2].n, d.elements[2].k);
  d.elements[2].law.nominal_stiffness =
      elements::in_end_axes(elements::from_moved_end(random.stiffness(5e4, 0.2), span.arm), span.n_from_k);
  d.elements.push_back(random.element("wall", std::nullopt, 1, d.bodies, test::RandomDamping::none));
  d.gravity = random.vector(30);
  d.constant_forces.push_back({"pull", 1, random.vector(0.3), {random.vector(2000), Eigen::Vector3d::Zero()}});
  return d;
}

void expect_finite_stiffness(const model::Description& description) {
  const model::System system = test::checked(description);
  const assembly::Assembled assembled = assembly::assemble(system);
  FiniteMachine finite(system);
  finite.load();
  const Eigen::MatrixXd expected = finite.stiffness();
  const Eigen::VectorXd scale = expected.diagonal().cwiseAbs().cwiseSqrt();
  EXPECT_THAT(assembled.matrices.K, test::NearInUnits(expected, scale, of_differences));
  // The weight matters: without it the stiffness is another one.
  EXPECT_THAT(assembled.first_order().matrices.K, testing::Not(test::NearInUnits(expected, scale, 1e-4)));
}

TEST(ForcesAtRest, GiveTheStiffnessOfFiniteRotations) {
  for (unsigned seed = 1; seed <= 3; ++seed) expect_finite_stiffness(two_stages(seed));
}

TEST(ForcesAtRest, GiveTheStiffnessOfGuidedBodies) {
  model::Description d = two_stages(4);
  d.bodies[0].free = {true, false, true, true, false, true};
  d.bodies[1].free = {false, false, false, true, true, false};
  expect_finite_stiffness(d);
}

/// Squares of the natural angular frequencies.
Eigen::VectorXd squares(const model::Description& description) {
  const model::System system = test::checked(description);
  const modal::Modes modes = modal::modes(system);
  Eigen::VectorXd all(to_index(modes.list.size()));
  for (std::size_t i = 0; i < modes.list.size(); ++i) all(to_index(i)) = modes.list[i].eigenvalue_squared;
  return all;
}

TEST(ForcesAtRest, AreTheSameAboutEveryPole) {
  model::Description d = two_stages(5), moved = d;
  test::RandomSystem random(6);
  for (std::size_t b = 0; b < d.bodies.size(); ++b) {
    const Eigen::Vector3d by = random.vector(0.8);
    model::Body& body = moved.bodies[b];
    body.pose.position += body.pose.rotation * by;
    body.mass.centre -= by;
    for (model::Element& element : moved.elements)
      for (model::End* end : {&element.n, &element.k})
        if (end->body == b) end->at -= by;
    for (model::ConstantForce& force : moved.constant_forces)
      if (force.body == b) force.at -= by;
  }
  EXPECT_THAT(squares(moved), test::NearVector(squares(d), of_modes));
}

TEST(ForcesAtRest, TurnWithTheWorld) {
  model::Description d = two_stages(7), turned = d;
  const Eigen::Matrix3d turn = test::RandomSystem(8).rotation();
  for (model::Body& body : turned.bodies) body.pose = {turn * body.pose.position, turn * body.pose.rotation};
  for (model::Element& element : turned.elements)
    for (model::End* end : {&element.n, &element.k})
      if (end->on_ground()) end->at = turn * end->at, end->axes = turn * end->axes;
  turned.gravity = turn * *d.gravity;
  EXPECT_THAT(squares(turned), test::NearVector(squares(d), of_modes));
}

/// If the ground turns with all bodies, the elements turn their forces with them: only the weights do not.
TEST(ForcesAtRest, LeaveTheWeightWhenAllTurns) {
  model::Description d = two_stages(9);
  d.constant_forces.clear();
  const model::System system = test::checked(d);
  const assembly::Assembled assembled = assembly::assemble(system);
  const Eigen::MatrixXd forces = assembled.ground.K.rightCols<6>();
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(forces.rows(), 6);
  for (std::size_t b = 0; b < d.bodies.size(); ++b) {
    const model::Body& body = d.bodies[b];
    const Eigen::Vector3d weight = body.mass.mass * (body.pose.rotation.transpose() * *d.gravity);
    for (int j = 0; j < 3; ++j) {
      const Eigen::Vector3d by = body.pose.rotation.transpose() * Eigen::Vector3d::Unit(j), held = by.cross(weight);
      expected.block<3, 1>(assembled.layout.row(b, 0), 3 + j) = held;
      expected.block<3, 1>(assembled.layout.row(b, 3), 3 + j) = body.mass.centre.cross(held);
    }
  }
  constexpr double of_weights = 1e-9;  // sums of stiffnesses a thousand times larger
  EXPECT_THAT(forces,
              test::NearInUnitsOf(expected, Eigen::VectorXd::Constant(forces.rows(), 1000),
                                  Eigen::VectorXd::Constant(6, 1), of_weights));
}

}  // namespace forces_at_rest_test
