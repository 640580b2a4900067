// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/design/kept_parts.h"

#include <optional>
#include <utility>

#include "trivet/results/design/sample_words.h"
#include "trivet/results/design/verdict_words.h"
#include "trivet/results/format/json_parts.h"

namespace trivet::results {
namespace {

using study::KeptDesign;
using study::Sample;
using study::VariedNumber;

const char* reason_word(KeptDesign::Reason reason) {
  switch (reason) {
    case KeptDesign::Reason::first:
      return "first";
    case KeptDesign::Reason::failing:
      return "failing";
    case KeptDesign::Reason::extreme:
      return "extreme";
  }
  return "";
}

const char* extreme_words(const KeptDesign& one) {
  if (one.has_least_margin) return one.has_largest ? "least and largest margin" : "least margin";
  return one.has_largest ? "largest margin" : "";
}

/// The numbers of the model that vary, in the order of `kept[].numbers`.
Table varied_table(const Sample& sample) {
  const Rows row(sample.kept.numbers);
  return {.key = "kept_numbers",
          .axis = "kept_number",
          .rows = row.size(),
          .columns = {row("path", Kind::words, "", &VariedNumber::path),
                      row("unit", Kind::words, "", &VariedNumber::si_unit),
                      row("drawn", Kind::words, "", [](const VariedNumber& one) { return one.drawn.words(); }),
                      row("given", Kind::number, "", &VariedNumber::given, {.unit = unit_of_the_row})},
          .arrays = {{"kept_number", "path"}, "unit", "drawn", "given"},
          .forms = in_json | in_arrays};
}

std::string words_of(const KeptRequirement& one) {
  return one.of->given.words_at_level() + in_case_words(one.in->case_name);
}

Table kept_table(const Sample& sample) {
  const Rows row(sample.kept.list);
  const std::vector<KeptRequirement> requirements = kept_requirements(sample);
  const auto verdict = [](const KeptDesign& one) {
    return !one.is_judged() ? "not judged" : one.is_met() ? "met" : "violated";
  };
  const auto governing = [requirements](const KeptDesign& one) {
    return one.is_judged() ? words_of(requirements[one.governing()]) : std::string();
  };
  const auto margin = [](const KeptDesign& one) {
    return one.is_judged() ? std::optional(one.margins[one.governing()]) : std::nullopt;
  };
  const ColumnOptions lists = {.forms = in_json | in_arrays};
  Table table{
      .key = "kept",
      .axis = "kept",
      .file = "designs.csv",
      .rows = row.size(),
      .columns = {row("design", Kind::number, "", &KeptDesign::number),
                  row("kept_as", Kind::words, "", [](const KeptDesign& one) { return reason_word(one.reason); }),
                  row("extreme", Kind::words, "", extreme_words), row("verdict", Kind::words, "", verdict),
                  row("governing", Kind::words, "", governing), row("margin", Kind::number, "", margin),
                  row.lists("numbers", "", "kept_number", {}, &KeptDesign::numbers,
                            {.unit = unit_of_the_row, .forms = in_json | in_arrays}),
                  row.lists("margins", "", "requirement", {}, &KeptDesign::margins, lists)},
      .forms = for_programs};
  for (std::size_t n = 0; n < sample.kept.numbers.size(); ++n) {
    const VariedNumber& one = sample.kept.numbers[n];
    table.columns.push_back(row(one.path + (one.si_unit.empty() ? "" : " [" + one.si_unit + "]"), Kind::number, "",
                                [n](const KeptDesign& design) { return design.numbers[n]; }, {.forms = in_csv}));
  }
  for (std::size_t r = 0; r < requirements.size(); ++r)
    table.columns.push_back(row(
        "margin: " + words_of(requirements[r]), Kind::number, "",
        [r](const KeptDesign& design) { return design.is_judged() ? std::optional(design.margins[r]) : std::nullopt; },
        {.forms = in_csv}));
  return table;
}

}  // namespace

std::vector<KeptRequirement> kept_requirements(const Sample& sample) {
  std::vector<KeptRequirement> list;
  for (const study::SampledCaseResult& one : sample.cases)
    for (const study::SampledRequirement& of : one.requirements) list.push_back({&one, &of});
  return list;
}

void add_kept_designs(const Sample& sample, Document& document) {
  document.add(varied_table(sample));
  document.add(kept_table(sample));
}

}  // namespace trivet::results
