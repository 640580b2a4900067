// SPDX-License-Identifier: BSD-3-Clause
#include "cli/answer_tables.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "cli/text_table.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/message_list.h"

namespace trivet::cli {
namespace {

using foundation::two_pi;
constexpr std::size_t most_rows = 60;  // of a characteristic on the screen


std::string strain_words(const project::Case& variant, const modal::Mode& mode) {
  if (!mode.strain_energy_share) return "–";
  Eigen::Index largest = 0;
  const double share = mode.strain_energy_share->maxCoeff(&largest);
  return variant.system.elements()[static_cast<std::size_t>(largest)].name + " " + percent(share);
}

}  // namespace

std::string warnings_text(const study::Answers& answers) {
  std::string text = foundation::message_list(answers.warnings);
  for (const std::string& motion : answers.free_motions) text += "note: " + motion + "\n";
  return text.empty() ? text : text + "\n";
}

std::string modes_text(const project::Case& variant, const study::Answers& answers) {
  TextTable table({"mode", "ω [rad/s]", "f [Hz]", "ω² [rad²/s²]", "most strain energy in", "motion"});
  for (const modal::Mode& mode : answers.modes.list) {
    const double omega = mode.angular_frequency.value_or(nothing);
    table.add({std::to_string(mode.number), shown(omega, 9), shown(omega / two_pi, 7), shown(mode.eigenvalue_squared, 9), strain_words(variant, mode),
               mode.name + (mode.repeated ? " (repeated root: one of an orthonormal basis)" : "")});
  }
  return "Undamped modes\n" + table.text();
}

std::string roots_text(const study::Answers& answers) {
  TextTable table({"Re λ [1/s]", "Im λ [rad/s]", "kind", "|λ| [rad/s]", "damping ratio", "nearest mode"});
  for (const modal::Root& root : answers.roots.list)
    table.add({shown(root.eigenvalue.real(), 8), shown(root.eigenvalue.imag(), 8), std::string(modal::name(root.kind)) + (root.exact ? "" : " (approximate)"), shown(root.angular_frequency.value_or(nothing), 8),
               shown(root.damping_ratio.value_or(nothing)), root.nearest_mode ? std::to_string(*root.nearest_mode) : "–"});
  return "Damped roots λ, motion ~ exp(λt)\n" + table.text();
}

std::string response_text(const study::Answers& answers) {
  const study::ResponseAnswer& answer = *answers.response;
  std::vector<std::string> header = {"ω [rad/s]"};
  for (const auto& curve : answer.curves.curves) {
    header.push_back(fmt::format("|{}| [{}]", curve.name, curve.unit));
    header.push_back("phase");
  }
  TextTable table(header);
  const std::size_t count = answer.curves.angular_frequency.size();
  const std::size_t step = (count + most_rows - 1) / most_rows;
  for (std::size_t i = 0; i < count; i += step) {
    std::vector<std::string> row = {shown(answer.curves.angular_frequency[i])};
    for (std::size_t c = 0; c < answer.curves.curves.size(); ++c) {
      row.push_back(shown(std::abs(answer.curves.curves[c].value(static_cast<Eigen::Index>(i)))));
      const double degrees = answer.phase[c](static_cast<Eigen::Index>(i)) * 360 / two_pi;
      row.push_back(std::isnan(degrees) ? "–" : fmt::format("{:.1f}°", degrees));
    }
    table.add(row);
  }
  std::string text = "Amplitude and phase (zero-to-peak; a lag is negative)\n" + table.text();
  if (step > 1) text += fmt::format("  (every {}th of {} frequencies; --csv or --json gives all)\n", step, count);
  text += fmt::format("  backward error ≤ {:.1e} at {} frequencies; second solver at {} of them: difference {:.1e}, allowed {:.1e} (round-off × condition): {}\n",
                      answer.curves.check.worst_backward_error, answer.curves.solves, answer.deep.frequencies, answer.deep.worst_difference, answer.deep.allowed,
                      answer.deep.verdict());
  if (answer.curves.interpolation_error > 0)
    text += fmt::format("  rows between the {} frequencies that were solved are interpolated by a rational model: off by at most {:.1e} of their value where it was tested\n",
                        answer.curves.solves, answer.curves.interpolation_error);
  for (const double omega : answer.curves.check.undefined_at)
    text += fmt::format("  ω = {} rad/s: no steady state exists there (shown as –); {}\n", shown(omega, 9),
                        omega > 0 ? "it is an undamped resonance" : "a body is free to move, or the ground is given by its velocity or acceleration and moves without bound");
  return text;
}

std::string peaks_text(const study::Answers& answers) {
  const response::Peaks& found = answers.peaks->peaks;
  TextTable table({"curve", "ω [rad/s]", "f [Hz]", "amplitude", "unit", "× static", "above minimum", "nearest mode"});
  for (const response::Peak& peak : found.list)
    table.add({found.curves[peak.curve].name, shown(peak.angular_frequency, 9), shown(peak.angular_frequency / two_pi), shown(peak.amplitude, 9), found.curves[peak.curve].unit,
               shown(peak.ratio_to_static.value_or(nothing), 4), std::isinf(response::relative_prominence(peak)) ? "∞" : fmt::format("{:.3g}%", 100 * response::relative_prominence(peak)), peak.nearest_mode ? std::to_string(*peak.nearest_mode) : "–"});
  std::string text = (std::isfinite(found.searched_to) ? fmt::format("Resonance peaks up to {} rad/s\n", shown(found.searched_to, 4)) : std::string("Resonance peaks, 0 < ω < ∞\n")) + (found.list.empty() ? std::string() : table.text());
  for (const response::CurveSummary& curve : found.curves) {
    if (curve.vanishes) text += fmt::format("  {}: zero but for round-off\n", curve.name);
    else if (curve.peaks == 0)
      text += fmt::format("  {}: no resonance peak (prominence above {:g} of its maximum); the maximum is {} {} at ω = {} rad/s\n", curve.name,
                          answers.peaks->min_prominence, shown(curve.highest), curve.unit, shown(curve.highest_at));
  }
  if (std::isfinite(found.searched_to))
    text += fmt::format("  searched from ω = {} to {} rad/s: with elements that depend on frequency in their own way, or with delays, there is no last resonance; a `response.band` that ends higher extends the search, up to the end of the tables\n", shown(found.searched_from, 3), shown(found.searched_to, 4));
  else if (found.searched_from > 0) text += fmt::format("  searched from ω = {} rad/s: below it the free motion rules\n", shown(found.searched_from, 3));
  return text;
}

std::string static_text(const study::Answers& answers) {
  TextTable table({"result", "value", "unit"});
  for (const response::StaticValue& value : answers.statics->values) table.add({value.name, shown(value.value, 9), value.unit});
  return "Static displacements and forces\n" + table.text();
}

std::string limits_text(const study::Answers& answers) {
  if (answers.limits.empty()) return "";
  TextTable table({"limit on", "allowed", "largest in band", "at ω [rad/s]", "largest anywhere", "unit", "verdict"});
  for (const study::LimitAnswer& limit : answers.limits)
    table.add({limit.name, shown(limit.limit), shown(limit.in_band), shown(limit.in_band_at), shown(limit.anywhere), limit.unit, limit.kept ? "kept" : "EXCEEDED"});
  return "Limits\n" + table.text();
}

std::string checks_text(const std::vector<results::CheckLine>& lines) {
  TextTable table({"thing", "check", "figure", "verdict"});
  for (const results::CheckLine& line : lines) table.add({line.subject, line.what, line.value, line.passed ? "ok" : "FAILED"});
  return table.text();
}

}  // namespace trivet::cli
