// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/sensitivity/peak_sensitivity.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/modal/modes.h"
#include "trivet/response/steady/body_dynamics.h"

namespace trivet::response {
namespace {

using Complex = std::complex<double>;
using Eigen::VectorXcd;

Complex with(const VectorXcd& row, const VectorXcd& column) { return row.cwiseProduct(column).sum(); }

/// A model with its channels and load, for evaluation at any ω.
struct DrivenModel {
  const model::System& system;
  assembly::Assembled assembled;
  std::vector<assembly::Channel> channels;
  assembly::Loading load;

  DrivenModel(const model::System& given, const SensitivityRequest& request)
      : system(given),
        assembled(assembly::assemble(given)),
        channels(assembly::channels(given, assembled, request.channels, request.quantity)),
        load(request.load(given, assembled)) {}

  [[nodiscard]] Dynamics at(const PeakPlace& peak, const ElementJets& jets) const {
    return body_dynamics(dynamics(assembled, channels[peak.channel], load, peak.angular_frequency, jets),
                         assembled.layout.of_bodies());
  }
};

/// Data of a peak that do not depend on the parameter.
class PeakOfModel {
 public:
  PeakOfModel(const DrivenModel& driven, const PeakPlace& place, const modal::Modes& modes,
              std::vector<std::string>& notes)
      : place_(place),
        jets_(element_jets(driven.assembled, place.angular_frequency)),
        dynamics_(driven.at(place, jets_)) {
    if (place.unbounded_mode) prepare_mode(driven, modes, notes);
    else prepare_maximum(notes);
  }

  [[nodiscard]] const PeakPlace& place() const { return place_; }
  [[nodiscard]] const ElementJets& jets() const { return jets_; }
  [[nodiscard]] const Dynamics& dynamics() const { return dynamics_; }

  /// `change` is the derivative of the dynamics with respect to the parameter.
  [[nodiscard]] Sensitivity sensitivity(const Dynamics& change) const {
    return place_.unbounded_mode ? mode_sensitivity(change) : maximum_sensitivity(change);
  }

 private:
  void prepare_mode(const DrivenModel& driven, const modal::Modes& modes, std::vector<std::string>& notes) {
    notes.emplace_back(
        "the amplitude is infinite without damping: no height sensitivity exists; the frequency is that of the "
        "undamped mode");
    const modal::Mode& mode = modes.list.at(to_size(*place_.unbounded_mode - 1));
    if (mode.repeated) {
      notes.emplace_back(
          "its mode belongs to a repeated root, which a change may split: the frequency has no derivative");
      return;
    }
    VectorXcd shape(driven.assembled.layout.of_bodies());
    for (std::size_t b = 0; b < driven.system.bodies().size(); ++b)
      for (int j = 0; j < 6; ++j)
        if (const Eigen::Index row = driven.assembled.layout.row(b, j); row >= 0 && row < shape.size())
          shape(row) = mode.shape(6 * to_index(b) + j);
    const Complex slope = with(shape, dynamics_.stiffness[1] * shape);
    if (slope != 0.0) shape_ = shape / std::sqrt(slope);
  }

  void prepare_maximum(std::vector<std::string>& notes) {
    constexpr double stationary = 1e-3;  // of its width: limit for the next Newton step at a maximum
    motion_ = motion(dynamics_);
    adjoint_ = adjoint(dynamics_);
    const auto& y = motion_.value;
    curvature_ = 2 * (std::norm(y[1]) + (std::conj(y[0]) * y[2]).real());
    const double slope = 2 * (std::conj(y[0]) * y[1]).real();
    const double width = std::sqrt(std::norm(y[0]) / std::abs(curvature_));
    is_maximum_ = curvature_ < 0 && std::abs(slope / curvature_) < stationary * width;
    if (!is_maximum_)
      notes.emplace_back(
          "this is not a maximum of the curve: heights are those at this fixed frequency, without frequency shifts");
  }

  Sensitivity mode_sensitivity(const Dynamics& change) const {
    Sensitivity result;
    if (shape_.size() > 0)
      result.frequency = -with(shape_, change.stiffness[0] * shape_).real() / place_.angular_frequency;
    return result;
  }

