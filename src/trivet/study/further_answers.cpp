// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/further_answers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "trivet/assembly/loads.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/model/modal_ground.h"

namespace trivet::study {
namespace {

constexpr double default_band_factor = 1.3;

bool selected(const std::vector<std::string>& names, const std::string& name) {
  return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<assembly::Channel> channels_of(const CaseContext& c, const project::Wanted& wanted) {
  return assembly::channels(c.system, c.assembled, wanted.of, wanted.quantity);
}

/// A band for curves of forces over frequency: from 0 or from where tables begin.
std::vector<double> grid_over(const CaseContext& c, const std::vector<assembly::Channel>& channels, const assembly::Loading& loading, const response::Peaks& peaks,
                              const response::Band& band) {
  return response::automatic_grid(c.assembled, channels, loading, c.roots.poles, peaks, band, c.progress);
}

std::vector<response::TimeInput> time_inputs(const CaseContext& c, const std::vector<std::string>& names) {
  std::vector<response::TimeInput> inputs;
  for (const model::Excitation& excitation : c.system.description().excitations)
    if (const auto* history = std::get_if<model::History>(&excitation.course); history && selected(names, excitation.name))
      inputs.push_back({excitation.name, history->signal, assembly::loading(c.assembled, excitation.action)});
  return inputs;
}

void require_rigid_ground(const CaseContext& c, const std::string& question) {
  if (const auto standing = model::element_on_modes(c.system.description()))
    throw foundation::NotComputable(question + ": \"" + *standing + "\" stands on the modes of a foundation, which do not say how they follow a rigid motion of the ground");
}

/// 0 … 5 for a motion along x … about z, none for a force.
std::optional<std::size_t> axis_of(const assembly::Channel& channel) {
  if (!channel.unit.starts_with("m") && !channel.unit.starts_with("rad")) return std::nullopt;
  const std::string component = channel.name.substr(channel.name.rfind('.') + 1);
  const auto at = std::find(model::coordinate_names.begin(), model::coordinate_names.end(), component) - model::coordinate_names.begin();
  return static_cast<std::size_t>(at);
}

/// Of every body or point all of whose three translations were asked for, with the rotations that were; none if one of these has no number.
std::vector<TotalValue> total_values(const std::vector<assembly::Channel>& channels, const response::RandomResponse& response,
                                                         const std::array<excitation::WeightedAxis, 6>& axes) {
  struct Felt {
    std::vector<double> accelerations, factors;
    std::vector<std::string> axes;
    std::size_t translations = 0;
    bool complete = true;
  };
  std::map<std::string, Felt> groups;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const auto axis = axis_of(channels[i]);
    const response::RandomAnswer& answer = response.answers[i];
    if (!axis || axes[*axis].k == 0) continue;
    Felt& felt = groups[channels[i].name.substr(0, channels[i].name.rfind('.'))];
    felt.complete = felt.complete && (answer.weighted_rms || answer.vanishes);
    felt.accelerations.push_back(answer.weighted_rms.value_or(0));
    felt.factors.push_back(axes[*axis].k);
    felt.axes.emplace_back(model::coordinate_names[*axis]);
    felt.translations += *axis < 3;
  }
  std::vector<TotalValue> totals;
  for (const auto& [name, felt] : groups)
    if (felt.translations == 3 && felt.complete) totals.push_back({name, excitation::vibration_total_value(felt.accelerations, felt.factors), felt.axes});
  return totals;
}

/// Row of a coordinate by its full name.
Eigen::Index row_of(const CaseContext& c, const std::string& name) {
  for (std::size_t b = 0; b < c.system.bodies().size(); ++b)
    for (int j = 0; j < 6; ++j)
      if (name == c.system.bodies()[b].name + "." + model::coordinate_names[static_cast<std::size_t>(j)] && c.assembled.layout.row(b, j) >= 0) return c.assembled.layout.row(b, j);
  throw foundation::NotComputable("transient: initial value of \"" + name + "\": no free coordinate has this name");
}

std::optional<response::InitialState> initial_state(const CaseContext& c, const project::TransientRequest& request) {
  if (request.displacements.empty() && request.velocities.empty()) return std::nullopt;
  Eigen::VectorXd q = Eigen::VectorXd::Zero(c.assembled.layout.of_bodies()), v = q;
  for (const auto& [name, value] : request.displacements) q(row_of(c, name)) = value;
  for (const auto& [name, value] : request.velocities) v(row_of(c, name)) = value;
  return response::initial_state(c.assembled, q, v);
}

std::string direction_words(const response::Direction& direction) {
  const Eigen::Vector3d axis = direction.axis.normalized();
  for (int i = 0; i < 3; ++i)
    if (std::abs(axis(i)) > 1 - 1e-12) return std::string(direction.rotation ? "about " : "along ") + "xyz"[i];
  return fmt::format("{} ({:.3g}, {:.3g}, {:.3g})", direction.rotation ? "about" : "along", axis.x(), axis.y(), axis.z());
}

}  // namespace

response::Band default_band(const CaseContext& c) {
  double highest = 0;
  for (const modal::Mode& mode : c.modes.list) highest = std::max(highest, mode.angular_frequency.value_or(0));
  for (const modal::Root& root : c.roots.list) highest = std::max(highest, root.damped_angular_frequency.value_or(0));
  response::Band band{0, highest > 0 ? default_band_factor * highest : 1.0};
  for (const assembly::ElementMap& map : c.assembled.elements) band = {std::max(band.from, map.defined_from), std::min(band.to, map.defined_to)};
  return band;
}

RandomResult random_answer(const CaseContext& c, const project::RandomRequest& request) {
  const std::vector<assembly::Channel> channels = channels_of(c, request.wanted);
  const response::RandomLoading loading = response::random_loading(c.system, c.assembled, request.wanted.excitations);
  if (loading.inputs.empty()) throw foundation::NotComputable("random: the model has no random excitation; add [excitations.NAME] with type = \"random\"");
  response::RandomOptions options;
  const auto axes = request.contact ? excitation::comfort_axes(*request.contact) : std::array<excitation::WeightedAxis, 6>{};
  for (std::size_t i = 0; i < channels.size() && (request.weighting || request.contact); ++i)
    if (const auto axis = axis_of(channels[i])) options.weighted.push_back({i, request.contact ? axes[*axis].weighting : *request.weighting});
  RandomResult result;
  result.quantity = request.wanted.quantity;
  for (const response::RandomInput& input : loading.inputs) result.inputs.push_back(input.name);
  result.response = response::random_response(c.assembled, channels, loading, options, c.progress);
  if (request.contact) result.total_values = total_values(channels, result.response, axes);
  result.curves = response::random_curves(c.assembled, channels, loading, {}, c.progress);
  return result;
}

TransientResult transient_answer(const CaseContext& c, const project::TransientRequest& request, foundation::Problems& warnings) {
  const std::vector<response::TimeInput> inputs = time_inputs(c, request.wanted.excitations);
  response::TransientOptions options;
  options.from = request.from;
  options.to = request.to;
  options.step = request.step;
  options.nearest_linear_system = request.nearest_linear_system;
  options.initial = initial_state(c, request);
  if (inputs.empty() && !options.initial)
    throw foundation::NotComputable("transient: nothing sets the model in motion; add [excitations.NAME] with type = \"time\", or initial values");
  TransientResult result{response::transient_response(c.system, c.assembled, channels_of(c, request.wanted), inputs, options, c.progress), request.wanted.quantity};
  warnings.add(result.response.warnings);
  if (request.nearest_linear_system && !c.assembled.frequency_dependent())
    warnings.warning("analyses.transient.nearest_linear_system", "true",
                     "no element depends on frequency in a way that needs it", "remove it");
  return result;
}

OrdersResult orders_answer(const CaseContext& c, const project::OrdersRequest& request) {
  const std::vector<response::OrderLoading> orders = response::order_loadings(c.system, c.assembled, request.wanted.excitations);
  if (orders.empty()) throw foundation::NotComputable("orders: the model has no excitation that goes with a shaft; add [excitations.NAME] with type = \"orders\" or \"unbalance\"");
  response::RunUpOptions options;
  options.speed = request.speed;
  return {response::run_up(c.assembled, channels_of(c, request.wanted), orders, c.modes, c.roots, options, c.progress),
          response::campbell(c.assembled, orders, c.modes, c.roots, request.speed), request.wanted.quantity};
}

TransmissibilityResult transmissibility_answer(const CaseContext& c, const project::TransmissibilityRequest& request) {
  const bool force = !request.force.empty();
  if (!force) require_rigid_ground(c, "transmissibility");
  const response::Transmission transmission = force ? response::force_transmission(c.system, c.assembled, response::applied_force(c.system, request.force))
                                                    : response::displacement_transmission(c.system, c.assembled, request.of, request.direction);
  TransmissibilityResult result;
  result.of_force = force;
  result.words = force ? "force on the ground over \"" + request.force + "\"" : "motion over a motion of the ground " + direction_words(request.direction);
  result.band = request.band ? *request.band : default_band(c);
  if (!(result.band.from < result.band.to)) throw foundation::NotComputable("transmissibility: the tables of the elements and the natural frequencies have no band in common; give a band");
  result.peaks = response::peaks(c.assembled, transmission.channels, transmission.loading, c.modes, c.roots, {response::PeakOptions{}.min_prominence, result.band.to}, c.progress);
  result.curves = response::frequency_response(c.assembled, transmission.channels, transmission.loading,
                                               grid_over(c, transmission.channels, transmission.loading, result.peaks, result.band));
  result.crossovers = response::crossovers(c.assembled, transmission, result.peaks);
  return result;
}

response::PowerFlow power_answer(const CaseContext& c, const project::PowerRequest& request) {
  const assembly::Loading loading = assembly::harmonic_loading(c.system, c.assembled, request.excitations);
  if (loading.vanishes()) throw foundation::NotComputable("power: the model has no harmonic excitation");
  const std::vector<assembly::Channel> channels = assembly::channels(c.system, c.assembled, {"coordinates"}, assembly::Quantity::velocity);
  const response::Band band = request.band ? *request.band : default_band(c);
  const response::Peaks peaks = response::peaks(c.assembled, channels, loading, c.modes, c.roots, {response::PeakOptions{}.min_prominence, band.to}, c.progress);
  std::vector<double> grid = grid_over(c, channels, loading, peaks, band);
  // At rest nothing moves; on an undamped resonance no steady power exists.
  const response::FrequencyResponse defined = response::frequency_response(c.assembled, channels, loading, grid);
  std::erase_if(grid, [&](double w) { return w == 0 || std::find(defined.check.undefined_at.begin(), defined.check.undefined_at.end(), w) != defined.check.undefined_at.end(); });
  return response::power_flow(c.system, c.assembled, loading, grid, c.progress);
}

std::vector<response::DeflectionShape> shapes_answer(const CaseContext& c, const project::ShapesRequest& request) {
  const assembly::Loading loading = assembly::harmonic_loading(c.system, c.assembled, request.excitations);
  if (loading.vanishes()) throw foundation::NotComputable("shapes: the model has no harmonic excitation");
  std::vector<response::DeflectionShape> shapes;
  for (const double omega : request.at) shapes.push_back(response::deflection_shape(c.system, c.assembled, loading, omega));
  return shapes;
}

std::vector<ShockSpectrumResult> shock_spectrum_answer(const CaseContext& c, const project::ShockSpectrumRequest& request, foundation::Problems& warnings) {
  constexpr int per_octave = 48;
  std::vector<double> natural;
  const int count = std::max(2, static_cast<int>(std::ceil(per_octave * std::log2(request.band.to / request.band.from))) + 1);
  for (int i = 0; i < count; ++i) natural.push_back(request.band.from * std::pow(request.band.to / request.band.from, static_cast<double>(i) / (count - 1)));
  std::vector<ShockSpectrumResult> results;
  for (const model::Excitation& excitation : c.system.description().excitations) {
    const auto* history = std::get_if<model::History>(&excitation.course);
    if (!history || !selected(request.excitations, excitation.name)) continue;
    const model::Action& action = excitation.action;
    if (action.body || action.derivative != 2 || !action.amplitude.tail<3>().isZero(0)) {
      const std::string reason = "shock_spectrum: \"" + excitation.name + "\" is not a translation of the ground given by its acceleration";
      if (!request.excitations.empty()) throw foundation::NotComputable(reason);
      warnings.warning(reason, "left out", "", "");
      continue;
    }
    const excitation::Signal along = excitation::scaled(history->signal, action.amplitude.head<3>().norm());
    results.push_back({excitation.name, "m/s²", request.damping_ratio, excitation::shock_spectrum(along, natural, request.damping_ratio, c.progress)});
  }
  if (results.empty()) throw foundation::NotComputable("shock_spectrum: the model has no motion of the ground given by its acceleration over time");
  return results;
}

response::EarthquakeResponse earthquake_answer(const CaseContext& c, const project::EarthquakeRequest& request, foundation::Problems& warnings) {
  require_rigid_ground(c, "earthquake");
  spatial::Vector6 direction = spatial::Vector6::Zero();
  direction.head<3>() = request.direction;
  response::EarthquakeResponse result = response::earthquake_response(c.assembled, channels_of(c, request.wanted), request.spectrum, direction);
  warnings.add(result.warnings);
  if (!(result.effective_mass_share > 0)) throw foundation::NotComputable("earthquake: the spectrum reaches none of the modes that this motion of the ground drives");
  return result;
}

std::vector<LimitLineResult> limit_line_answer(const CaseContext& c, const std::vector<project::LimitLineRequest>& requests, const project::Wanted& wanted, const response::Band& band) {
  const assembly::Loading loading = assembly::harmonic_loading(c.system, c.assembled, wanted.excitations);
  std::vector<LimitLineResult> results;
  for (const project::LimitLineRequest& request : requests) {
    const std::string& unit = request.line.unit;
    const auto quantity = unit == "m/s" || unit == "rad/s" ? assembly::Quantity::velocity : unit == "m/s²" || unit == "rad/s²" ? assembly::Quantity::acceleration : assembly::Quantity::displacement;
    const std::vector<assembly::Channel> channel = assembly::channels(c.system, c.assembled, {request.of}, quantity);
    const response::Peaks peaks = response::peaks(c.assembled, channel, loading, c.modes, c.roots, {response::PeakOptions{}.min_prominence, band.to}, c.progress);
    results.push_back({request.of, request.line, response::compared_with_limit(c.assembled, channel.front(), loading, c.roots.poles, peaks, request.line, band, c.progress)});
  }
  return results;
}

}  // namespace trivet::study
