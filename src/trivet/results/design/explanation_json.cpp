// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/design/explanation_json.h"
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "trivet/documents/csv_field.h"
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

}  // namespace trivet::results
