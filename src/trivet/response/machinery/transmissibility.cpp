// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/machinery/transmissibility.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <variant>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/response/steady/at_rest.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::response {
namespace {

using Complex = std::complex<double>;
using Amplitude = model::Action::Amplitude;

using foundation::infinity;

/// Components x … z or rx … rz of a unit vector along the direction, in axes rotated by `rotation` relative to the
/// ground.
spatial::Vector6 unit_six(const model::Direction& direction, const Eigen::Matrix3d& rotation) {
  const double length = direction.axis.norm();
  if (!(length > 0 && std::isfinite(length)))
    throw foundation::InvalidInput("transmissibility: a direction needs a finite length > 0");
  spatial::Vector6 six = spatial::Vector6::Zero();
  six.segment<3>(direction.rotation ? 3 : 0) = rotation.transpose() * direction.axis / length;
  return six;
}

model::Direction checked_direction(const model::Direction& applied, const std::optional<model::Direction>& wanted,
                                   const char* translation, const char* rotation) {
  if (wanted && wanted->rotation != applied.rotation)
    throw foundation::InvalidInput(
        fmt::format("transmissibility: a {} over a {} has the unit {}, not 1; use the same kind for both",
                    wanted->rotation ? rotation : translation, applied.rotation ? rotation : translation,
                    wanted->rotation == (std::string(translation) == "force") ? "m" : "1/m"));
  return wanted.value_or(applied);
}

/// Index 0 … 5 of the component at the end of a channel name: "…x" or "…rz", "….force.x" or "….moment.z".
Eigen::Index component(const std::string& name, bool of_force) {
  const std::string last = name.substr(name.rfind('.') + 1);
  for (std::size_t j = 0; j < 6; ++j)
    if (last == model::coordinate_names[j])
      return to_index(j) + (of_force && name.ends_with(".moment." + last) ? 3 : 0);
  return 0;
}

/// Σ weight · channel over the components of one name.
assembly::Channel combined(const std::vector<assembly::Channel>& parts, const spatial::Vector6& weights,
                           const std::string& name) {
  assembly::Channel sum{{Eigen::VectorXcd::Zero(parts.front().on_displacement.size()),
                         Eigen::VectorXd::Zero(parts.front().on_velocity.size()),
                         Eigen::VectorXd::Zero(parts.front().on_acceleration.size())},
                        name,
                        "1",
                        0,
                        {},
                        {},
                        0};
  for (const assembly::Channel& part : parts) {
    const double weight = weights(component(part.name, part.unit.starts_with("N")));
    if (weight == 0) continue;
    sum.on_displacement += weight * part.on_displacement;
    sum.on_velocity += weight * part.on_velocity;
    sum.on_acceleration += weight * part.on_acceleration;
    for (const assembly::DynamicForce& force : part.dynamic_forces)
      sum.dynamic_forces.push_back({force.element, weight * force.row});
    if (part.ground.empty()) continue;
    const Eigen::Index size = part.ground.on_displacement.size();
    if (sum.ground.empty())
      sum.ground = {Eigen::VectorXcd::Zero(size), Eigen::VectorXd::Zero(size), Eigen::VectorXd::Zero(size)};
    sum.ground.on_displacement += weight * part.ground.on_displacement;
    sum.ground.on_velocity += weight * part.ground.on_velocity;
    sum.ground.on_acceleration += weight * part.ground.on_acceleration;
  }
  return sum;
}

/// Body of a name BODY or BODY.POINT.
const model::Body& body_of(const model::System& system, const std::string& word) {
  for (const model::Body& body : system.bodies()) {
    if (word == body.name) return body;
    for (const model::Point& point : body.points)
      if (word == body.name + "." + point.name) return body;
  }
  throw foundation::InvalidInput("transmissibility: \"" + word + "\" is not a body or BODY.POINT of this model");
}

/// Unit vectors along the axes of the ellipse Re(vector e^{iωt}), the larger one first; of a circle, see
/// spatial::axes_along.
std::vector<Eigen::Vector3d> axes_of_ellipse(const Eigen::Vector3cd& vector) {
  const Complex square = (vector.array() * vector.array()).sum();
  constexpr double round = 1e-9;  // of a circle, whose axes are arbitrary
  if (std::abs(square) > round * vector.squaredNorm()) {
    const Eigen::Vector3cd turned = vector * std::exp(Complex(0, -0.5 * std::arg(square)));
    return {turned.real().normalized(), turned.imag().normalized()};
  }
  const Eigen::Vector3d real = vector.real(), imaginary = vector.imag();
  const Eigen::Matrix3d axes = spatial::axes_along(real.cross(imaginary));
  return {axes.col(0), axes.col(1)};
}

/// |T| this close to 1 counts as 1: at ω = 0, and for ω → ∞ where a relative motion tends to 1.
constexpr double like_one = 1e-9;

/// Root of |T| = 1 between `above` (|T| > 1) and `below` (|T| ≤ 1), where |T| is monotonic.
template <typename Size>
double root_between(double above, double below, const Size& size) {
  constexpr int most_steps = 200;
  for (int step = 0; step < most_steps; ++step) {
    const double middle = above > 0 && below > 2 * above ? std::sqrt(above * below) : 0.5 * (above + below);
    if (!(middle > above && middle < below)) break;
    (size(middle) > 1 ? above : below) = middle;
  }
  return 0.5 * (above + below);
}

}  // namespace

