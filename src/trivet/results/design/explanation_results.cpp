// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/design/explanation_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "trivet/documents/csv_field.h"
#include "trivet/documents/shown_numbers.h"
#include "trivet/documents/text_table.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/results/format/json_parts.h"
#include "trivet/study/explain/explanation.h"

namespace trivet::results {

namespace {

using json::Json;

Json trial_json(const std::optional<study::Trial>& trial) {
  if (!trial) return nullptr;
  return {{"parameter", trial->parameter},
          {"amount", trial->amount},
          {"first_order",
           {{"angular_frequency", json::optional(trial->predicted_angular_frequency)},
            {"amplitude", json::optional(trial->predicted_amplitude)}}},
          {"solved_again",
           {{"angular_frequency", json::optional(trial->angular_frequency)},
            {"amplitude", json::optional(trial->amplitude)}}}};
}

Json shares_json(const project::Case& variant, const study::Explanation& explanation,
                 const response::PeakShares& shares) {
  Json modes = Json::array(), elements = Json::array();
  for (const response::ModeShare& mode : shares.modes)
    modes.push_back({{"mode", mode.mode},
                     {"name", explanation.modes.list[mode.mode - 1].name},
                     {"part", json::complex_number(mode.part)},
                     {"share", json::number(mode.share)}});
  for (std::size_t e = 0; e < shares.elements.size(); ++e)
    elements.push_back({{"name", variant.system.elements()[e].name},
                        {"stored", json::number(shares.elements[e].stored)},
                        {"by_direction", json::list(shares.elements[e].by_direction)},
                        {"dissipated", json::number(shares.elements[e].dissipated)}});
  return {{"modes", std::move(modes)},
          {"beyond_modes", json::number(shares.beyond_modes)},
          {"strain_energy", json::number(shares.strain_energy)},
          {"elements", std::move(elements)},
          {"geometric_stiffness", json::number(shares.geometric)},
          {"foundations", json::number(shares.in_foundations)},
          {"dissipated_power", json::number(shares.dissipated_power)},
          {"system_damping", json::number(shares.system_damping)},
          {"foundation_damping", json::number(shares.by_foundations)}};
}

Json sensitivities_json(const study::Explanation& explanation, const study::ExplainedPeak& peak) {
  Json result = Json::array();
  for (const response::Sensitivity& s : peak.sensitivities) {
    const response::Parameter& parameter = explanation.parameters[s.parameter];
    result.push_back({{"parameter", parameter.name},
                      {"height", json::optional(s.height)},
                      {"frequency", json::optional(s.frequency)},
                      {"change", parameter.change},
                      {"change_size", parameter.size}});
  }
  return result;
}

}  // namespace

std::string explain_json(const project::Case& variant, const study::Explanation& explanation) {
  Json result{
      {"peaks", Json::array()}, {"left_out", explanation.left_out}, {"warnings", json::warnings(explanation.warnings)}};
  if (!explanation.notes.empty()) result["notes"] = explanation.notes;
  for (const study::ExplainedPeak& peak : explanation.peaks)
    result["peaks"].push_back({{"name", peak.name},
                               {"unit", peak.unit},
                               {"angular_frequency", peak.peak.angular_frequency},
                               {"frequency_hz", peak.peak.angular_frequency / (2 * std::numbers::pi)},
                               {"amplitude", json::number(peak.peak.amplitude)},
                               {"unbounded", std::isinf(peak.peak.amplitude)},
                               {"nearest_mode", json::optional(peak.peak.nearest_mode)},
                               {"sentence", peak.sentence},
                               {"shares", shares_json(variant, explanation, peak.shares)},
                               {"sensitivities", sensitivities_json(explanation, peak)},
                               {"trial", trial_json(peak.trial)},
                               {"notes", peak.notes}});
  return json::text(result, 1) + "\n";
}

std::string explain_csv(const study::Explanation& explanation) {
  const auto number = [](const std::optional<double>& value) {
    return value ? fmt::format("{}", *value) : std::string();
  };
  std::string text =
      "name,unit,angular_frequency [rad/s],amplitude,parameter,change,relative height change,relative frequency "
      "change\n";
  for (const study::ExplainedPeak& peak : explanation.peaks)
    for (const response::Sensitivity& s : peak.sensitivities) {
      const response::Parameter& parameter = explanation.parameters[s.parameter];
      const auto changed = [&](const std::optional<double>& slope) {
        return slope ? std::optional(*slope * parameter.size) : std::nullopt;
      };
      text += fmt::format("{},{},{},{},{},{},{},{}\n", csv_field(peak.name), csv_field(peak.unit),
                          peak.peak.angular_frequency, peak.peak.amplitude, csv_field(parameter.name),
                          csv_field(parameter.change), number(changed(s.height)), number(changed(s.frequency)));
    }
  return text;
}

namespace {

constexpr std::size_t most_levers = 12;
constexpr double worth_an_element = 0.005;

std::string rounded_percent(double share) {
  return fmt::format("{:.1f} %", std::abs(share) < 5e-4 ? 0.0 : 100 * share);
}

/// A text wrapped to the width of a screen, with all lines after the first indented.
std::string wrapped(const std::string& text) {
  constexpr std::size_t width = 118;
  std::string lines, line;
  std::size_t from = 0;
  while (from < text.size()) {
    const std::size_t space = std::min(text.find(' ', from), text.size());
    const std::string word = text.substr(from, space - from);
    if (!line.empty() && line.size() + word.size() > width) {
      lines += line + "\n";
      line = "    " + word;
    } else {
      line += (line.empty() ? "" : " ") + word;
    }
    from = space + 1;
  }
  return lines + line + "\n";
}

std::string change(const std::optional<double>& slope, double size) {
  return slope ? fmt::format("{:+.3g} %", 100 * *slope * size) : "–";
}

std::string modes_table(const study::Explanation& explanation, const study::ExplainedPeak& peak) {
  TextTable table({"mode", "share of the amplitude", "motion"});
  int rows = 0;
  for (const response::ModeShare& mode : peak.shares.modes) {
    if (std::abs(mode.share) < worth_an_element) continue;
    table.add({std::to_string(mode.mode), rounded_percent(mode.share), explanation.modes.list[mode.mode - 1].name});
    ++rows;
  }
  if (std::abs(peak.shares.beyond_modes) >= worth_an_element)
    table.add({"", rounded_percent(peak.shares.beyond_modes), "beyond the undamped modes"});
  return rows > 0 ? table.text() : "";
}

std::string elements_table(const project::Case& variant, const study::ExplainedPeak& peak) {
  TextTable table({"element", "strain energy", "along x", "y", "z", "about x", "y", "z", "dissipated"});
  const response::PeakShares shares = response::of_positive_parts(peak.shares);
  for (std::size_t e = 0; e < shares.elements.size(); ++e) {
    std::vector<std::string> row = {variant.system.elements()[e].name, rounded_percent(shares.elements[e].stored)};
    for (const double direction : shares.elements[e].by_direction) row.push_back(rounded_percent(direction));
    row.push_back(rounded_percent(shares.elements[e].dissipated));
    table.add(row);
  }
  if (std::abs(shares.geometric) >= worth_an_element)
    table.add({"geometric stiffness (preload, weight)", rounded_percent(shares.geometric), "", "", "", "", "", "", ""});
  if (std::abs(shares.in_foundations) >= worth_an_element || std::abs(shares.by_foundations) >= worth_an_element)
    table.add({"foundations", rounded_percent(shares.in_foundations), "", "", "", "", "", "",
               rounded_percent(shares.by_foundations)});
  if (std::abs(shares.system_damping) >= worth_an_element)
    table.add({"damping of the whole system", "", "", "", "", "", "", "", rounded_percent(shares.system_damping)});
  return table.text();
}

std::string levers_table(const study::Explanation& explanation, const study::ExplainedPeak& peak) {
  TextTable table({"parameter", "change", "height", "frequency"});
  for (std::size_t i = 0; i < std::min(peak.sensitivities.size(), most_levers); ++i) {
    const response::Sensitivity& s = peak.sensitivities[i];
    const response::Parameter& parameter = explanation.parameters[s.parameter];
    table.add(
        {parameter.name, parameter.change, change(s.height, parameter.size), change(s.frequency, parameter.size)});
  }
  std::string text = table.text();
  if (peak.sensitivities.size() > most_levers)
    text +=
        fmt::format("  (the strongest {} of {}; --csv or --json lists all)\n", most_levers, peak.sensitivities.size());
  return text;
}

}  // namespace

std::string explain_text(const project::Case& variant, const study::Explanation& explanation) {
  std::string text;
  for (const auto& problem : explanation.warnings.list()) text += foundation::message(problem) + "\n";
  for (const std::string& note : explanation.notes) text += "note: " + note + "\n";
  if (!text.empty()) text += "\n";
  if (explanation.peaks.empty()) return text + "No resonance peaks: nothing to explain\n";
  for (const study::ExplainedPeak& peak : explanation.peaks) {
    text += wrapped(peak.sentence + sentence_note(variant.display));
    text += modes_table(explanation, peak) + elements_table(variant, peak) + levers_table(explanation, peak);
    for (const std::string& note : peak.notes) text += "  note: " + note + "\n";
    text += "\n";
  }
  text +=
      "Energy by direction: deformation at the elastic centre of each element, in its local axes. Changes are to first "
      "order, from exact slopes; a moved element keeps its stiffness.\n";
  if (explanation.left_out > 0)
    text += fmt::format("{} further {} not explained; --of NAME selects one result, --most N shows more\n",
                        explanation.left_out, explanation.left_out == 1 ? "peak" : "peaks");
  return text;
}

}  // namespace trivet::results
