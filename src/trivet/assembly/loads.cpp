// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/assembly/loads.h"

#include <algorithm>
#include <cassert>
#include <complex>

#include "trivet/foundation/invalid_input.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::assembly {
namespace {

/// Adds a wrench at a point of a body to the generalized forces: X(r)ᵀ w.
template <typename Scalar>
void add_wrench(const Layout& layout, std::size_t body, const Eigen::Vector3d& at,
                const Eigen::Matrix<Scalar, 6, 1>& wrench, Eigen::Matrix<Scalar, Eigen::Dynamic, 1>& load) {
  const Eigen::Matrix<Scalar, 6, 1> at_pole = spatial::rigid_motion(at).transpose().template cast<Scalar>() * wrench;
  for (int j = 0; j < 6; ++j)
    if (layout.row(body, j) >= 0) load(layout.row(body, j)) += at_pole(j);
}

spatial::Vector6 six(const spatial::Wrench& wrench) {
  spatial::Vector6 v;
  v << wrench.force, wrench.moment;
  return v;
}

/// Adds the weight of the element's mass: M times the acceleration of free fall of both ends.
void add_element_weight(const model::System& system, std::size_t index, const Eigen::Vector3d& gravity,
                        const ElementMap& map, Eigen::VectorXd& load) {
  if (map.matrices.mass.isZero(0)) return;
  Eigen::VectorXd fall = Eigen::VectorXd::Zero(map.ends.rows());
  fall.segment<3>(0) = model::end_in_ground(system.bodies(), system.elements()[index].n).rotation.transpose() * gravity;
  fall.segment<3>(6) = model::end_in_ground(system.bodies(), system.elements()[index].k).rotation.transpose() * gravity;
  const Eigen::VectorXd weight = map.ends.transpose() * (map.matrices.mass * fall);
  for (Eigen::Index j = 0; j < weight.size(); ++j) load(map.rows[j]) += weight(j);
}

/// Adds the forces at rest of a preloaded element on its bodies.
/// Forces of an element that are there without a displacement.
void add_preload(const elements::Law& law, const ElementMap& map, Eigen::VectorXd& load) {
  elements::Vector12 on_ends = elements::Vector12::Zero();
  if (law.preload) on_ends += *law.preload;
  if (law.nonlinear) on_ends += law.nonlinear->offset;
  if (law.nonlinear) {
    const Eigen::VectorXd& on_inner = law.nonlinear->inner_offset;
    assert(on_inner.size() <= map.ends.rows() - 12 && "offsets act on the last coordinates inside the element");
    for (Eigen::Index i = 0; i < on_inner.size(); ++i)
      load(map.rows[map.rows.size() - (on_inner.size() - i)]) -= on_inner(i);
  }
  if (on_ends.isZero(0)) return;
  const Eigen::VectorXd on_bodies = -(map.ends.topRows<12>().transpose() * on_ends);
  for (Eigen::Index j = 0; j < on_bodies.size(); ++j) load(map.rows[j]) += on_bodies(j);
}

}  // namespace

Loading loading(const Assembled& assembled, const model::Action& action) {
  Loading result{numerics::Load(assembled.layout.size()), numerics::Load(assembled.ground.size())};
  if (action.body) {
    Eigen::VectorXcd force = Eigen::VectorXcd::Zero(assembled.layout.size());
    add_wrench<std::complex<double>>(assembled.layout, *action.body, action.at, action.amplitude, force);
    result.force.add({0, action.delay, force});
    return result;
  }
  const auto add_motion = [&](double delay, Eigen::Index first, const model::Action::Amplitude& amplitude) {
    Eigen::VectorXcd motion = Eigen::VectorXcd::Zero(assembled.ground.size());
    motion.segment<6>(first) = amplitude;
    result.motion.add({-action.derivative, delay, motion});
  };
  if (action.elements.empty() && !action.wave) {
    // Converts a rigid motion about `at` to the ground origin.
    add_motion(action.delay, 0, spatial::rigid_motion(-action.at).cast<std::complex<double>>() * action.amplitude);
    return result;
  }
  for (const GroundEnd& end : assembled.ground.ends) {
    const bool moves =
        action.elements.empty() || std::ranges::find(action.elements, end.element) != action.elements.end();
    if (!moves) continue;
    const double later = action.wave ? action.wave->direction.dot(end.pose.position) / action.wave->speed : 0;
    add_motion(action.delay + later, end.first_row, action.amplitude);
  }
  return result;
}

