// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/design/robust_parts.h"

#include <fmt/format.h>

#include <vector>

#include "trivet/results/design/optimization_results.h"
#include "trivet/results/design/sample_document.h"
#include "trivet/results/design/sample_words.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/results/format/json_parts.h"

namespace trivet::results {
namespace {

using study::Optimization;
using study::RobustOptimum;

struct MachinesOfDesign {
  const char* name;
  const char* words;
  const study::SampledDesign* design;
};

Table compared_designs(const RobustOptimum& robust) {
  std::vector<MachinesOfDesign> list = {{"given", "given design", &robust.given},
                                        {"nominal", "optimum without tolerances", &robust.nominal},
                                        {"optimum", "optimum within tolerances", &robust.found}};
  const Rows row(std::move(list));
  Table table{.key = "sampled_designs",
              .title = "Machines within the tolerances:",
              .rows = row.size(),
              .columns = {row("design", Kind::words, "", &MachinesOfDesign::name, {.forms = in_json | in_csv}),
                          row("design", Kind::words, "design", &MachinesOfDesign::words, {.forms = for_people}),
                          row("kept_margin", Kind::number, "least margin of " + robust_subject(robust),
                              [](const MachinesOfDesign& one) { return one.design->kept; }, {.digits = 4})},
              .mark = [&robust](std::size_t i) { return i == 2 && !robust.held ? Mark::bad : Mark::plain; }};
  if (!robust.wanted) return table;
  table.columns.push_back(
      row("yield", Kind::words, "",
          [&robust](const MachinesOfDesign& one) { return yield_json(*one.design->yield, robust.wanted); },
          {.forms = in_json}));
  table.columns.push_back(row("yield", Kind::words, "meet every requirement",
                              [](const MachinesOfDesign& one) { return yield_words(*one.design->yield); },
                              {.forms = for_people}));
  return table;
}

Table kept_margins(const Optimization& found) {
  using study::KeptMargin;
  const Rows row(found.robust->margins);
  return {
      .key = "kept_margins",
      .title = "Margins of the optimum:",
      .rows = row.size(),
      .columns = {
          row("case", Kind::words, "",
              [&found](const KeptMargin& one) { return found.after[one.result_case].case_name; },
              {.forms = for_programs}),
          row("requirement", Kind::words, "", &KeptMargin::words, {.forms = for_programs}),
          row("requirement", Kind::words, "requirement",
              [&found](const KeptMargin& one) { return words_in_case(found, one.result_case, one.words_for_people); },
              {.forms = for_people}),
          row("nominal", Kind::number, "of the design", &KeptMargin::nominal, {.digits = 4}),
          row("kept", Kind::number, "of " + robust_subject(*found.robust) + ", each alone", &KeptMargin::kept,
              {.digits = 4}),
          row("has_reserve", Kind::yes_no, "", &KeptMargin::has_reserve),
          row("remark", Kind::words, "remark",
              [](const KeptMargin& one) { return one.has_reserve ? "" : "jumps: the search keeps no reserve"; },
              {.forms = for_people})}};
}

}  // namespace

std::string robust_subject(const RobustOptimum& robust) {
  return robust.wanted ? wanted_words(*robust.wanted) + " of the machines" : "the worst machines found";
}

std::string robust_verdict(const RobustOptimum& robust) {
  if (!robust.wanted)
    return robust.held ? "the worst machines found within the tolerances meet every requirement"
                       : "the worst machines found within the tolerances do NOT meet every requirement";
  return "machines that meet every requirement: " + yield_words(*robust.found.yield, *robust.wanted);
}

void add_robust(const Optimization& found, documents::Document& document) {
  if (!found.robust) return;
  const RobustOptimum& robust = *found.robust;
  const auto note = [&](std::string words) {
    document.add(Sentence{.parts = {std::move(words)}, .place = Sentence::Place::note});
  };
  document.add(Single{.name = "wanted", .value = robust.wanted ? Json(*robust.wanted) : Json("worst case")});
  document.add(Single{.name = "held", .value = robust.held});
  document.add(compared_designs(robust));
  document.add(kept_margins(found));
  if (robust.wanted)
    note(fmt::format("Each yield is that of {} machines with the numbers of seed {}, which the search has not used.",
                     robust.designs, robust.seed));
  else
    note(
        "The worst machines are those that a search found, no proof: a worse one may remain. Numbers without bounds "
        "are "
        "within 99.9 % of their distribution, and correlations do not restrict the search.");
  if (robust.found.failed > 0)
    note(fmt::format("{} {} have no model or cannot be judged ({}); they {}.", robust.found.failed,
                     robust.wanted ? "of these of the optimum" : "of the machines looked at",
                     robust.found.first_failure, robust.wanted ? "meet nothing" : "are worse than any margin"));
  note(fmt::format("{} search{}, each with the reserves that the machines of the last optimum need{}; {}.",
                   robust.rounds, robust.rounds == 1 ? "" : "es",
                   robust.rounds == 1 ? "" : ", later ones from the ends of the one before",
                   robust.settled ? "the last two need the same within 0.1 %"
                                  : "they have not settled, so a better optimum may remain"));
  if (robust.looked_at > 0)
    note(fmt::format("{} designs around them were tried for the margin that the machines keep.", robust.looked_at));
  document.add(Single{.name = "rounds", .value = robust.rounds});
  document.add(Single{.name = "settled", .value = robust.settled});
}

}  // namespace trivet::results
