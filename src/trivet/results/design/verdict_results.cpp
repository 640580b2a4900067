// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/design/verdict_results.h"

#include <fmt/format.h>

#include <cmath>

#include "trivet/documents/csv_field.h"
#include "trivet/documents/shown_numbers.h"
#include "trivet/documents/text_table.h"
#include "trivet/results/design/verdict_words.h"
#include "trivet/results/format/json_parts.h"

namespace trivet::results {
namespace {

using study::CaseVerdict;
using study::RequirementResult;

std::string table_text(const CaseVerdict& judged) {
  TextTable table({"requirement", "value", "at", "margin", "verdict"});
  for (const RequirementRow& row : requirement_rows(judged))
    table.add({row.words, row.value, row.place, row.margin, row.verdict});
  std::string text = table.text();
  for (const std::string& reason : reasons_words(judged)) text += "  not judged: " + reason + "\n";
  return text;
}

}  // namespace

std::string envelope_text(const study::Envelope& envelope) {
  if (envelope.rows.empty()) return "";
  TextTable table({"at rest, over all cases", "least", "in", "largest", "in"});
  const LargestOfKind largest = largest_of(envelope);
  for (const study::EnvelopeRow& row : envelope.rows)
    table.add({row.name, value_text(largest.shown(row.unit, row.least), display_unit(envelope.display, row.unit)),
               case_of_envelope(row.least_in),
               value_text(largest.shown(row.unit, row.largest), display_unit(envelope.display, row.unit)),
               case_of_envelope(row.largest_in)});
  std::string text = table.text();
  for (const auto& [name, reason] : envelope.left_out)
    text += "  without " + case_of_envelope(name) + ": " + reason + "\n";
  return text;
}

std::string envelope_csv(const study::Envelope& envelope) {
  std::string text = "quantity,unit,least,in case,largest,in case\n";
  for (const study::EnvelopeRow& row : envelope.rows)
    text += fmt::format("{},{},{},{},{},{}\n", csv_field(row.name), row.unit, row.least, csv_field(row.least_in),
                        row.largest, csv_field(row.largest_in));
  return text;
}

std::string verdict_text(const study::Verdict& verdict) {
  std::string text;
  for (const CaseVerdict& judged : verdict.cases)
    text += (text.empty() ? "" : "\n") + verdict_summary(judged) + table_text(judged);
  const std::string envelope = envelope_text(verdict.envelope);
  return text + (envelope.empty() ? "" : "\n" + envelope);
}

std::string verdict_csv(const study::Verdict& verdict) {
  std::string text =
      "case,kind,subject,requirement,unit,allowed,value,angular_frequency [rad/s],time [s],margin,met,reason\n";
  const auto cell = [](const std::optional<double>& value) {
    return value && std::isfinite(*value) ? fmt::format("{}", *value) : value ? "inf" : "";
  };
  for (const CaseVerdict& judged : verdict.cases)
    for (const RequirementResult& r : judged.results)
      text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}\n", csv_field(judged.case_name), study::name(r.kind),
                          csv_field(r.subject), csv_field(r.words), r.unit, r.allowed, cell(r.value),
                          cell(r.angular_frequency), cell(r.time), r.value ? cell(r.margin) : "", r.met(),
                          csv_field(r.reason));
  return text;
}

json::Json json::verdict(const CaseVerdict& judged) {
  Json results = Json::array();
  for (const RequirementResult& r : judged.results)
    results.push_back({{"kind", study::name(r.kind)},
                       {"subject", r.subject},
                       {"requirement", r.words},
                       {"unit", r.unit},
                       {"allowed", number(r.allowed)},
                       {"value", r.value ? number(*r.value) : Json(nullptr)},
                       {"unbounded", r.value && std::isinf(*r.value)},
                       {"angular_frequency", optional(r.angular_frequency)},
                       {"time", optional(r.time)},
                       {"margin", r.value ? number(r.margin) : Json(nullptr)},
                       {"judged", r.value.has_value()},
                       {"met", r.met()},
                       {"detail", r.detail},
                       {"reason", r.reason}});
  return {{"decides", judged.decides},
          {"met", judged.met()},
          {"not_judged", judged.not_judged()},
          {"governing", judged.governing ? Json(*judged.governing) : Json(nullptr)},
          {"cause", judged.cause},
          {"requirements", std::move(results)}};
}

json::Json json::envelope(const study::Envelope& envelope) {
  Json rows = Json::array(), left_out = Json::array();
  for (const study::EnvelopeRow& row : envelope.rows)
    rows.push_back({{"name", row.name},
                    {"unit", row.unit},
                    {"least", number(row.least)},
                    {"least_in", row.least_in},
                    {"largest", number(row.largest)},
                    {"largest_in", row.largest_in}});
  for (const auto& [name, reason] : envelope.left_out) left_out.push_back({{"case", name}, {"reason", reason}});
  return {{"quantities", std::move(rows)}, {"left_out", std::move(left_out)}};
}

std::string verdict_json(const study::Verdict& verdict) {
  using json::Json;
  Json cases = Json::array();
  for (const CaseVerdict& judged : verdict.cases) {
    Json one = {{"case", judged.case_name}};
    one.update(json::verdict(judged));
    one["warnings"] = json::warnings(judged.warnings);
    cases.push_back(std::move(one));
  }
  return json::text(
             {{"met", verdict.met()}, {"cases", std::move(cases)}, {"envelope", json::envelope(verdict.envelope)}}, 1) +
      "\n";
}

}  // namespace trivet::results
