// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/explain/linear_system.h"

#include <fmt/format.h>

#include <array>

#include "trivet/assembly/loads.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/project/analyses/drive.h"
#include "trivet/response/transient/state_space.h"
#include "trivet/response/transient/transient_record.h"
#include "trivet/response/transient/transient_refusals.h"

namespace trivet::study {

namespace {

void name_block(const std::string& owner, Eigen::Index first, Eigen::Index count, std::vector<std::string>& names) {
  for (Eigen::Index i = 0; i < count; ++i) names[first + i] = fmt::format("{}.coordinate {}", owner, i + 1);
}

}  // namespace

std::vector<std::string> row_names(const model::System& system, const assembly::Assembled& assembled) {
  const assembly::Layout& layout = assembled.layout;
  const model::Description& parts = system.description();
  std::vector<std::string> names(to_size(layout.size()));
  for (std::size_t b = 0; b < parts.bodies.size(); ++b)
    for (int j = 0; j < 6; ++j)
      if (layout.row(b, j) >= 0) names[layout.row(b, j)] = parts.bodies[b].name + "." + model::coordinate_names[j];
  for (std::size_t f = 0; f < parts.foundations.size(); ++f)
    name_block(parts.foundations[f].name, layout.foundation_row(f), parts.foundations[f].mass.rows(), names);
  constexpr Eigen::Index of_ends = 12;
  for (std::size_t e = 0; e < parts.elements.size(); ++e)
    name_block(parts.elements[e].name, layout.internal_row(e), assembled.elements[e].ends.rows() - of_ends, names);
  return names;
}

std::vector<std::string> row_units(const model::System& system, const assembly::Assembled& assembled) {
  std::vector<std::string> units(to_size(assembled.layout.size()), "1");
  for (std::size_t b = 0; b < system.bodies().size(); ++b)
    for (int j = 0; j < 6; ++j)
      if (const Eigen::Index row = assembled.layout.row(b, j); row >= 0) units[row] = j < 3 ? "m" : "rad";
  return units;
}

SystemMatrices system_matrices(const project::Case& variant) {
  const assembly::Assembled assembled = assembly::assemble(variant.system);
  SystemMatrices found;
  found.coordinates = row_names(variant.system, assembled);
  found.units = row_units(variant.system, assembled);
  found.matrices = assembled.matrices;
  found.exact = !assembled.frequency_dependent();
  found.load = numerics::Load(assembled.layout.size());
  if (project::is_driven(variant.system, project::Drive::harmonic))
    found.load = assembly::right_side(assembled, assembly::harmonic_loading(variant.system, assembled));
  return found;
}

namespace {

using response::Drive;
using response::InputMatrix;

/// One direction of one excitation: its loads per unit, and the names of it and of its derivatives.
struct Port {
  std::string name, unit;
  bool motion = false;
  Drive drive;
};

/// Components in which an excitation acts at any time.
std::array<bool, 6> directions(const model::Excitation& excitation) {
  std::array<bool, 6> acts{};
  const auto add = [&](const auto& amplitude) {
    for (int j = 0; j < 6; ++j) acts[j] = acts[j] || amplitude(j) != std::complex<double>(0);
  };
  if (const auto* orders = std::get_if<model::Orders>(&excitation.course)) {
    for (const excitation::Order& order : orders->list) {
      add(order.per_speed_squared);
      add(order.fixed);
    }
  } else {
    add(excitation.action.amplitude);
  }
  return acts;
}

Port port(const assembly::Assembled& assembled, const model::Excitation& excitation, int direction) {
  const char* const axis = model::coordinate_names[direction];
  Port found;
  found.motion = !excitation.action.body;
  if (found.motion) {
    found.name = fmt::format("{}.{}", excitation.name, axis);
    found.unit = direction < 3 ? "m" : "rad";
  } else {
    found.name = fmt::format("{}.{}.{}", excitation.name, direction < 3 ? "force" : "moment",
                             model::coordinate_names[direction % 3]);
    found.unit = direction < 3 ? "N" : "N m";
  }
  model::Action unit = excitation.action;
  unit.amplitude = model::Action::Amplitude::Unit(direction);
  unit.delay = 0;
  unit.derivative = 0;
  const assembly::Loading loading = assembly::loading(assembled, unit);
  found.drive = {InputMatrix::Zero(assembled.layout.size(), 5), InputMatrix::Zero(assembled.ground.size(), 5)};
  const numerics::Load force = assembly::right_side(assembled, loading);
  for (const numerics::LoadTerm& term : force.terms())
    found.drive.force.col(response::of_value + term.power) += term.value.real();
  for (const numerics::LoadTerm& term : loading.motion.terms())
    found.drive.ground.col(response::of_value + term.power) += term.value.real();
  return found;
}

std::vector<Port> ports(const project::Case& variant, const assembly::Assembled& assembled) {
  std::vector<Port> all;
  for (const model::Excitation& excitation : variant.system.description().excitations) {
    if (excitation.action.wave)
      throw foundation::NotComputable(fmt::format(
          "excitations.{}: a travelling wave reaches the ground points with different delays, which a state space does "
          "not have; take an excitation without wave",
          excitation.name));
    const std::array<bool, 6> acts = directions(excitation);
    for (int j = 0; j < 6; ++j)
      if (acts[j]) all.push_back(port(assembled, excitation, j));
  }
  return all;
}

/// "m" → "m/s", "m/s2", …
std::string unit_of_derivative(const std::string& unit, Eigen::Index order) {
  return order == 0 ? unit : order == 1 ? unit + "/s" : fmt::format("{}/s{}", unit, order);
}

std::string name_of_derivative(const Port& port, Eigen::Index order) {
  if (order == 0) return port.name;
  if (port.motion && order <= 2) return port.name + (order == 1 ? ".velocity" : ".acceleration");
  return fmt::format("{}.derivative{}", port.name, order);
}

/// Adds the input columns of one port: itself, and the derivatives that act.
void add_inputs(const Port& port, const InputMatrix& on_states, const Eigen::MatrixXd& on_outputs,
                LinearSystem& system) {
  constexpr Eigen::Index orders = response::input_derivatives - response::of_value;
  for (Eigen::Index order = 0; order < orders; ++order) {
    const Eigen::Index column = response::of_value + order;
    Eigen::VectorXd b = Eigen::VectorXd::Zero(system.A.rows());
    if (column < on_states.cols()) b = on_states.col(column);
    const Eigen::VectorXd d = on_outputs.col(column);
    if (order > 0 && b.isZero(0) && d.isZero(0)) continue;
    system.inputs.push_back({name_of_derivative(port, order), unit_of_derivative(port.unit, order)});
    system.B.conservativeResize(b.size(), system.B.cols() + 1);
    system.D.conservativeResize(d.size(), system.D.cols() + 1);
    system.B.rightCols(1) = b;
    system.D.rightCols(1) = d;
  }
}

constexpr double typical_displacement = 1e-3, typical_velocity = 0.1;  // [m], [rad]; [m/s], [rad/s]

/// States q and q̇ in place of others, where all coordinates have mass.
void take_physical_states(const response::StateSpace& space, const std::vector<Signal>& coordinates,
                          LinearSystem& system) {
  const Eigen::Index n = to_index(coordinates.size());
  if (space.size() != 2 * n) {
    for (Eigen::Index i = 0; i < space.size(); ++i) system.states.push_back({fmt::format("state {}", i + 1), ""});
    return;
  }
  Eigen::MatrixXd to_states(2 * n, 2 * n);
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    to_states.col(i) = space.state(Eigen::VectorXd::Unit(n, i), none);
    to_states.col(n + i) = space.state(none, Eigen::VectorXd::Unit(n, i));
  }
  const numerics::PivotedLu<double> lu(to_states);
  system.A = lu.solve(Eigen::MatrixXd(system.A * to_states));
  system.A.topRows(n).setZero();
  system.A.topRightCorner(n, n).setIdentity();  // exactly
  if (system.B.cols() > 0) system.B = lu.solve(system.B);
  system.C = system.C * to_states;
  for (const bool velocity : {false, true})
    for (Eigen::Index i = 0; i < n; ++i) {
      const std::string &name = coordinates[i].name, &unit = coordinates[i].unit;
      if (velocity)
        system.states.push_back({name + ".velocity", unit.empty() ? "1/s" : unit + "/s", "", typical_velocity});
      else system.states.push_back({name, unit, "", typical_displacement});
    }
}

}  // namespace

