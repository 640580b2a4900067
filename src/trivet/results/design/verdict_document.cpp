// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "trivet/results/analyses/operation_words.h"
#include "trivet/results/design/verdict_results.h"
#include "trivet/results/design/verdict_words.h"
#include "trivet/results/format/json_parts.h"
#include "trivet/results/format/shown_words.h"

/// The requirements of a machine with their margins, and its least and largest static values.
namespace trivet::results {
namespace {

using study::CaseVerdict;
using study::RequirementResult;

/// A requirement with the case in which it is judged.
struct JudgedRequirement {
  const CaseVerdict* in;
  const RequirementResult* result;
};

/// Numbers that are not finite are "inf" in CSV and null in JSON.
std::optional<double> or_infinite(const std::optional<double>& value) {
  return value && !std::isfinite(*value) ? std::numeric_limits<double>::infinity() : value;
}

/// [from, to], without an upper end null in its place; null: none.
Json ends(const std::optional<assembly::Band>& band) {
  return band ? Json{json::number(band->from), json::number(band->to)} : Json();
}

/// Frequencies in which a curve is judged.
Json band_of_curve(const RequirementResult& result) {
  using enum study::RequirementKind;
  const bool is_curve = result.kind == amplitude || result.kind == limit_line || result.kind == steady;
  return is_curve && result.band.to > 0 ? ends(result.band) : Json();
}

using Requirements = Rows<JudgedRequirement>;

/// What a column has of the requirement itself: a member, or a function of it.
auto of(auto member) {
  return [member](const JudgedRequirement& one) { return std::invoke(member, *one.result); };
}
/// Words of the requirement in the units of its case.
auto shown(auto words) {
  return [words](const JudgedRequirement& one) { return words(*one.result, one.in->display); };
}

/// Which requirement it is, and its level.
std::vector<Column> subject_columns(const Requirements& row) {
  return {
      row("case", Kind::words, "", [](const JudgedRequirement& one) { return one.in->case_name; }, {.forms = in_csv}),
      row("kind", Kind::words, "", of([](const RequirementResult& r) { return study::name(r.kind); })),
      row("subject", Kind::words, "", of(&RequirementResult::subject)),
      row("requirement", Kind::words, "", of([](const RequirementResult& r) { return r.words_at_level(); }),
          {.forms = in_json | in_csv}),
      row("requirement", Kind::words, "requirement", shown(requirement_words), {.forms = for_people}),
      row("unit", Kind::words, "", of(&RequirementResult::unit)),
      row("level", Kind::words, "",
          of([](const RequirementResult& r) { return *r.level() ? Json(r.level()) : Json(); }),
          {.forms = in_json | in_csv})};
}

/// Bound and value, where it occurs, and the margin.
std::vector<Column> value_columns(const Requirements& row, const std::function<Kind(std::size_t)>& kind_in_row) {
  const auto numbers = [&kind_in_row](Column column) {
    column.kind_in_row = kind_in_row;
    return column;
  };
  return {numbers(row("allowed", Kind::quantity, "", of(&RequirementResult::allowed))),
          numbers(row("value", Kind::quantity, "", of([](const RequirementResult& r) { return or_infinite(r.value); }),
                      {.forms = in_json | in_csv})),
          row("value", Kind::number, "value", shown(judged_value), {.forms = for_people}),
          row("shown_requirement", Kind::words, "", shown(requirement_words), {.forms = in_json}),
          row("shown_value", Kind::words, "", shown(judged_value), {.forms = in_json}),
          row("unbounded", Kind::yes_no, "",
              of([](const RequirementResult& r) { return r.value && std::isinf(*r.value); }), {.forms = in_json}),
          row("angular_frequency", Kind::frequency, "",
              of([](const RequirementResult& r) { return or_infinite(r.angular_frequency); })),
          row("time", Kind::quantity, "", of([](const RequirementResult& r) { return or_infinite(r.time); }),
              {.unit = "s"}),
          row("place", Kind::words, "at", shown(judged_place), {.forms = for_people}),
          row("margin", Kind::number, "margin",
              of([](const RequirementResult& r) { return r.value ? or_infinite(r.margin) : std::nullopt; }),
              {.digits = 4})};
}

/// Whether it is met, and the reason.
std::vector<Column> verdict_columns(const Requirements& row) {
  return {row("judged", Kind::yes_no, "", of([](const RequirementResult& r) { return r.value.has_value(); }),
              {.forms = in_json}),
          row("met", Kind::yes_no, "", of(&RequirementResult::met), {.forms = in_json}),
          row("met", Kind::words, "", of([](const RequirementResult& r) { return r.met() ? "true" : "false"; }),
              {.forms = in_csv}),
          row("verdict", Kind::words, "verdict", of(verdict_word), {.forms = for_people}),
          row("detail", Kind::words, "", of(&RequirementResult::detail), {.forms = in_json}),
          row("reason", Kind::words, "", of(&RequirementResult::reason))};
}

/// For programs: where it holds, under which excitations, and its number in the file.
std::vector<Column> scope_columns(const Requirements& row) {
  return {
      row("band", Kind::words, "", of(band_of_curve), {.forms = in_json}),
      row("speed", Kind::words, "", of([](const RequirementResult& r) { return ends(r.speed); }), {.forms = in_json}),
      row("excitations", Kind::words, "", of([](const RequirementResult& r) { return Json(r.excitations); }),
          {.forms = in_json}),
      row("order", Kind::words, "", of([](const RequirementResult& r) { return r.order > 0 ? Json(r.order) : Json(); }),
          {.forms = in_json}),
      row("place", Kind::words, "", of([](const RequirementResult& r) { return Json(r.place); }), {.forms = in_json})};
}

Table requirement_table(const std::vector<const CaseVerdict*>& cases) {
  std::vector<JudgedRequirement> list;
  for (const CaseVerdict* judged : cases)
    for (const RequirementResult& result : judged->results) list.push_back({judged, &result});
  const auto kind_in_row = [list](std::size_t i) { return kind_of_numbers(*list[i].result); };
  const Requirements row(std::move(list));
  Table table{.key = "requirements",
              .file = "verdict.csv",
              .rows = row.size(),
              .csv = {"case", "kind", "subject", "requirement", "unit", "allowed", "value", "angular_frequency [rad/s]",
                      "time [s]", "margin", "met", "reason", "level"},
              .forms = in_json | on_screen | on_page};
  for (std::vector<Column>& columns :
       std::array{subject_columns(row), value_columns(row, kind_in_row), verdict_columns(row), scope_columns(row)})
    std::ranges::move(columns, std::back_inserter(table.columns));
  return table;
}

/// For programs that draw: how much of its limit each element takes.
Table element_table(const CaseVerdict& judged) {
  using study::ElementVerdict;
  const Rows row(judged.elements);
  return {.key = "elements",
          .rows = row.size(),
          .columns = {row("element", Kind::words, "", &ElementVerdict::element),
                      row("governing", Kind::number, "", &ElementVerdict::governing),
                      row("share", Kind::share, "", [](const ElementVerdict& one) { return or_infinite(one.share); })},
          .forms = in_json};
}

Sentence verdict_sentence(const CaseVerdict& judged) {
  const auto& all = judged.results;
  const std::string whose = judged.case_name.empty() ? "Base model" : "Case " + judged.case_name;
  if (all.empty()) return {.parts = {whose + ": nothing to judge"}};
  const auto met = std::ranges::count_if(all, [](const auto& r) { return r.met(); });
  const bool no_other = std::ranges::all_of(all, [](const auto& r) { return !r.value || r.met(); });
  std::string text = fmt::format("{}: {}, {} of {} requirements met", whose,
                                 judged.met()                              ? "meets its requirements"
                                     : judged.not_judged() > 0 && no_other ? "NOT JUDGED completely"
                                                                           : "VIOLATES its requirements",
                                 met, all.size());
  if (judged.not_judged() > 0) text += fmt::format(", {} not judged", judged.not_judged());
  if (judged.governing) {
    const RequirementResult& r = all[*judged.governing];
    text += std::isinf(r.margin)
        ? "; nothing limits it"
        : fmt::format("; governing: {}, margin {:.4g}", requirement_words(r, judged.display), r.margin);
  }
  if (const auto& band = judged.common_band)
    text += fmt::format("; limits over {:.4g} … {:.4g} {}", shown_frequency(judged.display, band->from),
                        shown_frequency(judged.display, band->to), frequency_unit(judged.display));
  return {.parts = {text + (judged.decides ? "" : "; the requirements are not binding in this case")}};
}

/// The requirement that governs the design, in the cases in which it has to hold; null: nothing limits it there.
Json least_margin(const study::Verdict& verdict) {
  const auto found = verdict.governing_case();
  if (!found) return nullptr;
  const CaseVerdict& judged = verdict.cases[*found];
  const double margin = judged.results[*judged.governing].margin;
  if (!std::isfinite(margin)) return nullptr;
  return {{"case", judged.case_name}, {"requirement", *judged.governing}, {"margin", margin}};
}

}  // namespace

Document verdict_document(const CaseVerdict& judged) {
  constexpr unsigned screen_and_page = on_screen | on_page;
  Sentence cause = shown_words(judged.cause);
  cause.place = Sentence::Place::note;
  Document document = {{{verdict_sentence(judged)},
                        {std::move(cause)},
                        {Single{.name = "decides", .value = judged.decides}},
                        {Single{.name = "met", .value = judged.met()}},
                        {Single{.name = "not_judged", .value = judged.not_judged()}},
                        {Single{.name = "governing", .value = json::optional(judged.governing)}},
                        {Single{.name = "cause", .value = study::words_in_si(judged.cause)}}}};
  Table& table = document.add(requirement_table({&judged}));
  table.people_rows = by_margin(judged);
  table.mark = [&judged](std::size_t i) {
    const RequirementResult& result = judged.results[i];
    return !result.value ? Mark::doubt : result.met() ? Mark::plain : Mark::bad;
  };
  document.add(element_table(judged));
  if (judged.operation)
    for (const study::OperatingSpeed& at : judged.operation->speeds) document.add(operation_sentence(at));
  std::vector<std::string> reasons;
  for (const RequirementResult& r : judged.results)
    if (!r.value && std::ranges::find(reasons, r.reason) == reasons.end()) reasons.push_back(r.reason);
  for (const std::string& reason : reasons)
    document.add(
        Sentence{.parts = {"Not judged: " + reason}, .place = Sentence::Place::note, .forms = screen_and_page});
  document.add(
      Sentence{.parts = {"Margin: limit over value, or value over limit where more is better; 1 on the limit."},
               .place = Sentence::Place::note,
               .forms = on_page});
  return document;
}

Document envelope_document(const study::Envelope& envelope) {
  using study::EnvelopeRow;
  using LeftOut = std::pair<std::string, std::string>;
  const unsigned people = envelope.rows.empty() ? 0 : for_people;
  const auto case_name = [](const std::string& name) { return name.empty() ? "base model" : name; };
  const bool has_gaps =
      std::ranges::any_of(envelope.rows, [](const EnvelopeRow& one) { return one.name.ends_with(", gap left"); });
  const Rows row(envelope.rows);
  const Rows left_out(envelope.left_out);
  const auto shown_case = [&](std::string EnvelopeRow::* member) {
    return row("in", Kind::words, "in", [=](const EnvelopeRow& one) { return case_name(one.*member); },
               {.forms = for_people});
  };
  return {
      {{Table{
           .key = "quantities",
           .file = "envelope.csv",
           .rows = row.size(),
           .columns = {row("name", Kind::words, "at rest, over all cases", &EnvelopeRow::name),
                       row("unit", Kind::words, "", &EnvelopeRow::unit),
                       row("least", Kind::quantity, "least", &EnvelopeRow::least, {.digits = 4}),
                       row("least_in", Kind::words, "", &EnvelopeRow::least_in), shown_case(&EnvelopeRow::least_in),
                       row("largest", Kind::quantity, "largest", &EnvelopeRow::largest, {.digits = 4}),
                       row("largest_in", Kind::words, "", &EnvelopeRow::largest_in),
                       shown_case(&EnvelopeRow::largest_in)},
           .csv =
               {{"quantity", "name"}, "unit", "least", {"in case", "least_in"}, "largest", {"in case", "largest_in"}},
           .together = 2}},
       {Table{.key = "left_out",
              .rows = left_out.size(),
              .columns = {left_out("case", Kind::words, "", &LeftOut::first, {.forms = in_json}),
                          left_out("case", Kind::words, "without case",
                                   [=](const LeftOut& one) { return case_name(one.first); }, {.forms = for_people}),
                          left_out("reason", Kind::words, "reason", &LeftOut::second)},
              .forms = in_json | people}},
       {Sentence{
           .parts = {std::string("Every case under its own gravity and constant forces. Compression of a mount is "
                                 "along its axis, deflection without creep.") +
                     (has_gaps ? " The gap left is after the motions that the requirement of the clearance counts; its "
                                 "row says which it does not."
                               : "")},
           .place = Sentence::Place::note,
           .forms = people & on_page}}}};
}

Document whole_verdict(const study::Verdict& verdict) {
  Document document = {{{Single{.name = "met", .value = verdict.met()}},
                        {Single{.name = "least_margin", .value = least_margin(verdict)}}}};
  std::vector<const CaseVerdict*> cases;
  for (const CaseVerdict& judged : verdict.cases) cases.push_back(&judged);
  document.add(requirement_table(cases)).forms = in_csv;
  for (const CaseVerdict& judged : verdict.cases) {
    Group& one = document.add(Group{.key = "cases", .parts = {}, .in_list = true});
    one.parts.push_back({Single{.name = "case", .value = judged.case_name}});
    for (Part& part : verdict_document(judged).parts) one.parts.push_back(std::move(part));
    one.parts.push_back({Single{.name = "warnings", .value = json::warnings(judged.warnings)}});
  }
  document.add(Group{.key = "envelope", .parts = envelope_document(verdict.envelope).parts});
  return document;
}

json::Json json::verdict(const CaseVerdict& judged) { return as_json(verdict_document(judged)); }

json::Json json::envelope(const study::Envelope& envelope) { return as_json(envelope_document(envelope)); }

}  // namespace trivet::results
