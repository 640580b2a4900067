// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/transient/transient_refusals.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "trivet/assembly/following.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/generalized_modes.h"
#include "trivet/numerics/linalg/massless.h"

namespace trivet::response {
namespace {

/// Natural frequency of the mode with the largest static strain energy under the loads; without loads, of the slowest
/// that oscillates; 0 if none.
double dominant_frequency(const assembly::Assembled& assembled, const std::vector<TimeInput>& inputs) {
  const numerics::MassiveSystem massive = numerics::massive_system(assembled.matrices);
  const numerics::GeneralizedModes modes =
      numerics::generalized_modes(massive.K, massive.A, assembled.matrices.symmetric);
  double best = -1, omega = 0;
  for (Eigen::Index i = 0; i < modes.lambda.size(); ++i) {
    if (!(modes.lambda(i) > 0)) continue;
    const Eigen::VectorXd shape = massive.recovery * modes.shapes.col(i);
    double energy = 0;
    for (const TimeInput& input : inputs) {
      for (const numerics::LoadTerm& term : input.loading.force.terms())
        energy += std::pow(shape.dot(term.value.real()), 2) / modes.lambda(i);
      for (const numerics::LoadTerm& term : input.loading.motion.terms())
        energy += std::pow(shape.dot(assembled.ground.K * term.value.real()), 2) / modes.lambda(i);
    }
    if (energy > best) best = energy, omega = std::sqrt(modes.lambda(i));
  }
  return omega;
}

/// Text for the project file that replaces the law of an element by one with constant matrices.
std::string constant_law(const model::Element& element) {
  const std::string path = "elements.\"" + element.name + "\"";
  if (element.type == "coil_spring") return path + ".level = \"with_mass\"";
  const auto* law = std::get_if<elements::Viscoelastic>(&element.law.damping);
  if (law && std::holds_alternative<elements::FractionalZener>(*law))
    return path + ".damping = {zener = {ratio, time}} or {maxwell = {ratios, times}}";
  return "";
}

/// The Zener law with its largest loss factor η at ω, and the stiffness of the element there.
std::string zener_offer(double eta, double omega) {
  const double ratio = 2 * eta * (eta + std::hypot(eta, 1.0));
  return fmt::format("damping = {{zener = {{ratio = {:.4g}, time = \"{:.4g} s\"}}}} with scale {:.4g}", ratio,
                     1 / (omega * std::sqrt(1 + ratio)), (2 + ratio) / (2 + 2 * ratio));
}

}  // namespace

std::vector<TimeInput> time_inputs(const model::System& system, const assembly::Assembled& assembled,
                                   const std::vector<std::string>& names) {
  std::vector<TimeInput> inputs;
  for (const model::Excitation& excitation : system.description().excitations)
    if (const auto* history = std::get_if<model::History>(&excitation.course);
        history && model::is_selected(excitation, names))
      inputs.push_back({excitation.name, history->signal, assembly::loading(assembled, excitation.action)});
  return inputs;
}

std::optional<foundation::Problem> without_motion_in_time(const model::System& system,
                                                          const assembly::Assembled& assembled,
                                                          const std::vector<TimeInput>& inputs,
                                                          bool nearest_linear_system) {
  std::string dependent, laws;
  std::map<double, std::string> lossy;  // names by loss factor
  for (std::size_t e = 0; e < assembled.elements.size(); ++e) {
    const std::string& name = system.elements()[e].name;
    const auto list = [&](std::string& names) { names += (names.empty() ? "\"" : ", \"") + name + "\""; };
    if (const double eta = assembled.elements[e].matrices.loss_factor; eta > 0) list(lossy[eta]);
    if (!assembled.elements[e].frequency_dependent()) continue;
    list(dependent);
    if (const std::string law = constant_law(system.elements()[e]); !law.empty()) laws += ", or " + law;
  }
  if (!lossy.empty()) {
    const double omega = dominant_frequency(assembled, inputs);
    std::string factors, offers;
    for (const auto& [eta, names] : lossy) {
      factors += fmt::format("{}loss factor {:.4g} of {}", factors.empty() ? "" : ", ", eta, names);
      if (omega > 0)
        offers += fmt::format("; for {:.4g}: damping = {{proportional = \"{:.4g} s\"}}, or {}", eta, eta / omega,
                              zener_offer(eta, omega));
    }
    return foundation::Problem{
        .subject = "transient",
        .finding = factors,
        .rule = "a loss factor is defined for steady harmonic motion only; in time it would respond before its cause",
        .remedy = omega > 0
            ? fmt::format(
                  "replace `damping` of these elements by an equivalent with the same stiffness and loss at one "
                  "frequency, here that of the mode most excited by the inputs, {:.4g} Hz{}",
                  omega / (2 * std::numbers::pi), offers)
            : "replace `damping` of these elements by an equivalent: damping = {proportional = …}, or {zener = {ratio, "
              "time}}"};
  }
  if (!dependent.empty() && !nearest_linear_system)
    return foundation::Problem{
        .subject = "transient",
        .finding = dependent,
        .rule =
            "constant matrices cannot represent the frequency-dependent stiffness, so there is no exact time history",
        .remedy = "use the nearest linear system by nearest_linear_system = true in analyses.transient" + laws};
  return std::nullopt;
}

void require_constant_coefficients(const model::System& system, const assembly::Assembled& assembled,
                                   const std::vector<TimeInput>& inputs, bool nearest_linear_system) {
  if (const auto problem = without_motion_in_time(system, assembled, inputs, nearest_linear_system))
    throw foundation::NotComputable(
        fmt::format("{}: {}; {}; {}", problem->subject, problem->finding, problem->rule, problem->remedy));
}

assembly::Assembled nearest_linear(const assembly::Assembled& assembled) {
  assembly::Assembled result = assembled;
  for (const assembly::ElementMap& map : assembled.elements) {
    if (!map.frequency_dependent()) continue;
    const auto couple = [&](const Eigen::MatrixXd& matrix, Eigen::MatrixXd& ground) {
      const Eigen::MatrixXd local = map.ends.transpose() * matrix * map.ground_ends;
      for (Eigen::Index i = 0; i < local.rows(); ++i)
        for (Eigen::Index j = 0; j < local.cols(); ++j) ground(map.rows[i], map.ground_rows[j]) += local(i, j);
    };
    couple(map.matrices.stiffness, result.ground.K);
    couple(map.matrices.damping, result.ground.B);
    couple(map.matrices.mass, result.ground.A);
    const assembly::FollowedForces followed = assembly::followed_forces(map, assembled.ground);
    const auto couple_followed = [&](const Eigen::MatrixXd& force, Eigen::MatrixXd& ground) {
      const Eigen::MatrixXd local = map.ends.transpose() * force;
      for (Eigen::Index i = 0; i < local.rows(); ++i)
        ground.rightCols(assembled.ground.followed()).row(map.rows[i]) += local.row(i);
    };
    couple_followed(followed.stiffness, result.ground.K);
    couple_followed(followed.damping, result.ground.B);
  }
  for (Eigen::Index j = 0; j < assembled.ground.followed(); ++j)
    if (!assembled.ground.rigid(j))
      result.ground.K.col(assembled.ground.followed_row() + j).setZero();  // by the choice of R
  result.ground.A.rightCols(assembled.ground.followed()) =
      assembled.matrices.A * assembled.ground.R + result.ground.gathered(result.ground.A);
  return result;
}

assembly::Channel nearest_linear(const assembly::Assembled& assembled, assembly::Channel channel) {
  const Eigen::Index ground = assembled.ground.size();
  for (const assembly::DynamicForce& force : channel.dynamic_forces) {
    const assembly::ElementMap& map = assembled.elements[force.element];
    const auto on_ends = [&](const Eigen::MatrixXd& matrix) -> Eigen::RowVectorXd {
      return force.row * matrix.topRows<12>();
    };
    const Eigen::RowVectorXd k = on_ends(map.matrices.stiffness), b = on_ends(map.matrices.damping),
                             a = on_ends(map.matrices.mass);
    for (Eigen::Index j = 0; j < map.ends.cols(); ++j) {
      const Eigen::Index row = map.rows[j];
      channel.on_displacement(row) += k.dot(map.ends.col(j));
      channel.on_velocity(row) += b.dot(map.ends.col(j));
      channel.on_acceleration(row) += a.dot(map.ends.col(j));
    }
    if (channel.ground.empty())
      channel.ground = {Eigen::VectorXcd::Zero(ground), Eigen::VectorXd::Zero(ground), Eigen::VectorXd::Zero(ground)};
    for (Eigen::Index j = 0; j < map.ground_ends.cols(); ++j) {
      const Eigen::Index row = map.ground_rows[j];
      channel.ground.on_displacement(row) += k.dot(map.ground_ends.col(j));
      channel.ground.on_velocity(row) += b.dot(map.ground_ends.col(j));
      channel.ground.on_acceleration(row) += a.dot(map.ground_ends.col(j));
    }
    const assembly::FollowedForces followed = assembly::followed_forces(map, assembled.ground);
    channel.ground.on_displacement.tail(assembled.ground.followed()) +=
        (force.row * followed.stiffness.topRows(12)).transpose().cast<std::complex<double>>();
    channel.ground.on_velocity.tail(assembled.ground.followed()) +=
        (force.row * followed.damping.topRows(12)).transpose();
    channel.ground.on_acceleration.tail(assembled.ground.followed()) +=
        (force.row * followed.mass.topRows(12)).transpose();
  }
  channel.dynamic_forces.clear();
  return channel;
}

}  // namespace trivet::response