Transmission force_transmission(const model::System& system, const assembly::Assembled& assembled,
                                const model::AppliedForce& applied,
                                const std::optional<model::Direction>& transmitted) {
  const model::Direction out = checked_direction(applied.direction, transmitted, "force", "moment");
  if (applied.body >= system.bodies().size())
    throw foundation::InvalidInput("transmissibility: the force does not act on a body of this model");
  model::Action action;
  action.body = applied.body;
  action.at = applied.at;
  action.amplitude = unit_six(applied.direction, system.bodies()[applied.body].pose.rotation).cast<Complex>();
  Transmission result{assembly::loading(assembled, action), {}};
  std::vector<std::string> words = {"ground"};
  for (const std::size_t e : mounts(system)) words.push_back(system.elements()[e].name);
  for (const std::string& word : words)
    result.channels.push_back(
        combined(assembly::channels(system, assembled, {word}, assembly::MotionQuantity::displacement),
                 unit_six(out, Eigen::Matrix3d::Identity()), word));
  return result;
}

ExcitationTransmission excitation_transmission(const model::System& system, const assembly::Assembled& assembled,
                                               const std::string& excitation) {
  return excitation_transmission(system, assembled, model::harmonic_force(system, excitation));
}

ExcitationTransmission excitation_transmission(const model::System& system, const assembly::Assembled& assembled,
                                               const model::HarmonicForce& force) {
  const Eigen::Matrix3d& to_ground = system.bodies()[*force.action.body].pose.rotation;
  std::vector<Eigen::Vector3d> axes = {(to_ground * force.in_phase_with_largest().real()).normalized()};
  if (force.rotates()) axes = axes_of_ellipse(to_ground.cast<Complex>() * force.vector);
  double largest = 0;  // magnitude over a period
  for (Eigen::Vector3d& axis : axes) {
    Eigen::Index at = 0;
    axis.cwiseAbs().maxCoeff(&at);
    if (axis(at) < 0) axis = -axis;
    largest =
        std::max(largest, std::abs((to_ground.transpose() * axis).cast<Complex>().cwiseProduct(force.vector).sum()));
  }
  model::Action action;
  action.body = force.action.body;
  action.at = force.action.at;
  action.amplitude.segment<3>(force.rotation ? 3 : 0) = force.vector / largest;
  ExcitationTransmission result{{assembly::loading(assembled, action), {}}, {}, largest};
  const auto ground = assembly::channels(system, assembled, {"ground"}, assembly::MotionQuantity::displacement);
  for (const Eigen::Vector3d& axis : axes) {
    result.directions.push_back({axis, force.rotation});
    result.channels.push_back(
        combined(ground, unit_six(result.directions.back(), Eigen::Matrix3d::Identity()), "ground"));
  }
  return result;
}

