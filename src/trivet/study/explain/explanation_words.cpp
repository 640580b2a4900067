// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/explain/explanation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "trivet/foundation/unit_prefix.h"
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
  constexpr double shown_above_all = 1.0005;
  const auto moves_against = [](const auto& mode) { return mode.share < 0; };
  if (modes[0].share > shown_above_all && std::ranges::any_of(modes, moves_against))
    words += " (above 100 %: others move against it)";
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

StatedNumber frequency(double omega) { return {omega, "rad/s", StatedNumber::Kind::frequency}; }

StatedWords trial_words(const ExplainedPeak& peak) {
  if (!peak.trial) return {};
  const Trial& trial = *peak.trial;
  const std::string more = fmt::format("+{:.0f} % on {}", 100 * trial.amount, trial.words);
  if (!trial.angular_frequency) return {more + " leaves no such peak nearby"};
  StatedWords words = {more + " moves the peak to ", frequency(*trial.angular_frequency)};
  const auto add = [&](const char* before, const StatedNumber& number) {
    words.emplace_back(before);
    words.emplace_back(number);
  };
  if (trial.amplitude) add(" and ", {*trial.amplitude, peak.unit});
  words.emplace_back(" (recomputed");
  if (trial.predicted_angular_frequency) add("; to first order ", frequency(*trial.predicted_angular_frequency));
  if (trial.predicted_amplitude)
    add(trial.predicted_angular_frequency ? " and " : "; to first order ", {*trial.predicted_amplitude, peak.unit});
  words.emplace_back(")");
  return words;
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
  const foundation::UnitPrefix prefix = foundation::unit_prefix(std::abs(value), unit);
  return fmt::format("{:.4g} {}", value * prefix.factor, prefix.unit);
}

std::string words_in_si(const StatedWords& words) {
  std::string text;
  for (const auto& part : words) {
    const auto* number = std::get_if<StatedNumber>(&part);
    if (!number) text += std::get<std::string>(part);
    else if (number->kind == StatedNumber::Kind::frequency) text += place_words(number->value);
    else text += value_words(number->value, number->unit);
  }
  return text;
}

StatedWords sentence(const project::Case& variant, const Explanation& explanation, const ExplainedPeak& peak) {
  StatedWords words = {peak.name + ": "};
  if (std::isinf(peak.peak.amplitude)) words.emplace_back("unbounded");
  else words.emplace_back(StatedNumber{peak.peak.amplitude, peak.unit});
  words.emplace_back(" at ");
  words.emplace_back(frequency(peak.peak.angular_frequency));
  const auto add = [&](const StatedWords& part) {
    if (part.empty()) return;
    words.emplace_back(". ");
    words.insert(words.end(), part.begin(), part.end());
  };
  for (const std::string& part : {modes_words(explanation, peak), energy_words(variant, peak)})
    add(part.empty() ? StatedWords() : StatedWords{part});
  add(trial_words(peak));
  if (const std::string lever = lever_words(explanation, peak); !lever.empty()) add({lever});
  words.emplace_back(".");
  return words;
}

}  // namespace trivet::study