  Sensitivity maximum_sensitivity(const Dynamics& change) const {
    const auto& q = motion_.coordinates;
    const auto& y = motion_.value;
    const VectorXcd force = change.load[0] - change.stiffness[0] * q[0];
    const VectorXcd slope_of_force = change.load[1] - change.stiffness[1] * q[0] - change.stiffness[0] * q[1];
    const Complex by_parameter = with(adjoint_[0], force) + with(change.channel[0], q[0]) + change.direct[0];
    const Complex mixed = with(adjoint_[1], force) + with(adjoint_[0], slope_of_force) + with(change.channel[1], q[0]) +
        with(change.channel[0], q[1]) + change.direct[1];
    Sensitivity result;
    result.height = (std::conj(y[0]) * by_parameter).real() / std::norm(y[0]);
    if (is_maximum_)
      result.frequency = -2 * (std::conj(y[1]) * by_parameter + std::conj(y[0]) * mixed).real() / curvature_ /
          place_.angular_frequency;
    return result;
  }

  PeakPlace place_;
  ElementJets jets_;
  Dynamics dynamics_;
  VectorXcd shape_;  // of the unbounded mode, φᵀ Z_ω φ = 1
  Motion motion_;
  std::array<VectorXcd, 2> adjoint_;
  double curvature_ = 0;  // d²|y|²/dω²
  bool is_maximum_ = false;
};

/// The element jets, evaluated again for the parameter's element, and for all whose stiffness follows the position of
/// rest: with nonlinear parts, or by the forces that they carry there.
ElementJets changed_jets(const DrivenModel& driven, const PeakOfModel& peak, const Parameter& parameter) {
  ElementJets jets = peak.jets();
  for (std::size_t e = 0; e < jets.size(); ++e)
    if (jets[e] &&
        (parameter.law == e || driven.system.elements()[e].law.nonlinear ||
         !driven.assembled.elements[e].of_forces_at_rest.isZero(0)))
      jets[e] = element_jet(driven.assembled.elements[e], peak.place().angular_frequency);
  return jets;
}

/// Derivative (8(f(h) − f(−h)) − (f(2h) − f(−2h)))/12h of every peak's dynamics: exact for polynomials up to the fourth
/// degree.
std::vector<Dynamics> derivatives(const model::System& system, const SensitivityRequest& request,
                                  const std::vector<PeakOfModel>& peaks, const Parameter& parameter) {
  constexpr std::array<std::pair<double, double>, 4> nodes = {
      {{1, 8.0 / 12}, {-1, -8.0 / 12}, {2, -1.0 / 12}, {-2, 1.0 / 12}}};
  std::vector<Dynamics> result;
  for (const PeakOfModel& peak : peaks) {
    result.push_back(peak.dynamics());
    result.back().add(-1, peak.dynamics());
  }
  for (const auto& [node, weight] : nodes) {
    const model::System other = request.changed(system, parameter, node * parameter.step);
    const DrivenModel driven(other, request);
    for (std::size_t i = 0; i < peaks.size(); ++i)
      result[i].add(weight / parameter.step, driven.at(peaks[i].place(), changed_jets(driven, peaks[i], parameter)));
  }
  return result;
}

}  // namespace

SensitivityTable peak_sensitivities(const model::System& system, const assembly::Assembled& assembled,
                                    const SensitivityRequest& request, const std::vector<PeakPlace>& places,
                                    const foundation::Progress& progress) {
  for (const PeakPlace& place : places)
    if (!(place.angular_frequency > 0) || !std::isfinite(place.angular_frequency))
      throw foundation::InvalidInput("peak_sensitivities: the frequency of a peak must be finite and > 0");
  SensitivityTable table;
  table.parameters = model_parameters(system);
  table.peaks.resize(places.size());
  const bool any_mode =
      std::ranges::any_of(places, [](const PeakPlace& place) { return place.unbounded_mode.has_value(); });
  const modal::Modes modes = any_mode ? modal::modes(system, assembled) : modal::Modes{};
  const DrivenModel driven(system, request);
  std::vector<PeakOfModel> peaks;
  for (std::size_t i = 0; i < places.size(); ++i) peaks.emplace_back(driven, places[i], modes, table.peaks[i].notes);
  for (std::size_t p = 0; p < table.parameters.size(); ++p) {
    foundation::report_progress(progress, "sensitivities",
                                static_cast<double>(p) / static_cast<double>(table.parameters.size()));
    try {
      const std::vector<Dynamics> change = derivatives(system, request, peaks, table.parameters[p]);
      for (std::size_t i = 0; i < peaks.size(); ++i) table.peaks[i].list.push_back(peaks[i].sensitivity(change[i]));
    } catch (const foundation::NotComputable& reason) {
      for (PeakSensitivities& peak : table.peaks) {
        peak.list.emplace_back();
        if (std::ranges::find(peak.notes, reason.what()) == peak.notes.end()) peak.notes.emplace_back(reason.what());
      }
    }
    for (PeakSensitivities& peak : table.peaks) peak.list.back().parameter = p;
  }
  return table;
}

}  // namespace trivet::response
