// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "trivet/results/design/judgements.h"
#include "trivet/results/format/in_documents.h"

/// All verdicts on a design in one table and in sentences.
namespace trivet::results {
namespace {

using Outcome = Judgement::Outcome;

std::string shown_case_name(const std::string& name) { return name.empty() ? "base model" : name; }

/// The same judgement in all cases, by the case that is worst for it.
struct WorstCase {
  const Judgement* worst;
  std::string also;  ///< cases in which it is violated too, but need not be met
};

/// Least for the worst: violated before not judged before met, then by the margin.
bool is_worse(const Judgement& a, const Judgement& b) {
  const auto rank = [](const Judgement& one) {
    static constexpr std::array order = {Outcome::violated, Outcome::violated_no_need, Outcome::not_judged,
                                         Outcome::met};
    return std::ranges::find(order, one.outcome) - order.begin() + (one.decides ? 0 : 4);
  };
  if (rank(a) != rank(b)) return rank(a) < rank(b);
  return a.margin < b.margin;
}

/// Do both judge the same, in whatever case?
bool is_same(const Judgement& a, const Judgement& b) {
  return std::string(a.kind) == b.kind && a.words == b.words &&
      (a.kind != std::string("answer") || a.finding == b.finding);
}

std::vector<WorstCase> worst_cases(const std::vector<Judgement>& list, const std::vector<std::string>& case_names) {
  std::vector<WorstCase> rows;
  for (const Judgement& one : list) {
    auto row = std::ranges::find_if(rows, [&](const WorstCase& known) { return is_same(one, *known.worst); });
    if (row == rows.end()) row = rows.insert(rows.end(), {&one, ""});
    else if (is_worse(one, *row->worst)) row->worst = &one;
  }
  for (WorstCase& row : rows)
    for (const Judgement& one : list)
      if (one.outcome == Outcome::violated_no_need && is_same(one, *row.worst) && &one != row.worst)
        row.also += (row.also.empty() ? "" : ", ") + shown_case_name(case_names[one.shown_case]);
  std::ranges::stable_sort(rows, [](const WorstCase& a, const WorstCase& b) { return is_worse(*a.worst, *b.worst); });
  return rows;
}

const char* outcome_words(const Judgement& one) {
  switch (one.outcome) {
    case Outcome::violated:
      return "VIOLATED";
    case Outcome::not_judged:
      return "NOT JUDGED";
    case Outcome::violated_no_need:
      return "not binding";
    case Outcome::met:
      break;
  }
  return one.decides ? "met" : "met, not binding";
}

}  // namespace

JudgementSentence judgement_sentence(const Judgement& one, const std::string& case_name, bool several) {
  JudgementSentence sentence{.who = !several         ? "The machine"
                                 : case_name.empty() ? "The base model"
                                                     : "Case " + case_name,
                             .verb = "violates",
                             .subject = one.subject,
                             .rest = ""};
  if (one.outcome == Outcome::not_judged) sentence.verb = "is not judged for";
  if (one.outcome == Outcome::met) sentence.verb = "meets";
  if (one.is_of_search) sentence.who = sentence.verb = "";
  if (one.value.empty()) {
    sentence.subject = one.words;
    if (one.is_of_search)
      sentence.subject[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence.subject[0])));
    sentence.rest = one.finding.empty() ? "" : ": " + one.finding;
    return sentence;
  }
  sentence.rest = ": " + one.value + (one.place.empty() ? "" : (one.is_at ? " at " : ", ") + one.place);
  if (!one.bound.empty()) {
    const bool is_least = one.bound.starts_with("≥"), is_most = one.bound.starts_with("≤");
    sentence.rest += (is_most ? ", allowed " : is_least ? ", required " : ", limit: ") + one.bound;
  }
  return sentence;
}

Document judgements_document(const std::vector<Judgement>& list, const std::vector<std::string>& case_names) {
  Document document;
  std::vector<WorstCase> found = worst_cases(list, case_names);
  if (found.empty()) return document;
  const bool several = case_names.size() > 1;
  const bool also = std::ranges::any_of(found, [](const WorstCase& one) { return !one.also.empty(); });
  const std::vector<WorstCase> marked = found;
  const Rows row(std::move(found));
  const auto text = [](std::string Judgement::* member) {
    return [member](const WorstCase& one) { return one.worst->*member; };
  };
  Table table{
      .rows = row.size(),
      .columns = {row("kind", Kind::words, "kind", [](const WorstCase& one) { return std::string(one.worst->kind); }),
                  row("subject", Kind::words, "of", text(&Judgement::subject)),
                  row("bound", Kind::words, "limit", text(&Judgement::bound)),
                  row("value", Kind::words, "value",
                      [](const WorstCase& one) {
                        return one.worst->value.empty() ? one.worst->finding : one.worst->value;
                      }),
                  row("place", Kind::words, "at", text(&Judgement::place)),
                  row("margin", Kind::number, "margin",
                      [](const WorstCase& one) -> std::optional<double> {
                        if (one.worst->outcome == Outcome::not_judged || !(one.worst->margin > 0)) return {};
                        const bool has_value = std::isfinite(one.worst->margin) || !one.worst->value.empty();
                        return has_value ? std::optional(one.worst->margin) : std::nullopt;
                      },
                      {.digits = 3})},
      .mark =
          [marked](std::size_t i) {
            const Outcome outcome = marked[i].worst->outcome;
            return outcome == Outcome::violated  ? Mark::bad
                : outcome == Outcome::not_judged ? Mark::doubt
                : outcome == Outcome::met        ? Mark::plain
                                                 : Mark::minor;
          },
      .records = true,
      .forms = for_people};
  if (several)
    table.columns.push_back(row("case", Kind::words, "worst case", [case_names](const WorstCase& one) {
      return shown_case_name(case_names[one.worst->shown_case]);
    }));
  table.columns.push_back(
      row("verdict", Kind::words, "verdict", [](const WorstCase& one) { return outcome_words(*one.worst); }));
  if (also)
    table.columns.push_back(
        row("also", Kind::words, "also violated, not binding", [](const WorstCase& one) { return one.also; }));
  document.add(std::move(table));
  document.add(
      Sentence{.parts = {"Margin: limit over value, or value over limit where more is better; 1 on the limit."},
               .place = Sentence::Place::note});
  return document;
}

}  // namespace trivet::results