std::string carried_by_constraint(const model::Body& body, const model::Direction& along) {
  constexpr double round_off = 1e-9;
  const Eigen::Vector3d axis = body.pose.rotation.transpose() * along.axis.normalized();
  for (Eigen::Index i = 0; i < 3; ++i)
    if (std::abs(axis(i)) > round_off && body.is_constrained(to_size(i) + (along.rotation ? 3 : 0)))
      return fmt::format(
          "\"{}\" is not free {} {}: its constraint carries this force to the ground, and forces of constraints are "
          "not "
          "computed; add the direction to `free` and hold it by elements",
          body.name, along.rotation ? "about" : "along", "xyz"[i]);
  return "";
}

Transmission displacement_transmission(const model::System& system, const assembly::Assembled& assembled,
                                       const std::vector<std::string>& of, const model::Direction& moved,
                                       const std::optional<model::Direction>& moved_direction,
                                       const Eigen::Vector3d& base_at) {
  const model::Direction out = checked_direction(moved, moved_direction, "translation", "rotation");
  model::Action action;
  action.at = base_at;
  action.amplitude = unit_six(moved, Eigen::Matrix3d::Identity()).cast<Complex>();
  Transmission result{assembly::loading(assembled, action), {}};
  for (const std::string& word : of) {
    const model::Body& body = body_of(system, word);
    const auto parts = assembly::channels(system, assembled, {word}, assembly::MotionQuantity::displacement);
    result.channels.push_back(combined(parts, unit_six(out, body.pose.rotation), word));
  }
  return result;
}

std::vector<Crossover> crossovers(const assembly::Assembled& assembled, const Transmission& transmission,
                                  const Peaks& peaks) {
  constexpr double far_above =
      1e6;  // beyond the last extremum a curve is monotonic: this factor above it shows whether it exceeds 1
  std::vector<Crossover> result;
  for (std::size_t c = 0; c < transmission.channels.size(); ++c) {
    const auto size = [&](double omega) {
      return std::abs(
          frequency_response(assembled, {transmission.channels[c]}, transmission.loading, {omega}).curves[0].value(0));
    };
    Crossover& crossover = result.emplace_back(Crossover{transmission.channels[c].name, 0.0, peaks.searched_to});
    if (peaks.curves[c].vanishes) continue;
    std::vector<std::pair<double, double>> places = {{peaks.searched_from, size(peaks.searched_from)}};
    for (const Extremum& t : peaks.turnings[c]) places.emplace_back(t.angular_frequency, t.amplitude);
    double far = peaks.searched_to;
    if (std::isinf(far)) far = far_above * std::max({places.back().first, peaks.searched_from, 1.0});
    places.emplace_back(far, size(far));
    const auto last =
        std::find_if(places.rbegin(), places.rend(), [](const auto& place) { return place.second > 1 + like_one; });
    if (!(places.back().second < 1 - like_one)) crossover.angular_frequency.reset();
    else if (last != places.rend())
      crossover.angular_frequency = root_between(last->first, std::prev(last)->first, size);
  }
  return result;
}

double transmissibility_level(double transmissibility) {
  return transmissibility == 0 ? -infinity : 20 * std::log10(std::abs(transmissibility));
}

double isolation_level(double transmissibility) {
  return 0.0 - transmissibility_level(transmissibility);  // no −0 for T = 1
}

double isolation_efficiency(double transmissibility) { return 1 - std::abs(transmissibility); }

}  // namespace trivet::response
