// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/design/band_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "trivet/results/design/sample_words.h"
#include "trivet/results/design/verdict_words.h"
#include "trivet/results/format/json_parts.h"

namespace trivet::results {
namespace {

using study::SampledBand;
using study::Spread;

/// A band at one frequency.
struct BandRow {
  const study::SampledCaseResult* in;
  const SampledBand* of;
  std::size_t at;

  [[nodiscard]] double frequency() const { return of->angular_frequency[at]; }
  [[nodiscard]] const Spread& spread() const { return of->spread[at]; }
  [[nodiscard]] const numerics::Extremes& extremes() const { return spread().extremes; }
};

/// Frequency, amplitude of the given design, and those of all designs.
std::vector<Column> amplitude_columns(const Rows<BandRow>& row) {
  const ColumnOptions shown = {.digits = 4}, data = {.forms = in_csv};
  const auto of_spread = [](double Spread::* member) {
    return [member](const BandRow& one) { return one.spread().*member; };
  };
  return {
      row("result", Kind::words, "amplitude of", [](const BandRow& one) { return one.of->name; }),
      row("unit", Kind::words, "", [](const BandRow& one) { return one.of->unit; }),
      row("angular_frequency", Kind::frequency, "at", &BandRow::frequency, {.digits = 5}),
      row(
          "given", Kind::amplitude, "in the file", [](const BandRow& one) { return one.of->given[one.at]; }, shown),
      row(
          "least", Kind::amplitude, "", [](const BandRow& one) { return one.extremes().least; }, data),
      row("low", Kind::amplitude, "5 %", of_spread(&Spread::low), shown),
      row("median", Kind::amplitude, "50 %", of_spread(&Spread::median), shown),
      row("high", Kind::amplitude, "95 %", of_spread(&Spread::high), shown),
      row(
          "largest", Kind::amplitude, "largest of all", [](const BandRow& one) { return one.extremes().largest; },
          shown),
      row(
          "least_design", Kind::number, "", [](const BandRow& one) { return one.extremes().least_at; }, data),
      row("largest_design", Kind::number, "in design", [](const BandRow& one) { return one.extremes().largest_at; })};
}

Table worst_table(const study::SampledCaseResult& of) {
  std::vector<BandRow> list;
  for (const SampledBand& band : of.bands) list.push_back({&of, &band, band.worst()});
  const Rows row(std::move(list));
  return {.rows = row.size(), .columns = amplitude_columns(row), .one_prefix = true, .forms = on_screen | on_page};
}

template <typename Number>
Json list_of(const SampledBand& band, const Number& number) {
  std::vector<double> list;
  for (const Spread& one : band.spread) list.push_back(number(one));
  return json::list(list);
}

template <typename Number>
Json designs_of(const SampledBand& band, const Number& number) {
  std::vector<std::uint64_t> list;
  for (const Spread& one : band.spread) list.push_back(number(one));
  return list;
}

Json band_json(const SampledBand& band) {
  Json limits = Json::array();
  for (const study::BandLimit& one : band.limits)
    limits.push_back({{"from", one.band.from}, {"to", json::number(one.band.to)}, {"amplitude", one.amplitude}});
  return {{"result", band.name},
          {"unit", band.unit},
          {"angular_frequency", json::list(band.angular_frequency)},
          {"without", band.without},
          {"given", json::list(band.given)},
          {"least", list_of(band, [](const Spread& one) { return one.extremes.least; })},
          {"low", list_of(band, [](const Spread& one) { return one.low; })},
          {"median", list_of(band, [](const Spread& one) { return one.median; })},
          {"high", list_of(band, [](const Spread& one) { return one.high; })},
          {"largest", list_of(band, [](const Spread& one) { return one.extremes.largest; })},
          {"least_design", designs_of(band, [](const Spread& one) { return one.extremes.least_at; })},
          {"largest_design", designs_of(band, [](const Spread& one) { return one.extremes.largest_at; })},
          {"limits", std::move(limits)}};
}

/// "bands.csv": one row per case, result and frequency.
Table band_table(const study::Sample& sample) {
  std::vector<BandRow> list;
  for (const study::SampledCaseResult& one : sample.cases)
    for (const SampledBand& band : one.bands)
      for (std::size_t f = 0; f < band.spread.size(); ++f) list.push_back({&one, &band, f});
  const Rows row(std::move(list));
  Table table{.file = "bands.csv", .rows = row.size(), .forms = in_csv};
  table.columns = amplitude_columns(row);
  table.columns.insert(table.columns.begin(),
                       row("case", Kind::words, "", [](const BandRow& one) { return one.in->case_name; }));
  table.csv = {"case",  "result",  "unit",         "angular_frequency [rad/s]",
               "given", "least",   "low",          "median",
               "high",  "largest", "least_design", "largest_design"};
  return table;
}

}  // namespace

bool has_bands(const study::Sample& sample) {
  return std::ranges::any_of(sample.cases, [](const study::SampledCaseResult& one) { return !one.bands.empty(); });
}

void add_bands(const study::Sample& sample, Document& document) {
  for (const study::SampledCaseResult& of : sample.cases) {
    if (of.bands.empty()) continue;
    Group& group = document.add(Group{.key = "bands", .parts = {}, .in_list = true});
    const auto say = [&](std::string words) {
      group.parts.push_back({Sentence{.parts = {std::move(words)}, .forms = on_screen | on_page}});
    };
    const SampledBand& first = of.bands.front();
    Json list = Json::array();
    for (const SampledBand& band : of.bands) list.push_back(band_json(band));
    group.parts.push_back({Single{.name = "case", .value = of.case_name}});
    group.parts.push_back({Single{.name = "no_kernels", .value = first.no_kernels}});
    group.parts.push_back({Single{.name = "results", .value = std::move(list)}});
    const std::size_t frequencies = first.angular_frequency.size();
    say(fmt::format(
        "Amplitudes{} of {} designs{}. 5 %, 50 % and 95 % of the designs are below these values:",
        in_case_words(of.case_name), sample.request.designs - sample.failed - first.without,
        frequencies == 1
            ? " at one frequency"
            : fmt::format(", each result at that of {} frequencies where the 95 % value is largest", frequencies)));
    group.parts.emplace_back().content = worst_table(of);
    if (sample.failed > 0)
      say(fmt::format("The {} design{} that could not be judged {} in no band.", sample.failed,
                      sample.failed == 1 ? "" : "s", sample.failed == 1 ? "is" : "are"));
    if (first.without > 0)
      say(fmt::format("{} judged design{} no amplitudes there, and {} in no band; bands do not change the yield.",
                      first.without, first.without == 1 ? " has" : "s have", first.without == 1 ? "is" : "are"));
    if (!first.no_kernels.empty()) say(fmt::format("Bands are those of assembled models: {}.", first.no_kernels));
  }
  if (has_bands(sample)) document.add(band_table(sample));
}

}  // namespace trivet::results
