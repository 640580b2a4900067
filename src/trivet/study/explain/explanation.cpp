// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/explain/explanation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "trivet/assembly/loads.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/model/element_directions.h"
#include "trivet/nonlinear/laws/deflections.h"
#include "trivet/nonlinear/rest/rest_position.h"

namespace trivet::study {
namespace {

using response::Sensitivity;

project::ChannelSelection selection_of(const project::Case& variant, const ExplainRequest& request) {
  const project::Analyses& file = variant.analyses;
  project::ChannelSelection selection = file.peaks ? file.peaks->selection
      : file.response                              ? file.response->selection
                                                   : project::ChannelSelection{};
  if (!request.of.empty()) selection.of = request.of;
  return selection;
}

/// A nonlinear machine in its new position of rest.
model::System changed_at_rest(const model::System& system, const response::Parameter& parameter, double amount) {
  model::System found = response::changed(system, parameter, amount);
  return model::is_nonlinear(found) ? nonlinear::rest_position(found).system : found;
}

/// For each deflection of laws the number of their kinks below it at rest.
std::vector<long> pieces_at_rest(const model::System& system) {
  std::vector<long> found;
  const auto add = [&](const std::vector<double>& kinks, double deflection) {
    found.push_back(std::ranges::count_if(kinks, [&](double kink) { return kink < deflection; }));
  };
  for (const model::Element& element : system.elements()) {
    for (const model::NonlinearPart& part : element.nonlinear_parts)
      add(elements::kinks_at_rest(part.laws), part.at_rest);
    for (const model::DistancePart& part : element.distance_parts)
      add(elements::kink_distances(part.law), part.law.distance(part.at_rest));
  }
  return found;
}

/// The same for slopes, which end where a law has a kink.
model::System smoothly_changed(const model::System& system, const response::Parameter& parameter, double amount) {
  model::System found = changed_at_rest(system, parameter, amount);
  if (pieces_at_rest(found) != pieces_at_rest(system))
    throw foundation::NotComputable(
        "no slopes to parameters of which a small change opens or closes a stop at rest, or passes a kink of a law "
        "there");
  return found;
}

response::SensitivityRequest sensitivity_request(const project::ChannelSelection& selection,
                                                 const response::Peaks& peaks) {
  response::SensitivityRequest sensitivity;
  for (const response::CurveSummary& curve : peaks.curves) sensitivity.channels.push_back(curve.name);
  sensitivity.quantity = selection.quantity;
  sensitivity.load = [excitations = selection.excitations](const model::System& system,
                                                           const assembly::Assembled& assembled) {
    return assembly::harmonic_loading(system, assembled, excitations);
  };
  sensitivity.changed = smoothly_changed;
  return sensitivity;
}

/// An undamped resonance is examined by its mode; without a mode it cannot be explained.
response::PeakPlace place_of(const response::Peak& peak) {
  response::PeakPlace place{peak.curve, peak.angular_frequency, {}};
  if (std::isinf(peak.amplitude)) place.unbounded_mode = peak.nearest_mode;
  return place;
}

/// Peaks except those that are only round-off of a motion which is zero in their channel by symmetry.
std::vector<response::Peak> above_round_off(const project::Case& variant, const assembly::Assembled& assembled,
                                            const response::SensitivityRequest& sensitivity,
                                            const std::vector<response::Peak>& peaks) {
  constexpr double round_off = 1e-9;
  std::vector<response::Peak> result;
  for (const response::Peak& peak : peaks)
    if (response::alignment(variant.system, assembled, sensitivity, place_of(peak)) > round_off) result.push_back(peak);
  return result;
}

/// The highest peaks by height, then by prominence, relative to the highest bounded peak of the curve; unbounded peaks
/// rank highest. Returned in the original order.
std::vector<response::Peak> tallest(const std::vector<response::Peak>& peaks, int most) {
  std::vector<std::size_t> order(peaks.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto rank = [&](std::size_t i) {
    const response::Peak& peak = peaks[i];
    double top = 0;
    for (const response::Peak& other : peaks)
      if (other.curve == peak.curve && std::isfinite(other.amplitude)) top = std::max(top, other.amplitude);
    const bool bounded = std::isfinite(peak.amplitude);
    return bounded ? std::array{peak.amplitude / top, peak.prominence / top}
                   : std::array{peak.amplitude, peak.prominence};
  };
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return rank(a) > rank(b); });
  order.resize(std::min(order.size(), to_size(std::max(most, 0))));
  std::ranges::sort(order);
  std::vector<response::Peak> result;
  for (const std::size_t i : order) result.push_back(peaks[i]);
  return result;
}

/// Strength of a parameter's effect, in single precision: values equal except for round-off keep the order of the
/// model.
float strength(const Sensitivity& s, const std::vector<response::Parameter>& parameters, bool unbounded) {
  return static_cast<float>(std::abs((unbounded ? s.frequency : s.height).value_or(0)) * parameters[s.parameter].size);
}

/// A stiffness that a trial may change, with its description.
struct Candidate {
  std::string parameter, words;
};

/// "the axial stiffness of \"front\"", of an element with laws that beside them.
std::string stiffness_words(const model::Element& element, const std::string& which) {
  return fmt::format("the {} of \"{}\"{}", which, element.name, model::has_laws(element) ? " beside its laws" : "");
}

/// Stiffness of an element along the direction with most of its strain energy; that of the whole element if there is no
/// parameter for the direction.
std::optional<Candidate> candidate(const project::Case& variant, std::size_t e, const ExplainedPeak& peak,
                                   const std::vector<response::Parameter>& parameters) {
  const model::Element& element = variant.system.elements()[e];
  Eigen::Index direction = 0;
  peak.shares.elements[e].by_direction.maxCoeff(&direction);
  const std::string path = "elements." + foundation::path_key(element.name) + ".";
  const std::string whole = stiffness_words(element, "stiffness");
  for (const Candidate& one :
       {Candidate{path + fmt::format("stiffness_factor.{}", model::coordinate_names[direction]),
                  fmt::format("the {} of \"{}\"", model::direction_words(element, static_cast<int>(direction)),
                              element.name)},
        Candidate{path + "scale", whole}, Candidate{path + "stiffness_factor.all", whole}})
    for (const response::Parameter& parameter : parameters)
      if (parameter.name == one.parameter) return one;
  return std::nullopt;
}

/// Relative change of the peak's frequency or height, whichever is larger, per relative change of the parameter.
double effect(const std::string& name, const ExplainedPeak& peak, const std::vector<response::Parameter>& parameters) {
  for (const Sensitivity& s : peak.sensitivities)
    if (parameters[s.parameter].name == name)
      return std::max(std::abs(s.frequency.value_or(0)), std::abs(s.height.value_or(0)));
  return 0;
}

/// The stiffness that changes the peak most: of one element, or of all.
std::optional<Candidate> strongest(const project::Case& variant, std::optional<std::size_t> of,
                                   const ExplainedPeak& peak, const std::vector<response::Parameter>& parameters) {
  std::optional<Candidate> found;
  double most = 0;
  const auto& elements = variant.system.elements();
  const auto consider = [&](const std::string& name, const std::string& words) {
    const double now = effect(name, peak, parameters);
    if (now <= most) return;
    most = now;
    found = Candidate{name, words};
  };
  for (std::size_t e = of.value_or(0); e < (of ? *of + 1 : elements.size()); ++e) {
    const std::string path = "elements." + foundation::path_key(elements[e].name) + ".";
    for (int j = 0; j < 6; ++j)
      consider(path + fmt::format("stiffness_factor.{}", model::coordinate_names[j]),
               stiffness_words(elements[e], model::direction_words(elements[e], j)));
    consider(path + "scale", stiffness_words(elements[e], "stiffness"));
  }
  return found;
}

/// The element and direction with most of the strain energy. If they hardly change the peak because it shows another
/// motion, the strongest stiffness of that element, or else of any element.
std::optional<Trial> trial_of(const project::Case& variant, ExplainedPeak& peak,
                              const std::vector<response::Parameter>& parameters) {
  constexpr double idle = 0.01;  // of the strongest effect
  const auto& elements = variant.system.elements();
  const response::PeakShares of_stored = response::of_positive_parts(peak.shares);
  std::size_t first = 0;
  for (std::size_t e = 0; e < elements.size(); ++e)
    if (of_stored.elements[e].stored > of_stored.elements[first].stored) first = e;
  if (elements.empty() || !(of_stored.elements[first].stored > 0)) return std::nullopt;
  std::optional<Candidate> chosen = candidate(variant, first, peak, parameters);
  const std::optional<Candidate> best = strongest(variant, {}, peak, parameters);
  if (!chosen && best && model::has_laws(elements[first]))
    peak.notes.push_back(
        fmt::format("\"{}\" has {:.3g} % of the strain energy, and its stiffness is that of its laws "
                    "or its deformation, of which there are no slopes: map takes their numbers",
                    elements[first].name, 100 * of_stored.elements[first].stored));
  if (!chosen) chosen = best;
  if (!chosen) return std::nullopt;
  if (best) {
    const double enough = idle * effect(best->parameter, peak, parameters);
    if (effect(chosen->parameter, peak, parameters) < enough) {
      const bool whole = chosen->parameter.ends_with(".scale") || chosen->parameter.ends_with(".stiffness_factor.all");
      const auto& shares = of_stored.elements[first];
      peak.notes.push_back(
          fmt::format("{} hardly changes this peak, although it has {:.3g} % of the strain energy", chosen->words,
                      100 * (whole ? shares.stored : std::min(shares.stored, shares.by_direction.maxCoeff()))));
      chosen = strongest(variant, first, peak, parameters);
      if (!chosen || effect(chosen->parameter, peak, parameters) < enough) chosen = best;
    }
  }
  return Trial{chosen->parameter, chosen->words, 0.1, {}, {}, {}, {}};
}

/// Finds the peak of the changed model nearest to the predicted frequency.
void solve_again(const project::Case& variant, const response::SensitivityRequest& sensitivity,
                 const response::Parameter& parameter, const ExplainedPeak& peak, Trial& trial) {
  constexpr double beyond_recognition = 0.2;
  const model::System system = changed_at_rest(variant.system, parameter, trial.amount);
  const assembly::Assembled assembled = assembly::assemble(system);
  const modal::Modes modes = modal::modes(system, assembled);
  const std::vector<assembly::Channel> channels =
      assembly::channels(system, assembled, {peak.name}, sensitivity.quantity);
  const response::Peaks again = response::peaks(assembled, channels, sensitivity.load(system, assembled), modes,
                                                modal::roots(system, assembled, modes));
  const double expected = trial.predicted_angular_frequency.value_or(peak.peak.angular_frequency);
  double best = beyond_recognition * expected;
  for (const response::Peak& other : again.list)
    if (const double distance = std::abs(other.angular_frequency - expected); distance < best) {
      best = distance;
      trial.angular_frequency = other.angular_frequency;
      if (std::isfinite(other.amplitude)) trial.amplitude = other.amplitude;
    }
}

/// Notes close modes: they mix under small changes, so that slopes predict heights badly.
void note_close_modes(const modal::Modes& modes, ExplainedPeak& peak) {
  constexpr double close = 0.02;
  if (!peak.peak.nearest_mode) return;
  const modal::Mode& own = modes.list[*peak.peak.nearest_mode - 1];
  for (const modal::Mode& mode : modes.list) {
    const double apart = std::abs(mode.angular_frequency.value_or(0) / *own.angular_frequency - 1);
    if (mode.number != own.number && apart < close && !own.repeated)
      peak.notes.push_back(
          fmt::format("mode {} is only {:.2g} % away from mode {}: small changes mix the two, and first-order values "
                      "hold only for still smaller ones",
                      mode.number, 100 * apart, own.number));
  }
}

void try_more(const project::Case& variant, const response::SensitivityRequest& sensitivity,
              const std::vector<response::Parameter>& parameters, ExplainedPeak& peak) {
  peak.trial = trial_of(variant, peak, parameters);
  if (!peak.trial) return;
  Trial& trial = *peak.trial;
  for (const Sensitivity& s : peak.sensitivities) {
    if (parameters[s.parameter].name != trial.parameter) continue;
    if (s.height) trial.predicted_amplitude = peak.peak.amplitude * (1 + trial.amount * *s.height);
    if (s.frequency)
      trial.predicted_angular_frequency = peak.peak.angular_frequency * (1 + trial.amount * *s.frequency);
    try {
      solve_again(variant, sensitivity, parameters[s.parameter], peak, trial);
    } catch (const foundation::NotComputable& reason) {
      peak.notes.emplace_back(reason.what());
    }
  }
}

}  // namespace

