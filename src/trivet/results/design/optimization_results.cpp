// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/design/optimization_results.h"
#include "trivet/results/format/in_documents.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numeric>

#include "trivet/documents/csv_field.h"
#include "trivet/documents/text_table.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/project/text/shared_keys.h"
#include "trivet/results/design/selection_results.h"
#include "trivet/results/design/verdict_words.h"
#include "trivet/results/format/axis_words.h"

namespace trivet::results {
namespace {

using study::CaseVerdict;
using study::Optimization;
using study::RequirementResult;

std::string ratio_words(double value) { return std::isinf(value) ? "∞" : fmt::format("{:.6g}", value); }

std::string case_prefix(const CaseVerdict& judged) {
  return judged.case_name.empty() ? "" : "case " + judged.case_name + ": ";
}

std::string objective_words(const Optimization& found) {
  if (found.falls_short) return "no design looked at meets every requirement. Largest least margin instead";
  if (found.mounts && found.mounts->price)
    return found.mounts->some_met ? "cheapest mounts found, and with these the largest least margin of all requirements"
                                  : "no mounts that were tried meet every requirement. Largest least margin instead";
  if (!found.minimizes) return "least margin of all requirements";
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

std::string minimized_text(const Optimization& found) {
  if (found.minimized.empty()) return "";
  TextTable table({"minimised", "given", "optimum", "limit", "unit"});
  for (const study::MinimizedAmplitude& one : found.minimized)
    table.add({case_prefix(found.after[one.result_case]) + one.name, ratio_words(one.before), ratio_words(one.after),
               one.limit ? ratio_words(*one.limit) : "", one.unit});
  return table.text() + "\n";
}

std::string parameters_text(const Optimization& found) {
  const std::string what = found.minimizes ? "minimised" : "margin";
  TextTable table({"parameter", "from", "to", "given", "optimum", what + ": 1 % of range less", "1 % more", ""});
  for (const study::OptimizedParameter& p : found.parameters) {
    const std::string unit = axis_unit(p.axis);
    const auto words = [&](double value) { return fmt::format("{:.6g}{}", value, unit.empty() ? "" : " " + unit); };
    table.add({p.axis.name, words(p.axis.from), words(p.axis.to), p.given ? words(*p.given) : "differ", words(p.best),
               step_words(p.below, found), step_words(p.above, found), parameter_remark(p)});
  }
  return table.text();
}

std::string mounts_words(const study::OptimizedMounts& mounts, const std::vector<std::size_t>& chosen) {
  std::string text;
  for (std::size_t c = 0; c < chosen.size(); ++c)
    text += (c ? ", " : "") + mounts.choices[c].name + " = " + mounts.choices[c].mounts[chosen[c]];
  return text;
}

std::string requirements_text(const Optimization& found) {
  std::string text;
  for (std::size_t c = 0; c < found.after.size(); ++c) {
    const CaseVerdict &before = found.before[c], &after = found.after[c];
    if (after.results.empty()) continue;
    TextTable table({"requirement", "given: margin", "optimum: margin", "verdict"});
    std::vector<std::size_t> order(after.results.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(
        order, [&](std::size_t a, std::size_t b) { return after.results[a].margin < after.results[b].margin; });
    const auto margin = [](const RequirementResult& r) { return r.value ? ratio_words(r.margin) : "not judged"; };
    for (const std::size_t i : order)
      table.add({after.results[i].words, margin(before.results[i]), margin(after.results[i]),
                 !after.results[i].value      ? "NOT JUDGED"
                     : after.results[i].met() ? "met"
                                              : "VIOLATED"});
    text += (after.case_name.empty() ? "Base model\n" : "Case " + after.case_name + "\n") + table.text() + "\n";
  }
  return text;
}

std::string decoupling_text(const std::string& of, const std::vector<study::BodyDecoupling>& before,
                            const std::vector<study::BodyDecoupling>& after) {
  constexpr std::size_t most = 12;
  std::string text;
  for (std::size_t b = 0; b < after.size() && b < most; ++b) {
    const auto same = std::ranges::find_if(before, [&](const auto& one) { return one.body == after[b].body; });
    text += fmt::format("Decoupling of {}, {}least of its modes: given {}, optimum {:.4g} %\n", after[b].body, of,
                        same == before.end() ? "not known" : fmt::format("{:.4g} %", 100 * same->least),
                        100 * after[b].least);
  }
  return after.size() > most ? text + "Decoupling of other bodies: --json\n" : text;
}

std::string frequencies_text(const Optimization& found) {
  const auto list = [](const study::DesignSummary& summary) {
    const std::vector<double>& frequencies = summary.angular_frequencies;
    constexpr std::size_t most = 12;
    std::string text;
    for (std::size_t i = 0; i < frequencies.size() && i < most; ++i)
      text += fmt::format("{}{:.4g}", i ? ", " : "", frequencies[i] / foundation::two_pi);
    return text + (frequencies.size() > most ? ", …" : "");
  };
  std::string text;
  for (std::size_t c = 0; c < found.after.size(); ++c) {
    const std::string of =
        found.after.size() > 1 && found.after[c].case_name.empty() ? "base model: " : case_prefix(found.after[c]);
    text += "Natural frequencies, " + of + "given:   " + list(found.summaries_before[c]) + " Hz\n" +
        "Natural frequencies, " + of + "optimum: " + list(found.summaries_after[c]) + " Hz\n";
    text += decoupling_text(of, found.summaries_before[c].decoupling, found.summaries_after[c].decoupling);
  }
  return text;
}

std::string gone_peaks_text(const Optimization& found) {
  if (found.gone_peaks.empty()) return "";
  TextTable table({"no peak of", "gone by", "nearest to one at"});
  for (const study::GonePeak& one : found.gone_peaks)
    table.add({case_prefix(found.after[one.result_case]) + one.name, fmt::format("{:.4g}", -one.measure),
               fmt::format("{:.4g} Hz", one.angular_frequency / foundation::two_pi)});
  return "The search went on to the design furthest from a peak, by the fall of the curves (docs/design.md):\n" +
      table.text();
}

std::string conditions_text(const Optimization& found) {
  if (!found.no_slopes.empty())
    return "What holds the optimum is not known: there are no slopes next to it (" + found.no_slopes + ").\n";
  if (found.active.empty()) return "Nothing holds the optimum: no requirement limits it.\n" + gone_peaks_text(found);
  TextTable held({"what holds the optimum", "1 % more of its bound brings"});
  for (const study::ActiveRequirement& one : found.active)
    held.add({case_prefix(found.after[one.result_case]) + one.words,
              one.minimized ? "" : fmt::format("{:.3g} %", one.multiplier)});
  std::string text = held.text();
  text += fmt::format("Residual of the optimality conditions: {:.2g} of the largest slope.\n", found.residual);
  if (found.conflicts.empty()) return text;
  text += found.conflicts.size() == 1
      ? "\nThis requirement cannot be met within the ranges, but with its bound eased by the factor:\n"
      : "\nThese requirements contradict each other within the ranges. All can be met with every bound eased by its "
        "factor:\n";
  TextTable table({"requirement", "factor", "least margin of the others without it"});
  for (const study::Conflict& one : found.conflicts)
    table.add({case_prefix(found.after[one.result_case]) + one.words,
               std::isinf(one.factor) ? "∞" : fmt::format("{:.4g}", one.factor), ratio_words(one.without)});
  return text + table.text();
}

}  // namespace

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

std::string optimization_mounts(const Optimization& found) {
  if (!found.mounts) return "";
  const study::OptimizedMounts& mounts = *found.mounts;
  std::string text = "Mounts: " + mounts_words(mounts, mounts.chosen) + "\n";
  if (mounts.price)
    text += fmt::format(
        "Price of all mounts: {} → {}. The numbers of {} of {} combinations were optimised, the cheapest first{}.\n",
        mounts.price_before ? project::price_words(*mounts.price_before) : "not known",
        project::price_words(*mounts.price), mounts.optimized, mounts.combinations,
        mounts.some_met || mounts.optimized == mounts.combinations
            ? ""
            : "; dearer ones were not tried: allow more with combinations");
  else
    text += fmt::format(
        "Best found of {} combinations of mounts: {} were considered with a few numbers, and the numbers of the best "
        "{} optimised.\n",
        mounts.combinations, mounts.considered, mounts.optimized);
  for (const study::OptimizedMounts::Other& other : mounts.others)
    text += fmt::format(
        "  next: {} with {}\n",
        mounts.price ? project::price_words({other.objective, mounts.price->currency}) : ratio_words(other.objective),
        mounts_words(mounts, other.mounts));
  return text;
}

std::string optimization_search(const Optimization& found) {
  std::string text =
      fmt::format("{} of {} starts reached this; {} designs computed", found.agreeing, found.starts, found.evaluations);
  if (found.failed > 0) text += fmt::format(", {} of them without a result ({})", found.failed, found.first_failure);
  text += ".\n";
  if (found.stuck > 0) text += fmt::format("  {} found no usable design\n", found.stuck);
  for (const study::OtherOptimum& other : found.others) {
    text += fmt::format("  {} other{} ended at {} with", other.starts, other.starts == 1 ? "" : "s",
                        ratio_words(other.objective));
    for (std::size_t j = 0; j < other.values.size(); ++j)
      text += fmt::format("{} {} = {:.5g}", j ? "," : "", found.parameters[j].axis.name, other.values[j]);
    text += "\n";
  }
  if (!found.differenced.empty())
    text += fmt::format("Slopes by differences of values: {}; {} more designs computed for them.\n",
                        foundation::comma_separated(found.differenced), found.differences);
  if (found.looked_at > 0)
    text += fmt::format("{} designs looked at before the search, without their models.\n", found.looked_at);
  for (const std::string& family : found.families) text += "Designs as " + family + ".\n";
  for (const std::string& reason : found.no_families) text += "Designs one by one: " + reason + ".\n";
  return text + "A search finds the best of where it looked; it proves no global optimum.\n";
}

std::string optimization_headline(const Optimization& found) {
  const std::string before = found.objective_before ? ratio_words(*found.objective_before) : "not judged";
  const std::string unit = found.objective_unit.empty() ? "" : " " + found.objective_unit;
  std::string text =
      fmt::format("{}: {} → {}{}{}", objective_words(found), before, ratio_words(found.objective_after), unit,
                  found.after.front().results.empty() ? ""
                      : found.feasible                ? ", every requirement is met"
                                                      : ", NOT every requirement is met");
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

std::string optimization_text(const Optimization& found) {
  const std::string mounts = optimization_mounts(found);
  return optimization_headline(found) + "\n\n" + mounts + (mounts.empty() ? "" : "\n") + parameters_text(found) + "\n" +
      minimized_text(found) + requirements_text(found) + frequencies_text(found) + "\n" + conditions_text(found) +
      "\n" + optimization_search(found);
}

std::string optimization_settings(const Optimization& found) {
  std::string text = found.mounts ? mount_settings(found.mounts->choices, found.mounts->chosen) : "";
  for (const study::OptimizedParameter& p : found.parameters)
    for (const project::ParameterPlace& place : p.axis.places)
      text += fmt::format("--set '{} = {}'\n", place.path,
                          p.axis.unit.empty() ? fmt::format("{:.12g}", place.factor * p.best)
                                              : fmt::format("\"{:.12g} {}\"", place.factor * p.best, p.axis.unit));
  return text;
}

std::string optimization_csv(const Optimization& found) {
  std::string text = "parameter,unit,from,to,given,optimum\n";
  for (const study::OptimizedParameter& p : found.parameters)
    text += csv_field(p.axis.name) + "," + csv_field(axis_unit(p.axis)) + "," + csv_number(p.axis.from) + "," +
        csv_number(p.axis.to) + "," + csv_number(p.given) + "," + csv_number(p.best) + "\n";
  for (std::size_t c = 0; found.mounts && c < found.mounts->choices.size(); ++c)
    text += csv_field(found.mounts->choices[c].name) + ",,,,," +
        csv_field(found.mounts->choices[c].mounts[found.mounts->chosen[c]]) + "\n";
  return text;
}

}  // namespace trivet::results