LinearSystem linear_system(const project::Case& variant, const std::vector<std::string>& of,
                           assembly::MotionQuantity quantity, bool nearest) {
  assembly::Assembled assembled = assembly::assemble(variant.system);
  if (const auto reason = response::without_motion_in_time(variant.system, assembled, {}, nearest))
    throw foundation::NotComputable(
        fmt::format("state space: {}; {}; {}", reason->finding, reason->rule, reason->remedy));
  std::vector<assembly::Channel> channels = assembly::channels(variant.system, assembled, of, quantity);
  LinearSystem system;
  if (assembled.frequency_dependent()) {
    system.warnings.warning("elements", "frequency-dependent elements",
                            "their nearest linear system takes their place; it is not exact",
                            "compare it with the response");
    for (assembly::Channel& channel : channels) channel = response::nearest_linear(assembled, channel);
    assembled = response::nearest_linear(assembled);
  }
  const std::vector<Port> all = ports(variant, assembled);
  std::vector<Drive> drives;
  for (const Port& port : all) drives.push_back(port.drive);
  const response::StateSpace space(assembled.matrices, drives);
  const response::LinearRows rows = response::channel_rows(space, channels, drives);
  system.A = space.F();
  system.C = rows.on_state;
  system.B.resize(space.size(), 0);
  system.D.resize(rows.on_state.rows(), 0);
  for (std::size_t c = 0; c < all.size(); ++c)
    add_inputs(all[c], space.G(c),
               rows.on_input.middleCols(to_index(c) * response::input_derivatives, response::input_derivatives),
               system);
  for (const assembly::Channel& channel : channels)
    system.outputs.push_back({channel.name, channel.unit == "1" ? "" : channel.unit});
  const std::vector<std::string> names = row_names(variant.system, assembled),
                                 units = row_units(variant.system, assembled);
  std::vector<Signal> coordinates;
  for (std::size_t i = 0; i < names.size(); ++i) coordinates.push_back({names[i], units[i] == "1" ? "" : units[i]});
  take_physical_states(space, coordinates, system);
  return system;
}

}  // namespace trivet::study