Loading harmonic_loading(const model::System& system, const Assembled& assembled,
                         const std::vector<std::string>& selected) {
  Loading total{numerics::Load(assembled.layout.size()), numerics::Load(assembled.ground.size())};
  const auto& excitations = system.description().excitations;
  for (const std::string& name : selected)
    if (std::ranges::none_of(excitations, [&](const model::Excitation& excitation) {
          return excitation.name == name && std::holds_alternative<model::Harmonic>(excitation.course);
        }))
      throw foundation::InvalidInput("\"" + name + "\" is not a harmonic excitation of this model");
  for (const model::Excitation& excitation : excitations) {
    const auto* harmonic = std::get_if<model::Harmonic>(&excitation.course);
    if (!harmonic || !model::is_selected(excitation, selected)) continue;
    const Loading one = loading(assembled, excitation.action);
    const double sign = harmonic->power_of_frequency == 2 ? -1 : 1;  // ω² = −s²
    for (const auto& [from, to] : {std::pair{&one.force, &total.force}, {&one.motion, &total.motion}})
      for (const numerics::LoadTerm& term : from->terms())
        to->add({term.power + harmonic->power_of_frequency, term.delay, sign * term.value});
  }
  return total;
}

numerics::Load right_side(const Assembled& assembled, const Loading& loading) {
  numerics::Load h = loading.force;
  const Ground& ground = assembled.ground;
  Eigen::MatrixXcd stiffness = ground.K.cast<std::complex<double>>();
  if (ground.K_loss.size() > 0) stiffness.imag() = ground.K_loss;
  for (const numerics::LoadTerm& term : loading.motion.terms()) {
    h.add({term.power, term.delay, -(stiffness * term.value)});
    h.add({term.power + 1, term.delay, -(ground.B * term.value)});
    h.add({term.power + 2, term.delay, -(ground.A * term.value)});
  }
  return h;
}

void add_frequency_dependent(const Assembled& assembled, const Loading& loading, std::complex<double> omega,
                             double near, Eigen::VectorXcd& h) {
  assert(h.size() == assembled.layout.before_last() && "coordinates inside frequency-dependent elements have no row");
  if (loading.motion.vanishes()) return;
  const Eigen::VectorXcd g = loading.motion.at(omega);
  for (const ElementMap& map : assembled.elements) {
    if (!map.frequency_dependent() || (map.ground_rows.empty() && !map.resists_following)) continue;
    const elements::Matrix12c stiffness = map.dynamic_stiffness(omega, near);
    const Eigen::VectorXcd moved = map.moved_by_ground(g).head(12);
    const Eigen::VectorXcd force =
        map.ends.topLeftCorner(12, map.end_columns).transpose().cast<std::complex<double>>() * (stiffness * moved);
    for (Eigen::Index j = 0; j < force.size(); ++j) h(map.rows[j]) -= force(j);
  }
}

Eigen::VectorXcd exact_right_side(const Assembled& assembled, const Loading& loading, std::complex<double> omega,
                                  double near) {
  Eigen::VectorXcd h = right_side(assembled, loading).head(assembled.layout.before_last()).at(omega);
  add_frequency_dependent(assembled, loading, omega, near, h);
  return h;
}

Eigen::VectorXd static_load(const model::System& system, const Assembled& assembled) {
  const Layout& layout = assembled.layout;
  Eigen::VectorXd load = Eigen::VectorXd::Zero(layout.size());
  const auto& bodies = system.bodies();
  if (system.description().gravity)
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      spatial::Wrench weight;
      weight.force = bodies[i].mass.mass * (bodies[i].pose.rotation.transpose() * *system.description().gravity);
      add_wrench<double>(layout, i, bodies[i].mass.centre, six(weight), load);
    }
  if (system.description().gravity)
    for (std::size_t e = 0; e < assembled.elements.size(); ++e)
      add_element_weight(system, e, *system.description().gravity, assembled.elements[e], load);
  for (std::size_t e = 0; e < assembled.elements.size(); ++e)
    add_preload(system.elements()[e].law, assembled.elements[e], load);
  return load + constant_load(system, assembled);
}

Eigen::VectorXd constant_load(const model::System& system, const Assembled& assembled) {
  Eigen::VectorXd load = Eigen::VectorXd::Zero(assembled.layout.size());
  for (const model::ConstantForce& force : system.description().constant_forces)
    add_wrench<double>(assembled.layout, force.body, force.at, six(force.wrench), load);
  return load;
}

}  // namespace trivet::assembly
