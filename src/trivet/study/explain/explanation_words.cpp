// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/explain/explanation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "trivet/modal/modes.h"
#include "trivet/model/element_directions.h"

namespace trivet::study {
namespace {

constexpr double one_makes_it = 0.9;  // from this share on, a second mode is not mentioned
constexpr double worth_a_word = 0.05;

std::string percent(double share) { return fmt::format("{:.3g} %", 100 * share); }

std::string place_words(double omega) {
  return fmt::format("{:.4g} rad/s ({:.4g} Hz)", omega, omega / (2 * std::numbers::pi));
}

const modal::Mode& mode_of(const Explanation& explanation, int number) { return explanation.modes.list[number - 1]; }

std::string modes_words(const Explanation& explanation, const ExplainedPeak& peak) {
  if (std::isinf(peak.peak.amplitude))
    return peak.peak.nearest_mode ? fmt::format("It is mode {}, {}, without damping", *peak.peak.nearest_mode,
                                                mode_of(explanation, *peak.peak.nearest_mode).name)
                                  : "";
  std::vector<response::ModeShare> modes = peak.shares.modes;
  std::ranges::stable_sort(modes, [](const auto& a, const auto& b) { return std::abs(a.share) > std::abs(b.share); });
  if (modes.empty()) return "";
  std::string words = fmt::format("Mode {}, {}, contributes {} of it", modes[0].mode,
                                  mode_of(explanation, modes[0].mode).name, percent(modes[0].share));
  if (std::abs(modes[0].share - 1) <= 1 - one_makes_it) return words;
  for (std::size_t i = 1; i < std::min<std::size_t>(modes.size(), 3); ++i)
    if (std::abs(modes[i].share) > worth_a_word)
      words += fmt::format(", mode {} {}", modes[i].mode, percent(modes[i].share));
  return words;
}

std::string energy_words(const project::Case& variant, const ExplainedPeak& peak) {
  const response::PeakShares shares = response::of_positive_parts(peak.shares);
  const auto& elements = shares.elements;
  if (elements.empty() || shares.strain_energy == 0) return "";
  const auto most =
      std::ranges::max_element(elements, [](const auto& a, const auto& b) { return a.stored < b.stored; });
  const model::Element& element = variant.system.elements()[most - elements.begin()];
  Eigen::Index direction = 0;
  const double in_direction = most->by_direction.maxCoeff(&direction);
  if (!(most->stored > 0)) return "";
  std::string words = fmt::format("{} of the strain energy is in \"{}\"", percent(most->stored), element.name);
  constexpr double round_off = 1e-9;
  if (in_direction > (1 + round_off) * most->stored)  // other directions of the element give some back
    words += ", most in its " + model::direction_words(element, static_cast<int>(direction));
  else if (in_direction > 0)
    words += fmt::format(", {} in its {}", percent(in_direction),
                         model::direction_words(element, static_cast<int>(direction)));
  const auto damping =
      std::ranges::max_element(elements, [](const auto& a, const auto& b) { return a.dissipated < b.dissipated; });
  if (const double returned = response::given_back(peak.shares); returned >= modal::noticeably_given_back)
    words +=
        fmt::format("; {} of what is stored is given back by preload, weight or negative stiffness", percent(returned));
  if (damping->dissipated > shares.system_damping)
    words += fmt::format("; \"{}\" dissipates {} of the power",
                         variant.system.elements()[damping - elements.begin()].name, percent(damping->dissipated));
  return words;
}

std::string trial_words(const ExplainedPeak& peak) {
  if (!peak.trial) return "";
  const Trial& trial = *peak.trial;
  std::string words = fmt::format("+{:.0f} % on {}", 100 * trial.amount, trial.words);
  if (!trial.angular_frequency) return words + " leaves no such peak nearby";
  words += fmt::format(" moves the peak to {}", place_words(*trial.angular_frequency));
  if (trial.amplitude) words += fmt::format(" and {}", value_words(*trial.amplitude, peak.unit));
  words += " (recomputed";
  if (trial.predicted_angular_frequency)
    words += fmt::format("; to first order {:.4g} rad/s", *trial.predicted_angular_frequency);
  if (trial.predicted_amplitude)
    words += fmt::format("{}{}", trial.predicted_angular_frequency ? " and " : "; to first order ",
                         value_words(*trial.predicted_amplitude, peak.unit));
  return words + ")";
}

std::string lever_words(const Explanation& explanation, const ExplainedPeak& peak) {
  if (peak.sensitivities.empty() || !peak.sensitivities.front().height) return "";
  const response::Sensitivity& first = peak.sensitivities.front();
  const response::Parameter& parameter = explanation.parameters[first.parameter];
  return fmt::format("Its height is most sensitive to {}: {} gives {:+.3g} %", parameter.name, parameter.change,
                     100 * *first.height * parameter.size);
}

}  // namespace

std::string value_words(double value, const std::string& unit) {
  struct Prefix {
    double factor;
    const char* sign;
  };
  static constexpr std::array<Prefix, 5> prefixes = {{{1e6, "M"}, {1e3, "k"}, {1, ""}, {1e-3, "m"}, {1e-6, "µ"}}};
  const double size = std::abs(value);
  const bool length_or_angle = unit.starts_with("m") || unit.starts_with("rad");
  for (const Prefix& prefix : prefixes) {
    if (prefix.factor > 1 && length_or_angle) continue;  // no kilometres
    if (size >= prefix.factor) return fmt::format("{:.4g} {}{}", value / prefix.factor, prefix.sign, unit);
  }
  return fmt::format("{:.4g} {}", value, unit);
}

std::string sentence(const project::Case& variant, const Explanation& explanation, const ExplainedPeak& peak) {
  std::string text =
      fmt::format("{}: {} at {}", peak.name,
                  std::isinf(peak.peak.amplitude) ? "unbounded" : value_words(peak.peak.amplitude, peak.unit),
                  place_words(peak.peak.angular_frequency));
  for (const std::string& part :
       {modes_words(explanation, peak), energy_words(variant, peak), trial_words(peak), lever_words(explanation, peak)})
    if (!part.empty()) text += ". " + part;
  return text + ".";
}

}  // namespace trivet::study
