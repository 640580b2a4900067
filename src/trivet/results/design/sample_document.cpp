// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/design/sample_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "trivet/foundation/constants.h"
#include "trivet/results/design/band_parts.h"
#include "trivet/results/design/kept_parts.h"
#include "trivet/results/design/sample_words.h"
#include "trivet/results/design/share_parts.h"
#include "trivet/results/design/verdict_words.h"
#include "trivet/results/design/worst_case_parts.h"
#include "trivet/results/format/json_parts.h"
#include "trivet/results/format/result_writer.h"

namespace trivet::results {
namespace {

using numerics::ConfidenceInterval;
using study::Sample;
using study::SampledCaseResult;
using study::SampledRequirement;
using study::Spread;
using study::Yield;

struct DrawnRequirement {
  const Sample* sample;
  const SampledCaseResult* in;
  const SampledRequirement* result;
};
using DrawnRequirements = Rows<DrawnRequirement>;

std::optional<double> or_none(double number) { return std::isnan(number) ? std::nullopt : std::optional(number); }

/// A number of the spread of the margins.
auto margin(double Spread::* member) {
  return [member](const DrawnRequirement& one) { return or_none(one.result->margin.*member); };
}
/// A number of the spread of the values; none where there are none.
auto value(double Spread::* member) {
  return [member](const DrawnRequirement& one) {
    return one.result->value ? or_none(*one.result->value.*member) : std::nullopt;
  };
}
auto end_of_margins(double numerics::Extremes::* member) {
  return [member](const DrawnRequirement& one) {
    const numerics::Extremes& ends = one.result->margin.extremes;
    return ends.any ? std::optional(ends.*member) : std::nullopt;
  };
}
auto end_of_values(double numerics::Extremes::* member) {
  return [member](const DrawnRequirement& one) {
    return one.result->value ? std::optional(one.result->value->extremes.*member) : std::nullopt;
  };
}
auto interval(double ConfidenceInterval::* member) {
  return [member](const DrawnRequirement& one) { return one.result->yield.interval.*member; };
}

std::uint64_t violating(const Sample& sample) { return sample.request.designs - sample.yield.met - sample.failed; }

/// Of the designs that violate a requirement, the share in which this one has the least margin.
std::optional<double> share_of_first(const DrawnRequirement& one) {
  const std::uint64_t all = violating(*one.sample);
  return all > 0 ? std::optional(static_cast<double>(one.result->first) / static_cast<double>(all)) : std::nullopt;
}

/// Of programs: objects of JSON are those of a case; CSV and arrays have all cases.
constexpr unsigned in_data = in_json | in_csv | in_arrays;

std::vector<Column> subject_columns(const DrawnRequirements& row) {
  const auto given = [](auto words) {
    return [words](const DrawnRequirement& one) { return words(one.result->given); };
  };
  return {
      row("case", Kind::words, "", [](const DrawnRequirement& one) { return one.in->case_name; },
          {.forms = in_csv | in_arrays}),
      row("kind", Kind::words, "", given([](const auto& r) { return study::name(r.kind); }), {.forms = in_data}),
      row("subject", Kind::words, "", given([](const auto& r) { return r.subject; }), {.forms = in_data}),
      row("requirement", Kind::words, "", given([](const auto& r) { return r.words_at_level(); }), {.forms = in_data}),
      row("requirement", Kind::words, "requirement",
          [](const DrawnRequirement& one) { return requirement_words(one.result->given, one.in->display); },
          {.forms = for_people}),
      row("unit", Kind::words, "", given([](const auto& r) { return r.unit; })),
      row("level", Kind::words, "", given([](const auto& r) { return *r.level() ? Json(r.level()) : Json(); }),
          {.forms = in_data}),
      row("allowed", Kind::quantity, "", given([](const auto& r) { return r.allowed; }), {.forms = in_data})};
}

std::vector<Column> yield_columns(const DrawnRequirements& row) {
  const ColumnOptions data = {.forms = in_data};
  return {row("yield", Kind::share, "", interval(&ConfidenceInterval::estimate), data),
          row("yield_from", Kind::share, "", interval(&ConfidenceInterval::from), data),
          row("yield_to", Kind::share, "", interval(&ConfidenceInterval::to), data),
          row(
              "met", Kind::number, "", [](const DrawnRequirement& one) { return one.result->yield.met; }, data),
          row("alone", Kind::words, "met",
              [](const DrawnRequirement& one) {
                const ConfidenceInterval& of = one.result->yield.interval;
                return percent_words(of.estimate, decimals_of(of));
              },
              {.forms = for_people}),
          row(
              "first", Kind::number, "", [](const DrawnRequirement& one) { return one.result->first; }, data),
          row("breaks_first", Kind::share, "breaks first", share_of_first, {.digits = 3})};
}

std::vector<Column> margin_columns(const DrawnRequirements& row) {
  using numerics::Extremes;
  const ColumnOptions shown = {.digits = 4};
  const auto design = [](std::uint64_t Extremes::* member) {
    return [member](const DrawnRequirement& one) { return one.result->margin.extremes.*member; };
  };
  const ColumnOptions data = {.forms = in_data};
  return {row("margin_least", Kind::number, "least margin", end_of_margins(&Extremes::least), shown),
          row("margin_least_design", Kind::number, "", design(&Extremes::least_at), data),
          row("margin_low", Kind::number, "5 %", margin(&Spread::low), shown),
          row("margin_median", Kind::number, "50 %", margin(&Spread::median), shown),
          row("margin_high", Kind::number, "95 %", margin(&Spread::high), shown),
          row("margin_largest", Kind::number, "", end_of_margins(&Extremes::largest), data),
          row("margin_largest_design", Kind::number, "", design(&Extremes::largest_at), data)};
}

/// People read values at the level of the limit.
std::vector<Column> value_columns(const DrawnRequirements& row) {
  using numerics::Extremes;
  std::vector<Column> columns;
  const auto add = [&](const char* name, const char* heading, auto get) {
    columns.push_back(row(name, Kind::quantity, "", get, {.forms = in_data}));
    if (!*heading) return;
    const auto shown = [get](const DrawnRequirement& one) {
      const std::optional<double> value = get(one);
      return value ? value_words(one.result->given, *value, one.in->display) : std::string("–");
    };
    columns.push_back(row(name, Kind::words, heading, shown, {.forms = for_people}));
  };
  add("value_given", "", [](const DrawnRequirement& one) { return one.result->given.value; });
  add("value_least", "", end_of_values(&Extremes::least));
  add("value_low", "value 5 %", value(&Spread::low));
  add("value_median", "50 %", value(&Spread::median));
  add("value_high", "95 %", value(&Spread::high));
  add("value_largest", "", end_of_values(&Extremes::largest));
  add("value_mean", "", [](const DrawnRequirement& one) { return one.result->mean; });
  add("value_deviation", "", [](const DrawnRequirement& one) { return one.result->deviation; });
  return columns;
}

Table requirement_table(const Sample& sample, const std::vector<const SampledCaseResult*>& cases) {
  std::vector<DrawnRequirement> list;
  for (const SampledCaseResult* one : cases)
    for (const SampledRequirement& result : one->requirements) list.push_back({&sample, one, &result});
  const DrawnRequirements row(std::move(list));
  Table table{.key = "requirements", .axis = "requirement", .file = "sample.csv", .rows = row.size()};
  std::vector<const SampledRequirement*> results;
  for (const SampledCaseResult* one : cases)
    for (const SampledRequirement& result : one->requirements) results.push_back(&result);
  for (std::vector<Column>& columns : std::array{subject_columns(row), yield_columns(row), margin_columns(row),
                                                 value_columns(row), worst_columns(std::move(results))})
    std::ranges::move(columns, std::back_inserter(table.columns));
  return table;
}

Json design_json(const std::optional<study::NamedDesign>& design) {
  if (!design) return nullptr;
  return {{"design", design->number}, {"numbers", numbers_json(design->numbers)}};
}

std::string design_words(const study::NamedDesign& design) {
  std::string words = fmt::format("design {}", design.number);
  for (const study::NamedNumber& one : design.numbers)
    words +=
        fmt::format("{}{} = {}", &one == &design.numbers.front() ? ": " : ", ", one.path, one.unit.words(one.value, 5));
  return words;
}

struct ShownYield {
  std::string share, interval;
};

/// "97.3 %" and "97.1 % … 97.5 %"; if all or none of the designs meet the requirements a bound, "≥ 99.97 %", and "".
/// @param wanted  from which the shown numbers differ as the exact ones do: with more digits if they have to
ShownYield shown_yield(const Yield& yield, std::optional<double> wanted) {
  const ConfidenceInterval& of = yield.interval;
  const bool all = yield.met == yield.designs, none = yield.met == 0;
  const double bound = yield.bound_of_all_met(), shown = all ? bound : none ? 1 - bound : of.estimate;
  constexpr int most_decimals = 9;
  const auto stays_beside = [&](double exact, Rounded rounded, int decimals) {
    const double printed = std::stod(rounded_percent(exact, decimals, rounded));
    return !wanted || (printed < 100 * *wanted) == (exact < *wanted);
  };
  int decimals = all || none ? decimals_of(1 - bound) : decimals_of(of);
  while (decimals < most_decimals &&
         !(stays_beside(shown,
                        all        ? Rounded::down
                            : none ? Rounded::up
                                   : Rounded::near,
                        decimals) &&
           (all || none ||
            (stays_beside(of.from, Rounded::down, decimals) && stays_beside(of.to, Rounded::up, decimals)))))
    ++decimals;
  if (all) return {"≥ " + percent_words(bound, decimals, Rounded::down), ""};
  if (none) return {"≤ " + percent_words(1 - bound, decimals, Rounded::up), ""};
  return {percent_words(of.estimate, decimals), interval_words(of, decimals)};
}

std::string words_of(const ShownYield& shown) {
  return shown.share +
      (shown.interval.empty() ? fmt::format(" with {} confidence", confidence_words())
                              : fmt::format(" ({} confidence: {})", confidence_words(), shown.interval));
}

void say(Document& document, std::string words, unsigned forms = for_people) {
  document.add(Sentence{.parts = {std::move(words)}, .forms = forms});
}

std::string yield_sentence(const Sample& sample) {
  const std::uint64_t designs = sample.request.designs;
  return fmt::format(
      "Yield: {}; {} of {} designs meet every requirement.",
      sample.request.yield ? yield_words(sample.yield, *sample.request.yield) : yield_words(sample.yield),
      sample.yield.met == designs ? "all"
          : sample.yield.met == 0 ? "NONE"
                                  : std::to_string(sample.yield.met),
      designs);
}

/// What the worst designs do that were searched or drawn; empty if none was searched.
std::string worst_words(const Sample& sample) {
  std::size_t searched = 0, violated = 0;
  double least = foundation::infinity;
  std::string of;
  for (const SampledCaseResult& one : sample.cases)
    for (const SampledRequirement& result : one.requirements) {
      const std::optional<double> margin = result.worst_margin();
      if (!margin) continue;
      ++searched;
      if (*margin < 1) ++violated;
      if (*margin < least)
        least = *margin, of = requirement_words(result.given, one.display) + in_case_words(one.case_name);
    }
  if (searched == 0) return "";
  return fmt::format("Worst designs found: {} of {} requirements violated; least margin {:.4g}{}{}.", violated,
                     searched, least, of.empty() ? "" : ", of ", of);
}

/// Which requirement decides most of the designs that violate one.
std::string first_words(const Sample& sample) {
  const SampledRequirement* most = nullptr;
  const SampledCaseResult* in = nullptr;
  for (const SampledCaseResult& one : sample.cases)
    for (const SampledRequirement& result : one.requirements)
      if (result.first > 0 && (!most || result.first > most->first)) most = &result, in = &one;
  if (!most) return "";
  return fmt::format("Breaks first: {}{}, in {:.3g} % of the designs that violate a requirement.",
                     requirement_words(most->given, in->display), in_case_words(in->case_name),
                     100 * static_cast<double>(most->first) / static_cast<double>(violating(sample)));
}

void add_failures(const Sample& sample, Document& document) {
  if (sample.failed == 0) return;
  const double share = static_cast<double>(sample.failed) / static_cast<double>(sample.request.designs);
  say(document,
      fmt::format("{} design{} ({:.3g} %) could not be judged and count{} as failed. The first is {}: {}.",
                  sample.failed, sample.failed == 1 ? "" : "s", 100 * share, sample.failed == 1 ? "s" : "",
                  design_words(*sample.first_failed), sample.first_failure));
}

std::string method_words(const Sample& sample) {
  const std::string numbers = sample.request.sobol
      ? fmt::format("Scrambled Sobol numbers in {} replicates", sample.replicates)
      : std::string("Random numbers");
  return fmt::format("{}, seed {}; {} number{} drawn for each design. Quantiles are within 0.1 %. {}", numbers,
                     sample.request.seed, sample.draws, sample.draws == 1 ? "" : "s",
                     sample.yield.of_replicates ? "The interval is Student's, from the differences of the replicates."
                                                : "The interval is Clopper and Pearson's, as of random designs.");
}

/// Of a study that is not complete; a complete one is the same result as without a folder.
void add_partial(const Sample& sample, Document& document) {
  if (!sample.study || sample.study->is_complete()) return;
  const study::StudyProgress& study = *sample.study;
  say(document,
      fmt::format("PARTIAL: {} of {} chunks of the study, {} of {} designs.", study.done, study.chunks,
                  sample.request.designs, study.designs),
      on_screen | on_page);
  Group& group = document.add(Group{.key = "study", .parts = {}});
  const auto add = [&](const char* name, std::uint64_t value) {
    group.parts.push_back({Single{.name = name, .value = value}});
  };
  add("chunks", study.chunks);
  add("done", study.done);
  add("designs", study.designs);
}

std::string case_words(const SampledCaseResult& one) {
  const std::string name = one.case_name.empty() ? "" : "Case " + one.case_name + ": ";
  if (!one.no_kernels.empty())
    return fmt::format("{}{} designs assembled one by one: {}.", name, one.one_by_one, one.no_kernels);
  return fmt::format("{}{} designs judged by kernels, {} assembled one by one; matrices as {}.", name, one.in_kernels,
                     one.one_by_one, one.family);
}

}  // namespace

std::string yield_words(const Yield& yield) { return words_of(shown_yield(yield, std::nullopt)); }

std::string wanted_words(double yield) { return fmt::format("{:.6g} %", 100 * yield); }

std::string yield_words(const Yield& yield, double wanted) {
  using study::YieldVerdict;
  const YieldVerdict verdict = yield.against(wanted);
  return words_of(shown_yield(yield, wanted)) +
      (verdict == YieldVerdict::met            ? ", wanted "
           : verdict == YieldVerdict::violated ? ", NOT the wanted "
                                               : ", NOT certainly the wanted ") +
      wanted_words(wanted);
}

Json yield_json(const Yield& yield, std::optional<double> wanted) {
  const ShownYield shown = shown_yield(yield, wanted);
  return {{"share", yield.interval.estimate},
          {"from", yield.interval.from},
          {"to", yield.interval.to},
          {"met", yield.met},
          {"interval", yield.of_replicates ? "replicates" : "Clopper-Pearson"},
          {"shown_share", shown.share},
          {"shown_interval", shown.interval}};
}

std::vector<std::string> sample_sentences(const Sample& sample) {
  std::vector<std::string> list;
  if (sample.first_of)
    list.push_back(fmt::format("These are the first {} of {} designs: trivet sample judges all of them.",
                               sample.request.designs, *sample.first_of));
  if (sample.worst_is_left_out)
    list.emplace_back(
        "The worst designs are not searched in a report if models are assembled one by one: trivet sample searches "
        "them.");
  list.push_back(yield_sentence(sample));
  if (std::string first = first_words(sample); !first.empty()) list.push_back(std::move(first));
  if (std::string worst = worst_words(sample); !worst.empty()) list.push_back(std::move(worst));
  return list;
}

Document sample_document(const Sample& sample) {
  Document document;
  add_partial(sample, document);
  for (const std::string& words : sample_sentences(sample)) say(document, words);
  const auto add = [&](const char* name, Json value) { document.add(Single{.name = name, .value = std::move(value)}); };
  add("designs", sample.request.designs);
  if (sample.first_of) add("first_of", *sample.first_of);
  add("sampling", sample.request.sobol ? "sobol" : "random");
  add("seed", sample.request.seed);
  add("replicates", sample.replicates);
  add("drawn", sample.draws);
  add("confidence", study::sample_confidence);
  add("quantiles_within", numerics::LogHistogram::relative_error);
  add("yield", yield_json(sample.yield, sample.request.yield));
  if (sample.request.yield) {
    add("wanted", *sample.request.yield);
    const study::YieldVerdict verdict = *sample.yield_verdict();
    add("held", verdict == study::YieldVerdict::undecided ? Json() : Json(verdict == study::YieldVerdict::met));
  }
  add("failed", sample.failed);
  add("first_failed", design_json(sample.first_failed));
  add("first_failure", sample.first_failure);
  add("worst", design_json(sample.worst));
  add("worst_margin", sample.worst ? json::number(sample.worst_margin) : Json());
  add("worst_case", sample.worst ? Json(sample.worst_case) : Json());
  add_failures(sample, document);
  if (sample.worst)
    say(document,
        fmt::format("Least margin {:.4g}{} in {}.", sample.worst_margin, in_case_words(sample.worst_case),
                    design_words(*sample.worst)));
  std::vector<const SampledCaseResult*> cases;
  for (const SampledCaseResult& one : sample.cases) cases.push_back(&one);
  document.add(requirement_table(sample, cases)).forms = in_csv | in_arrays;
  for (const SampledCaseResult& one : sample.cases) {
    Group& group = document.add(Group{.key = "cases", .parts = {}, .in_list = true});
    const auto single = [&](const char* name, Json value) {
      group.parts.push_back({Single{.name = name, .value = std::move(value)}});
    };
    single("case", one.case_name);
    single("in_kernels", one.in_kernels);
    single("one_by_one", one.one_by_one);
    single("no_kernels", one.no_kernels);
    single("family", one.family);
    Table table = requirement_table(sample, {&one});
    table.file.clear();
    table.forms = in_json | on_screen | on_page;
    if (one.requirements.empty()) table.forms = in_json;
    group.parts.push_back({Sentence{.parts = {case_words(one)}, .forms = on_screen | on_page}});
    group.parts.push_back({std::move(table)});
  }
  add_bands(sample, document);
  add_kept_designs(sample, document);
  add_worst_cases(sample, document);
  add_shares(sample, document);
  say(document, method_words(sample), on_screen | on_page);
  return document;
}

Document sample_document(const Sample& sample, const foundation::Problems& warnings) {
  Document document = sample_document(sample);
  document.add(Single{.name = "warnings", .value = json::warnings(warnings)});
  return document;
}

const ResultWriter sample_results = {
    .has_result = [](const project::Case&, const study::CaseResults& results) { return results.sample != nullptr; },
    .document = [](const project::Case&,
                   const study::CaseResults& results) { return sample_document(*results.sample); },
    .files = {"sample.csv", "designs.csv"},
    .optional_file = {"bands.csv", [](const study::CaseResults& results) { return has_bands(*results.sample); }}};

}  // namespace trivet::results