Explanation explanation(const project::Case& variant, const ExplainRequest& request,
                        const foundation::Progress& progress) {
  const project::ChannelSelection selection = selection_of(variant, request);
  project::Analyses analyses;
  analyses.peaks = project::PeaksRequest{selection};
  const CaseResults found = case_results(variant, analyses, progress);
  if (!found.failures.empty()) throw foundation::NotComputable(found.failures.front());
  const response::Peaks& peaks = found.peaks->peaks;
  const response::SensitivityRequest sensitivity = sensitivity_request(selection, peaks);
  const assembly::Assembled assembled = assembly::assemble(variant.system);
  Explanation result;
  result.modes = found.modes;
  result.warnings = found.warnings;
  result.notes = nonlinear::notes_about_rest(variant.system);
  for (const response::Peak& peak : peaks.list)
    if (std::isinf(peak.amplitude) && !peak.nearest_mode)
      throw foundation::NotComputable("explain: an unbounded peak belongs to no undamped mode");
  const std::vector<response::Peak> real = above_round_off(variant, assembled, sensitivity, peaks.list);
  const std::vector<response::Peak> chosen = tallest(real, request.most);
  result.left_out = static_cast<int>(real.size() - chosen.size());
  std::vector<response::PeakPlace> places;
  for (const response::Peak& peak : chosen) places.push_back(place_of(peak));
  response::SensitivityTable table =
      response::peak_sensitivities(variant.system, assembled, sensitivity, places, progress);
  result.parameters = std::move(table.parameters);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    foundation::report_progress(progress, "peaks recomputed",
                                static_cast<double>(i) / static_cast<double>(chosen.size()));
    ExplainedPeak& peak = result.peaks.emplace_back();
    peak.name = peaks.curves[chosen[i].curve].name;
    peak.unit = peaks.curves[chosen[i].curve].unit;
    peak.peak = chosen[i];
    peak.shares = response::peak_shares(variant.system, assembled, sensitivity, places[i]);
    peak.notes = table.peaks[i].notes;
    peak.sensitivities = table.peaks[i].list;
    const bool unbounded = std::isinf(peak.peak.amplitude);
    std::ranges::stable_sort(peak.sensitivities, [&](const Sensitivity& a, const Sensitivity& b) {
      return strength(a, result.parameters, unbounded) > strength(b, result.parameters, unbounded);
    });
    note_close_modes(result.modes, peak);
    try_more(variant, sensitivity, result.parameters, peak);
    peak.sentence = sentence(variant, result, peak);
  }
  return result;
}

}  // namespace trivet::study
