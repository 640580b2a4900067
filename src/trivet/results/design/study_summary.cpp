// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/design/study_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "trivet/documents/shown_numbers.h"
#include "trivet/documents/shown_table.h"
#include "trivet/documents/text_table.h"
#include "trivet/foundation/message_list.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/results/analyses/highest_peak.h"
#include "trivet/results/analyses/operation_words.h"
#include "trivet/results/design/judgements.h"
#include "trivet/results/design/map_summary.h"
#include "trivet/results/design/optimization_results.h"
#include "trivet/results/design/sample_document.h"
#include "trivet/results/format/axis_words.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/results/format/shown_words.h"
#include "trivet/study/optimize/design_front.h"
#include "trivet/study/optimize/optimization.h"

namespace trivet::results {
namespace {

using Outcome = Judgement::Outcome;
using Cases = std::vector<study::CaseResults>;

std::string case_name_words(const study::CaseResults& results) {
  return results.case_name.empty() ? "base model" : results.case_name;
}

/// " (case hot)", " (base model, hot, cold)", " (all cases)"; empty if the study has one case.
std::string owners_words(const std::vector<std::size_t>& owners, const Cases& cases) {
  if (cases.size() == 1) return "";
  if (owners.size() == cases.size()) return " (all cases)";
  std::vector<std::string> names;
  for (const std::size_t i : owners) names.push_back(case_name_words(cases[i]));
  const bool one_case = owners.size() == 1 && !cases[owners.front()].case_name.empty();
  return (one_case ? " (case " : " (") + foundation::comma_separated(names) + ")";
}

/// A text that some cases share.
struct Shared {
  std::string text;
  std::vector<std::size_t> cases;
};

void add(std::vector<Shared>& list, const std::string& text, std::size_t which) {
  auto found = std::ranges::find(list, text, &Shared::text);
  if (found == list.end()) found = list.insert(found, {text, {}});
  if (found->cases.empty() || found->cases.back() != which) found->cases.push_back(which);
}

std::string shared_text(const std::vector<Shared>& list, const std::string& mark, const Cases& cases) {
  std::string text;
  for (const Shared& one : list) text += mark + one.text + owners_words(one.cases, cases) + "\n";
  return text;
}

/// Of a case on a map the first finding alone: a map has many rules.
std::string finding_words(const Judgement& one) {
  const std::size_t end = one.kind == std::string("map") ? one.finding.find("; ") : std::string::npos;
  return end == std::string::npos ? one.finding : one.finding.substr(0, end) + "; …";
}

std::string after_colon(const std::string& words) { return words.empty() ? "" : ": " + words; }

/// One requirement in the cases that violate it: on one line, or with one line per case.
std::string judgement_text(const std::vector<const Judgement*>& same, const Cases& cases) {
  constexpr std::size_t most = 12;
  const Judgement& first = *same.front();
  const bool equal = std::ranges::all_of(same, [&](const Judgement* one) { return one->finding == first.finding; });
  if (equal) {
    std::vector<std::size_t> owners;
    for (const Judgement* one : same) owners.push_back(one->shown_case);
    std::ranges::sort(owners);
    return "  " + first.words + after_colon(finding_words(first)) + owners_words(owners, cases) + "\n";
  }
  std::string text = "  " + first.words + "\n";
  std::size_t widest = 0;
  for (const Judgement* one : same) widest = std::max(widest, width_on_screen(case_name_words(cases[one->shown_case])));
  for (std::size_t i = 0; i < std::min(most, same.size()); ++i) {
    const std::string name = case_name_words(cases[same[i]->shown_case]);
    text += "      " + name + std::string(widest - width_on_screen(name) + 3, ' ') + finding_words(*same[i]) + "\n";
  }
  if (same.size() > most) text += fmt::format("      and {} cases more\n", same.size() - most);
  return text;
}

/// Those with this outcome, the least margin first and equal words together.
std::string outcome_text(const std::string& mark, const std::vector<Judgement>& all, Outcome outcome,
                         const Cases& cases) {
  constexpr std::size_t most = 12;
  std::vector<Judgement> list;
  for (const Judgement& one : all)
    if (one.outcome == outcome) list.push_back(one);
  if (list.empty()) return "";
  std::string text = mark + shares_words(all, outcome) + "\n";
  std::ranges::stable_sort(list, [](const auto& a, const auto& b) { return a.margin < b.margin; });
  std::vector<std::vector<const Judgement*>> groups;
  for (const Judgement& one : list) {
    const auto found = std::ranges::find_if(groups, [&](const auto& g) { return g.front()->words == one.words; });
    if (found == groups.end()) groups.push_back({&one});
    else found->push_back(&one);
  }
  for (std::size_t g = 0; g < std::min(most, groups.size()); ++g) text += judgement_text(groups[g], cases);
  if (groups.size() > most) text += fmt::format("  and {} more; --full lists all\n", groups.size() - most);
  return text + "\n";
}

bool is_result(const Judgement& one) { return one.kind == std::string("answer"); }

/// Analyses that are missing or not complete, and checks that failed.
std::string missing_text(const project::Project& project, const std::vector<Judgement>& list, const Cases& cases) {
  std::vector<Shared> failures, failed;
  for (const Judgement& one : list)
    if (is_result(one)) add(failures, one.finding, one.shown_case);
  for (std::size_t i = 0; i < cases.size(); ++i)
    for (const std::string& check : failed_checks(study::check_lines(project.cases[i]), cases[i]))
      add(failed, check, i);
  const std::string text =
      shared_text(failures, "NOT COMPUTED: ", cases) + shared_text(failed, "FAILED CHECK: ", cases);
  return text.empty() ? text : text + "\n";
}

std::string causes_text(const Cases& cases) {
  std::string text;
  for (const study::CaseResults& results : cases)
    if (results.verdict && !results.verdict->cause.empty() && results.verdict->decides &&
        !results.verdict->results[*results.verdict->governing].met())  // whose cause it is
      text += (cases.size() > 1 ? case_name_words(results) + ": " : "") +
          shown_sentence(shown_words(results.verdict->cause), results.display) + "\n\n";
  return text;
}

/// What is wrong, or the least margin.
std::string wrong_text(const project::Project& project, const std::vector<Judgement>& list, const Cases& cases) {
  std::vector<Judgement> judged;
  std::ranges::copy_if(list, std::back_inserter(judged), [](const auto& one) { return !is_result(one); });
  std::string text = outcome_text("VIOLATED: ", judged, Outcome::violated, cases) + causes_text(cases) +
      outcome_text("NOT JUDGED: ", judged, Outcome::not_judged, cases) + missing_text(project, list, cases);
  const std::string elsewhere = outcome_text("Violated in cases in which the requirements are not binding:", judged,
                                             Outcome::violated_no_need, cases);
  if (list.empty()) return text + nothing_judged + "\n\n" + elsewhere;
  const std::size_t wrong = number_with(judged, Outcome::violated) + number_with(judged, Outcome::not_judged);
  if (wrong > 0 || number_with(judged, Outcome::met) == 0) return text + elsewhere;
  text += "MET: " + shares_words(judged, Outcome::met) + elsewhere_words(judged) + "\n";
  if (const Judgement* least = least_of(judged))
    text += "  least margin: " + least->words + after_colon(least->finding) + owners_words({least->shown_case}, cases) +
        "\n";
  return text + "\n" + elsewhere;
}

/// "6 of 6 met", "2 of 6 VIOLATED", "1 of 6 NOT JUDGED": of requirements, limits and rules of maps.
std::string verdict_cell(const std::vector<Judgement>& list, std::size_t which) {
  std::size_t all = 0, violated = 0, no_need = 0, missing = 0;
  for (const Judgement& one : list) {
    if (one.shown_case != which || is_result(one) || one.is_of_search) continue;
    ++all;
    violated += one.outcome == Outcome::violated;
    no_need += one.outcome == Outcome::violated_no_need;
    missing += one.outcome == Outcome::not_judged;
  }
  if (all == 0) return "–";
  if (violated > 0) return fmt::format("{} of {} VIOLATED", violated, all);
  if (missing > 0) return fmt::format("{} of {} NOT JUDGED", missing, all);
  if (no_need > 0) return fmt::format("{} of {} violated, not required", no_need, all);
  return fmt::format("{} of {} met", all, all);
}

/// "0.3128 … 19.82" with the number of rigid-body modes at 0 before it, or UNSTABLE.
std::string frequencies_cell(const project::Case& variant, const study::CaseResults& results) {
  if (!variant.analyses.modes || results.modes.list.empty()) return "–";
  std::vector<double> natural;
  std::size_t rigid = 0;
  for (const modal::Mode& mode : results.modes.list) {
    if (!mode.angular_frequency) return "UNSTABLE";
    if (*mode.angular_frequency > 0) natural.push_back(*mode.angular_frequency);
    else ++rigid;
  }
  std::string text = rigid > 0 ? fmt::format("{} at 0", rigid) : "";
  if (natural.empty()) return text;
  const auto [lowest, highest] = std::ranges::minmax_element(natural);
  text += fmt::format("{}{:.4g}", rigid > 0 ? ", " : "", shown_frequency(results.display, *lowest));
  if (*highest > *lowest) text += fmt::format(" … {:.4g}", shown_frequency(results.display, *highest));
  return text + (results.modes.lowest_only ? ", more above" : "");
}

bool is_not_computed(const study::CaseResults& results, const foundation::Problem& warning) {
  const auto& failures = results.failures;
  return std::ranges::find(failures, warning.subject) != failures.end();
}

std::string cases_text(const project::Project& project, const std::vector<Judgement>& list, const Cases& cases,
                       std::size_t width) {
  const project::DisplayUnits& display = project.base().display;
  std::vector<std::vector<std::string>> rows = {
      {"case", "verdict", "warnings", "modes [" + frequency_unit(display) + "]", "highest peak",
       "largest rms of random", "largest in time", "largest of the shock spectra"}};
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const study::CaseResults& results = cases[i];
    const auto& warnings = results.warnings.list();
    const auto count = std::ranges::count_if(warnings, [&](const auto& w) { return !is_not_computed(results, w); });
    rows.push_back({case_name_words(results), verdict_cell(list, i), count == 0 ? "none" : std::to_string(count),
                    frequencies_cell(project.cases[i], results), highest_peak(results), largest_random(results),
                    largest_in_time(results), largest_of_shocks(results)});
  }
  for (std::size_t c = rows.front().size(); c-- > 0;)
    if (std::all_of(rows.begin() + 1, rows.end(), [&](const auto& row) { return row[c].empty() || row[c] == "–"; }))
      for (auto& row : rows) row.erase(row.begin() + static_cast<std::ptrdiff_t>(c));
  TextTable table(rows.front(), 1, width);
  for (std::size_t r = 1; r < rows.size(); ++r) table.add(rows[r]);
  return table.text() + "\n";
}

std::string best_text(const study::Optimization& found) {
  std::string text = "Best design\n  " + optimization_headline(found) + "\n";
  for (const study::OptimizedParameter& p : found.parameters)
    text += fmt::format("  {} = {}{}{}\n", p.axis.name, axis_value(p.best, p.axis),
                        p.given ? ", given " + axis_value(*p.given, p.axis) : "",
                        parameter_remark(p).empty() ? "" : "; " + parameter_remark(p));
  return text + "\n";
}

std::string front_words(const study::DesignFront& front) {
  std::vector<std::string> names;
  for (const study::FrontObjective& one : front.objectives) names.push_back(one.name);
  return fmt::format("Front of {} between {}{}\n\n", count_words(front.points.size(), "design"),
                     foundation::comma_separated(names),
                     front.knee ? fmt::format("; the knee is design {}", *front.knee + 1) : "");
}

std::string sample_text(const study::Sample& sample) {
  std::string text = "Within tolerances\n";
  for (const std::string& words : sample_sentences(sample)) text += "  " + words + "\n";
  return text + "\n";
}

std::string designs_text(const Cases& cases) {
  std::string text;
  for (const study::CaseResults& results : cases) {
    std::vector<const study::DesignMap*> maps;
    if (results.map) maps.push_back(&*results.map);
    for (const study::DesignMap& map : results.map_pairs) maps.push_back(&map);
    for (const study::DesignMap* map : maps)
      text += fmt::format("Map of {} and {}{}\n  {}\n{}\n", axis_name(map->request.x), axis_name(map->request.y),
                          results.case_name.empty() ? "" : " of case " + results.case_name, feasible_words(*map),
                          map->best ? "  " + best_words(*map) + "\n" : "");
    if (results.optimization) text += best_text(*results.optimization);
    if (results.front) text += front_words(*results.front);
    if (results.sample) text += sample_text(*results.sample);
  }
  return text;
}

/// What happens at the speeds of the machine: an item on each line, or, of many speeds and cases, a line for each.
std::string operation_text(const Cases& cases) {
  constexpr std::size_t few = 2, most = 12;
  std::vector<Shared> list;
  for (std::size_t i = 0; i < cases.size(); ++i)
    if (cases[i].operation)
      for (const study::OperatingSpeed& at : cases[i].operation->speeds)
        add(list, shown_sentence(operation_sentence(at), cases[i].display), i);
  std::string text;
  for (std::size_t k = 0; k < std::min(most, list.size()); ++k) {
    std::string words = list[k].text;
    const std::size_t end = words.find(": ");
    const std::string owners = owners_words(list[k].cases, cases);
    if (list.size() <= few) {
      words.replace(end, 2, owners + "\n  ");
      for (std::size_t at = words.find("; "); at != std::string::npos; at = words.find("; ", at))
        words.replace(at, 2, "\n  ");
    } else {
      words.insert(end, owners);
    }
    text += words + "\n";
  }
  if (list.size() > most) text += fmt::format("  and {} more; --full lists all\n", list.size() - most);
  return text.empty() ? text : text + "\n";
}

/// The warning without the name of its case, which follows it if it is not common to all.
std::string warning_words(const foundation::Problem& problem, const std::string& case_name) {
  std::string text = foundation::message(problem);
  const std::string of_case = "case \"" + case_name + "\": ";
  if (const std::size_t at = text.find(of_case); at != std::string::npos) text.erase(at, of_case.size());
  return text;
}

std::string warnings_and_notes(const Cases& cases) {
  std::vector<Shared> warnings, notes;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    for (const foundation::Problem& warning : cases[i].warnings.list())
      if (!is_not_computed(cases[i], warning)) add(warnings, warning_words(warning, cases[i].case_name), i);
    for (const auto* list : {&cases[i].free_motions, &cases[i].notes})
      for (const std::string& note : *list) add(notes, note, i);
  }
  const std::size_t more = warnings.size() - std::min(warnings.size(), foundation::most_messages);
  warnings.resize(warnings.size() - more);
  const std::string text = shared_text(warnings, "", cases) +
      (more > 0 ? fmt::format("… and {} more\n", count_words(more, "warning")) : "") +
      shared_text(notes, "note: ", cases);
  return text.empty() ? text : text + "\n";
}

}  // namespace

std::string study_summary(const project::Project& project, const std::vector<study::CaseResults>& results,
                          std::size_t width) {
  std::vector<const study::CaseResults*> all;
  for (const study::CaseResults& one : results) all.push_back(&one);
  const std::vector<Judgement> list = judgements(all);
  return wrong_text(project, list, results) + operation_text(results) + cases_text(project, list, results, width) +
      designs_text(results) + warnings_and_notes(results);
}

}  // namespace trivet::results
