// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/design/optimization_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "trivet/documents/text_table.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/results/design/robust_parts.h"
#include "trivet/results/design/search_parts.h"
#include "trivet/results/design/selection_document.h"

namespace trivet::results {
namespace {

using study::Optimization;

std::string objective_words(const Optimization& found) {
  if (found.falls_short) return "no design looked at meets every requirement. Largest least margin instead";
  if (found.mounts && found.mounts->price)
    return found.mounts->some_met ? "cheapest mounts found, and with these the largest least margin of all requirements"
                                  : "no mounts that were tried meet every requirement. Largest least margin instead";
  if (!found.minimizes)
    return found.robust ? "least margin of " + robust_subject(*found.robust) : "least margin of all requirements";
  if (!found.weights.empty()) {
    std::string words = "weighted sum of the largest amplitudes over the band: ";
    const std::vector<std::string> names = minimized_names(found);
    for (std::size_t i = 0; i < names.size(); ++i)
      words += fmt::format("{}{:.6g} × {}", i ? " + " : "", found.weights[i], names[i]);
    return words + (found.objective_unit.empty() ? ", as shares of their limits" : "");
  }
  if (const auto kind = found.minimized_kind; kind != project::Minimized::amplitude)
    return (kind == project::Minimized::rms             ? "rms of "
                : kind == project::Minimized::isolation ? "transmissibility of "
                                                        : "magnitude at rest of ") +
        foundation::comma_separated(minimized_names(found)) +
        (found.objective_unit.empty() ? ", as a share of its limit" : "");
  return "largest amplitude of " + foundation::comma_separated(minimized_names(found)) + " over the band" +
      (found.objective_unit.empty() ? ", as a share of its limit" : "");
}

}  // namespace

std::string words_in_case(const Optimization& found, std::size_t c, const std::string& words) {
  const std::string& name = found.after[c].case_name;
  return name.empty() ? words : "case " + name + ": " + words;
}

std::vector<std::string> minimized_names(const Optimization& found) {
  std::vector<std::string> names;
  for (const study::MinimizedAmplitude& one : found.minimized)
    if (one.result_case == 0) names.push_back(one.name);
  return names;
}

std::string step_words(const std::optional<study::OptimizedParameter::Step>& step, const Optimization& found) {
  if (!step) return "";
  if (!step->objective) return "not computed";
  const double change = 100 * (*step->objective / found.objective_after - 1);
  constexpr double none = 1e-3, many = 1e3;  // percent
  const std::string words = !std::isfinite(change) ? "∞"
      : std::abs(change) < none                    ? "0 %"
      : std::abs(change) < many                    ? fmt::format("{:+.3g} %", change)
                                                   : fmt::format("{:+.0f} %", change);
  return step->met || !found.feasible ? words : words + ", violates";
}

std::string parameter_remark(const study::OptimizedParameter& p) {
  constexpr double noticeable = 1e-3;  // of the range
  if (p.idle) return "changes nothing here";
  if (p.most - p.least > noticeable * (p.axis.to - p.axis.from))
    return fmt::format("as good, with others changed: {:.4g} … {:.4g}", p.least, p.most);
  return p.at_bound ? "at the end of its range" : "";
}

std::vector<std::string> search_lines(const Optimization& found) {
  const study::SearchStatistics& search = found.search;
  std::vector<std::string> lines = {
      fmt::format("{} of {} starts{} {}; {}", found.cut_short ? search.finished : search.agreeing, search.starts,
                  found.robust ? " of the first search, which ignores the tolerances," : "",
                  found.cut_short    ? "finished"
                      : found.robust ? "reached its optimum"
                                     : "reached this",
                  computed_words(search.evaluations, search.failed, search.first_failure))};
  if (search.stuck > 0) lines.push_back(fmt::format("{} found no usable design.", search.stuck));
  for (const study::OtherOptimum& other : search.others) {
    std::string& line = lines.emplace_back(fmt::format("{} other{} ended at {} with", other.starts,
                                                       other.starts == 1 ? "" : "s", number_text(other.objective)));
    for (std::size_t j = 0; j < other.values.size(); ++j)
      line += fmt::format("{} {} = {:.5g}", j ? "," : "", found.parameters[j].axis.name, other.values[j]);
  }
  lines.push_back(differences_words(search.differenced, search.differences));
  if (search.looked_at > 0)
    lines.push_back(fmt::format("The starts were chosen among {} designs by a fast evaluation that assembles no model.",
                                search.looked_at));
  for (const std::string& family : found.families) lines.push_back("Designs as " + family + ".");
  for (const std::string& reason : found.no_families) lines.push_back("Designs one by one: " + reason + ".");
  return lines;
}

std::string objective_change(const Optimization& found) {
  const std::string before = found.objective_before ? number_text(*found.objective_before) : "not judged";
  const std::string unit = found.objective_unit.empty() ? "" : " " + found.objective_unit;
  std::string text =
      fmt::format("{}: {} → {}{}", objective_words(found), before, number_text(found.objective_after), unit);
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

std::string best_design_words(const Optimization& found) {
  if (found.after.front().results.empty()) return "best design of the search";
  if (found.robust) return robust_verdict(*found.robust);  // its own requirements may be met
  return found.feasible ? "the best design that was found meets every requirement"
                        : "even the best design that was found does not meet every requirement";
}

std::string optimization_headline(const Optimization& found) {
  return objective_change(found) +
      (found.after.front().results.empty() ? ""
           : found.robust                  ? "; " + robust_verdict(*found.robust)
           : found.feasible                ? ", every requirement is met"
                                           : ", NOT every requirement is met");
}

std::string optimization_settings(const Optimization& found) {
  std::string text = found.mounts ? mount_settings(found.mounts->choices, found.mounts->chosen) : "";
  for (const study::OptimizedParameter& p : found.parameters) text += parameter_settings(p.axis, p.best);
  return text;
}

}  // namespace trivet::results
