// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/modal/motion_words.h"
#include "trivet/response/machinery/deflection_shape.h"
#include "trivet/response/machinery/operating_loads.h"
#include "trivet/response/steady/at_rest.h"
#include "trivet/study/analyses/analysis_results.h"
#include "trivet/study/analyses/analysis_run.h"
#include "trivet/study/analyses/operating_levels.h"
#include "trivet/study/analyses/operating_limits.h"
#include "trivet/study/analyses/summed_orders.h"

namespace trivet::study {
namespace {

using assembly::MotionQuantity;

std::vector<std::string> wanted_results(const CaseContext& c, const project::OperationAnalysis& request) {
  if (!request.selection.of.empty()) return request.selection.of;
  std::vector<std::string> words = {"coordinates"};
  for (const model::Body& body : c.system.bodies())
    for (const model::Point& point : body.points) words.push_back(body.name + "." + point.name);
  return words;
}

std::vector<std::string> ground_and_mounts(const CaseContext& c) {
  std::vector<std::string> words = {"ground"};
  for (const std::size_t e : response::mounts(c.system)) words.push_back(c.system.elements()[e].name);
  return words;
}

/// Channels of the analysis: displacements, the same as velocities, then forces.
struct OperatingChannels {
  std::vector<assembly::Channel> list;
  std::size_t motions = 0;
};

OperatingChannels operating_channels(const CaseContext& c, const project::OperationAnalysis& request) {
  const auto channels = [&](const std::vector<std::string>& of, MotionQuantity quantity, bool forces) {
    std::vector<assembly::Channel> found = assembly::channels(c.system, c.assembled, of, quantity);
    std::erase_if(found, [&](const assembly::Channel& one) { return one.unit.starts_with("N") != forces; });
    return found;
  };
  const std::vector<std::string> wanted = wanted_results(c, request);
  OperatingChannels result;
  result.list = channels(wanted, MotionQuantity::displacement, false);
  result.motions = result.list.size();
  std::ranges::move(channels(wanted, MotionQuantity::velocity, false), std::back_inserter(result.list));
  std::vector<assembly::Channel> forces = channels(ground_and_mounts(c), MotionQuantity::displacement, true);
  for (assembly::Channel& one : channels(wanted, MotionQuantity::displacement, true))
    if (std::ranges::find(forces, one.name, &assembly::Channel::name) == forces.end()) forces.push_back(std::move(one));
  std::ranges::move(forces, std::back_inserter(result.list));
  return result;
}

OperatingIsolation isolation_along(const CaseContext& c, const response::OperatingForce& force, std::size_t direction,
                                   const response::Peaks& peaks, const assembly::Band& speed) {
  OperatingIsolation result{.excitation = force.excitation, .order = force.order};
  const model::Direction& along = force.transmission.directions[direction];
  result.direction = (along.rotation ? "about " : "along ") + modal::direction_words(along.axis.normalized());
  result.unit = force.rotation ? "N m" : "N";
  const auto& excitations = c.system.description().excitations;
  const auto excitation = std::ranges::find(excitations, force.excitation, &model::Excitation::name);
  result.reason = response::carried_by_constraint(c.system.bodies()[*excitation->action.body], along);
  if (!result.reason.empty()) return result;
  const auto& [loading, channels] = static_cast<const response::Transmission&>(force.transmission);
  if (speed.from < speed.to) {
    const design::LargestAmplitude largest = design::largest_in_band(
        c.assembled, channels, loading, peaks, direction, {force.order * speed.from, force.order * speed.to});
    result.transmissibility = largest.amplitude;
    result.at = largest.angular_frequency / force.order;
  } else {
    const auto found =
        response::frequency_response(c.assembled, {channels[direction]}, loading, {force.order * speed.from});
    const double size = std::abs(found.curves[0].value(0));
    result.transmissibility = std::isnan(size) ? foundation::infinity : size;
    result.at = speed.from;
  }
  result.exciting = force.exciting(result.at);
  return result;
}

std::vector<OperatingIsolation> isolation_at(const CaseContext& c, const assembly::Band& speed,
                                             const std::vector<std::string>& selected) {
  std::vector<OperatingIsolation> result;
  if (response::mounts(c.system).empty()) return result;  // nothing stands on the ground
  for (const response::OperatingForce& force : response::operating_forces(c.system, c.assembled, speed, selected)) {
    if (!force.reason.empty()) {
      result.push_back({.excitation = force.excitation, .order = force.order, .direction = "", .reason = force.reason});
      continue;
    }
    response::Peaks peaks;
    if (speed.from < speed.to)
      peaks = response::peaks(c.assembled, force.transmission.channels, force.transmission.loading, c.modes, c.roots(),
                              {.search_to = force.order * speed.to}, c.progress);
    for (std::size_t i = 0; i < force.transmission.channels.size(); ++i)
      result.push_back(isolation_along(c, force, i, peaks, speed));
  }
  return result;
}

OperatingMode distance_to(const CaseContext& c, const response::OrderLoading& load, std::size_t mode,
                          const assembly::Band& speed) {
  const modal::Mode& one = c.modes.list[mode];
  OperatingMode result{.mode = one.number, .angular_frequency = *one.angular_frequency, .order = load.order};
  const double resonance = *one.angular_frequency / load.order;  // [rad/s] of the speed
  result.passes = speed.from < speed.to && resonance >= speed.from && resonance <= speed.to;
  result.at = std::clamp(resonance, speed.from, speed.to);
  result.ratio = result.passes ? 1 : result.at / resonance;
  const Eigen::VectorXd forces = modal::modal_forces(c.modes, load.loading.force.at(*one.angular_frequency)).cwiseAbs();
  if (!(forces.squaredNorm() > 0)) return result;
  result.modal_force_share = std::pow(forces(static_cast<Eigen::Index>(mode)), 2) / forces.squaredNorm();
  result.excited = *result.modal_force_share >= response::excited_from;
  return result;
}

std::vector<OperatingMode> distances(const CaseContext& c, const std::vector<response::OrderLoading>& loads,
                                     const assembly::Band& speed) {
  std::vector<OperatingMode> result;
  for (const response::OrderLoading& load : loads)
    for (std::size_t i = 0; i < c.modes.list.size(); ++i)
      if (c.modes.list[i].angular_frequency.value_or(0) > 0) result.push_back(distance_to(c, load, i, speed));
  return result;
}

std::vector<OperatingShape> operating_shapes(const CaseContext& c, const std::vector<response::OrderLoading>& loads,
                                             double speed) {
  std::vector<OperatingShape> result;
  for (const response::OrderLoading& load : loads) {
    try {
      result.push_back(
          {load.order, response::deflection_shape(c.system, c.assembled, load.loading, load.order * speed)});
    } catch (const foundation::NotComputable&) {  // an undamped resonance, which the values of the speed state
    }
  }
  return result;
}

/// "order 1 is at 93 % of mode 6 (17.5 Hz)", "order 1 passes through mode 3 at 612 rpm"
std::string nearness_words(const OperatingMode& mode) {
  if (mode.passes)
    return fmt::format("order {:.6g} passes through mode {} at {:.4g} rpm", mode.order, mode.mode,
                       mode.at * foundation::rpm_per_rad_s);
  return fmt::format("order {:.6g} is at {:.4g} % of mode {} ({:.4g} Hz)", mode.order, 100 * mode.ratio, mode.mode,
                     mode.angular_frequency / foundation::two_pi);
}

/// One warning for each speed: excitations near to the natural frequencies that they excite, the nearest first.
void warn_of_resonance(const OperatingSpeed& at, foundation::Problems& warnings) {
  constexpr std::size_t most = 5;
  std::vector<OperatingMode> near;
  for (const OperatingMode& mode : at.modes)
    if (mode.excited && mode.is_near()) near.push_back(mode);
  if (near.empty()) return;
  std::ranges::stable_sort(near, is_nearer);
  std::vector<std::string> words;
  for (std::size_t i = 0; i < std::min(most, near.size()); ++i) words.push_back(nearness_words(near[i]));
  if (near.size() > most) words.push_back(fmt::format("and {} more", near.size() - most));
  warnings.warning("operation", fmt::format("{}: {}", speed_words(at.speed), fmt::join(words, "; ")),
                   fmt::format("an excitation within {:.0f} % of a natural frequency that it excites is near to "
                               "resonance",
                               100 * near_resonance),
                   "look at the amplitudes there; change the speed, the mounts or the mass if they are too large");
}

/// A range that begins below the data of an element is computed from there on.
void warn_of_cut_range(const SummedOrders& summed, const assembly::Band& speed, foundation::Problems& warnings) {
  constexpr double rounding = 1e-9;
  const double from = summed.begin(speed);
  if (from <= speed.from * (1 + rounding)) return;
  warnings.warning(
      "operation",
      fmt::format("{} is computed from {:.5g} rpm on", speed_words(speed), from * foundation::rpm_per_rad_s),
      "below it an order is slower than the first frequency at which an element is known",
      "begin the range there, or give the element at lower frequencies");
}

/// Adds the results at the one speed of the request, or over its one range.
void add_speed(const CaseContext& c, const project::OperationAnalysis& request,
               const std::vector<response::OrderLoading>& loads, const OperatingChannels& channels,
               OperationResult& result, foundation::Problems& warnings) {
  const assembly::Band& speed = request.speeds.front();
  const SummedOrders summed(c, channels.list, loads, fastest_range(request.speeds));
  OperatingSpeed at;
  at.speed = speed;
  const std::vector<OperatingValue> values = summed.largest(speed);
  for (std::size_t i = 0; i < channels.motions; ++i) at.motions.push_back({values[i], values[channels.motions + i]});
  at.forces.assign(values.begin() + static_cast<std::ptrdiff_t>(2 * channels.motions), values.end());
  at.isolation = isolation_at(c, speed, request.selection.excitations);
  at.modes = distances(c, loads, speed);
  if (!at.is_range()) at.shapes = operating_shapes(c, loads, speed.from);
  at.limits = std::move(operating_limits(c, request, loads).front());
  if (request.bands) {
    const auto velocities = channels.list.begin() + static_cast<std::ptrdiff_t>(channels.motions);
    const std::vector<OperatingLevel> levels = operating_levels(c, request, loads, {velocities, channels.list.end()});
    std::ranges::move(operating_lines(request, levels), std::back_inserter(result.lines));
    result.levels.insert(result.levels.end(), levels.begin(), levels.end());
  }
  warn_of_cut_range(summed, speed, warnings);
  warn_of_resonance(at, warnings);
  result.speeds.push_back(std::move(at));
}

}  // namespace

std::string speed_words(const assembly::Band& speed) {
  constexpr double rpm = foundation::rpm_per_rad_s;
  return speed.from < speed.to ? fmt::format("{:.5g} … {:.5g} rpm", speed.from * rpm, speed.to * rpm)
                               : fmt::format("{:.5g} rpm", speed.to * rpm);
}

OperationResult operation_result(const CaseContext& c, const project::OperationAnalysis& request,
                                 foundation::Problems& warnings) {
  const std::vector<std::string>& selected = request.selection.excitations;
  const std::vector<response::OrderLoading> loads = response::operating_loads(c.system, c.assembled, selected);
  if (loads.empty())
    throw foundation::NotComputable(
        "operation: no excitation runs at a speed, or all of them are zero; add [excitations.NAME] with type = "
        "\"unbalance\", \"orders\" or \"harmonic\" on a body");
  OperationResult result;
  for (const response::OrderLoading& load : loads) {
    result.orders.push_back(load.order);
    for (const std::string& name : load.excitations)
      if (std::ranges::find(result.excitations, name) == result.excitations.end()) result.excitations.push_back(name);
  }
  const OperatingChannels channels = operating_channels(c, request);
  std::optional<foundation::NotComputable> first_reason;
  for (const assembly::Band& speed : request.speeds) {
    try {
      add_speed(c, at_speed(request, speed), loads, channels, result, warnings);
    } catch (const foundation::NotComputable& reason) {
      if (!first_reason) first_reason = reason;
      warnings.warning("operation", speed_words(speed) + " is not computed", reason.what(),
                       "the other speeds are computed; remove this one, or extend the data of the element");
    }
  }
  if (result.speeds.empty()) throw *first_reason;
  return result;
}

const AnalysisRun operation_run = computed_by<&project::Analyses::operation, &CaseResults::operation, operation_result>(
    "vibration, forces, isolation and distance to resonance at the speeds of the machine",
    "operation: no speed given; add [operation] with speeds = [\"980 rpm\"] to the file, or give a speed with the "
    "key at");

}  // namespace trivet::study
