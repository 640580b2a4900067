// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/design/explanation_text.h"
#include "trivet/results/format/in_documents.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/documents/shown_numbers.h"
#include "trivet/documents/text_table.h"

namespace trivet::results {
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
