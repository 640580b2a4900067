// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "trivet/documents/text_table.h"
#include "trivet/foundation/constants.h"
#include "trivet/results/format/result_writer.h"
#include "trivet/study/analyses/analysis_results.h"

/// Root mean squares and spectral densities.
namespace trivet::results {
namespace {

using response::RandomChannel;
using study::RandomResult;

/// ∞ for an unbounded number, NaN if there is none.
double bounded_number(const std::optional<double>& value, bool infinite) {
  return infinite ? std::numeric_limits<double>::infinity() : value.value_or(nothing);
}

double per_hertz(const std::complex<double>& density) { return foundation::two_pi * density.real(); }

Curves densities(const RandomResult& random) {
  Curves curves{.axis = "angular_frequency",
                .unit = "rad/s",
                .points = random.curves.angular_frequency,
                .file = "densities.csv",
                .axis_columns = {"frequency [Hz]"}};
  for (std::size_t i = 0; i < random.response.channels.size(); ++i) {
    const RandomChannel& a = random.response.channels[i];
    curves.list.push_back({.name = a.name + " density",
                           .unit = "(" + a.unit + ")²/(rad/s)",
                           .values = random.curves.density[i],
                           .csv = {{fmt::format("{} [({})²/Hz]", a.name, a.unit), per_hertz}}});
  }
  return curves;
}

Json infinite_numbers(const RandomChannel& a) {
  Json list = Json::array();
  if (a.infinite_rms) list.push_back("rms");
  if (a.infinite_rms_of_derivative) list.push_back("rms_of_derivative");
  if (a.infinite_weighted_rms) list.push_back("weighted_rms");
  return list;
}

Table random_table(const RandomResult& random) {
  const Rows row(random.response.channels);
  const bool weighted = std::ranges::any_of(
      random.response.channels, [](const RandomChannel& a) { return a.weighted_rms || a.infinite_weighted_rms; });
  const auto density = [&random](std::size_t i) {
    std::vector<double> list;
    for (const double s : random.curves.density[i]) list.push_back(per_hertz(s));
    return Numbers(std::move(list));
  };
  const auto remark = [](const RandomChannel& a) { return a.vanishes ? "below round-off" : a.reason; };
  Table table{
      .key = "results",
      .axis = "result",
      .plain_names = true,
      .file = "random.csv",
      .rows = row.size(),
      .columns =
          {row("name", Kind::words, "result", &RandomChannel::name), row("unit", Kind::words, "", &RandomChannel::unit),
           row("rms", Kind::quantity, "rms",
               [](const RandomChannel& a) { return bounded_number(a.rms, a.infinite_rms); }),
           row("three_sigma", Kind::quantity, "3σ",
               [](const RandomChannel& a) { return bounded_number(a.three_sigma, a.infinite_rms); }),
           row("rms_of_derivative", Kind::quantity, "",
               [](const RandomChannel& a) { return bounded_number(a.rms_of_derivative, a.infinite_rms_of_derivative); },
               {.unit = std::string(unit_of_the_row) + "/s"}),
           row("zero_crossings", Kind::number, "upward zero crossings", &RandomChannel::zero_crossings,
               {.unit = "1/s", .digits = 4}),
           row("weighted_rms", Kind::quantity, "",
               [](const RandomChannel& a) { return bounded_number(a.weighted_rms, a.infinite_weighted_rms); },
               {.unit = "m/s², rad/s²", .forms = in_json | in_arrays}),
           row("weighted_rms", Kind::quantity, "",
               [](const RandomChannel& a) { return bounded_number(a.weighted_rms, a.infinite_weighted_rms); },
               {.unit = "@acceleration", .forms = in_csv}),
           row("weighted", Kind::quantity, weighted ? "weighted rms" : "",
               [](const RandomChannel& a) { return bounded_number(a.weighted_rms, a.infinite_weighted_rms); },
               {.unit = "@acceleration", .forms = for_people}),
           row("acceleration", Kind::words, "",
               [](const RandomChannel& a) { return a.unit.starts_with("rad") ? "rad/s²" : "m/s²"; },
               {.forms = for_people}),
           row("infinite", Kind::words, "", infinite_numbers, {.forms = in_json}),
           row("variance_share", Kind::words, "", [](const RandomChannel& a) -> Json { return a.variance_share; },
               {.forms = in_json}),
           row("vanishes", Kind::yes_no, "", &RandomChannel::vanishes, {.forms = in_json | in_arrays}),
           row("estimated_error", Kind::number, "", &RandomChannel::estimated_error, {.forms = in_json | in_arrays}),
           row("reason", Kind::words, "", &RandomChannel::reason, {.forms = in_json | in_arrays}),
           row.lists("density_per_hz", "", "", {}, density, {.forms = in_json}),
           row.lists("variance_share", "", "input", random.inputs, &RandomChannel::variance_share,
                     {.forms = in_csv | in_arrays})},
      .csv = {"name",
              "unit",
              "rms",
              "three_sigma",
              {"rms_of_derivative [unit/s]", "rms_of_derivative"},
              {"zero_crossings [1/s]", "zero_crossings"},
              "weighted_rms",
              {"variance share {}", "variance_share"}},
      .arrays = {{"result", "name"},
                 "unit",
                 "rms",
                 "three_sigma",
                 "rms_of_derivative",
                 "zero_crossings",
                 "weighted_rms",
                 "variance_share",
                 "vanishes",
                 "estimated_error",
                 "reason"}};
  for (std::size_t i = 0; i < random.inputs.size() && random.inputs.size() > 1; ++i)
    table.columns.push_back(row("share " + random.inputs[i], Kind::share, "variance from " + random.inputs[i],
                                [i](const RandomChannel& a) {
                                  return i < a.variance_share.size() && !a.vanishes ? a.variance_share[i] : nothing;
                                },
                                {.forms = for_people}));
  const bool has_remarks = std::ranges::any_of(random.response.channels,
                                               [&](const RandomChannel& a) { return !std::string(remark(a)).empty(); });
  if (has_remarks) table.columns.push_back(row("remark", Kind::words, "remark", remark, {.forms = for_people}));
  return table;
}

/// Method and error of the variances, if any is finite.
std::string accuracy_words(const response::RandomResponse& random) {
  std::vector<double> errors;
  for (const RandomChannel& a : random.channels)
    if (!std::isnan(a.estimated_error)) errors.push_back(a.estimated_error);
  if (errors.empty()) return "no variance is finite";
  return fmt::format("{}, relative error of the {} about {:.1e}{}",
                     random.method == response::RandomMethod::poles ? "exact integration over the poles"
                                                                    : "adaptive quadrature over the poles",
                     errors.size() == random.channels.size() ? "variances" : "finite variances",
                     *std::ranges::max_element(errors), random.remark.empty() ? "" : "; " + random.remark);
}

/// One row per band, one column of root mean squares per result.
Table band_table(const RandomResult& random) {
  const response::RandomBands& found = *random.bands;
  using excitation::FrequencyBand;
  const Rows row(found.bands);
  const std::string width = found.bands.empty() ? "" : name(found.bands.front().width);
  Table table{
      .key = "bands",
      .axis = "band",
      .file = "bands.csv",
      .title = "Root mean square in each " + width + " band",
      .rows = row.size(),
      .columns = {row("midband", Kind::words, "band",
                      [](const FrequencyBand& b) { return fmt::format("{:.4g} Hz", b.nominal_hz()); }),
                  row("nominal_hz", Kind::number, "", &FrequencyBand::nominal_hz,
                      {.unit = "Hz", .forms = in_json | in_arrays}),
                  row("from", Kind::frequency, "", &FrequencyBand::from, {.forms = in_json | in_csv | in_arrays}),
                  row("to", Kind::frequency, "", &FrequencyBand::to, {.forms = in_json | in_csv | in_arrays}),
                  row("rms", Kind::words, "",
                      [&found](std::size_t b) -> Json {
                        Json list = Json::array();
                        for (const std::vector<double>& levels : found.rms) list.push_back(json::number(levels[b]));
                        return list;
                      },
                      {.forms = in_json})},
      .without_rows = "no frequency band"};
  table.csv = {{"midband", "midband"}, {"from [rad/s]", "from"}, {"to [rad/s]", "to"}};
  table.arrays = {{"band", "midband"}, "nominal_hz", "from", "to"};
  for (std::size_t c = 0; c < found.rms.size(); ++c) {
    const RandomChannel& channel = random.response.channels[c];
    table.columns.push_back(row(channel.name, Kind::quantity, channel.name,
                                [&found, c](std::size_t b) { return found.rms[c][b]; },
                                {.unit = channel.unit, .forms = in_csv | in_arrays | for_people}));
    table.csv.push_back({channel.name + " [" + channel.unit + "]", channel.name});
    table.arrays.push_back({channel.name, channel.name});
  }
  return table;
}

/// Vibration total values as JSON objects with the names of the results as keys.
void add_total_values(const std::vector<study::TotalValue>& totals, Document& document) {
  if (totals.empty()) return;
  using study::TotalValue;
  Json values = Json::object(), axes = Json::object();
  for (const TotalValue& total : totals) {
    values[total.name] = total.value;
    axes[total.name] = total.axes;
  }
  const Rows row(totals);
  document.add(Single{.name = "vibration_total_values", .value = values});
  document.add(Single{.name = "vibration_total_axes", .value = axes});
  document.add(
      Table{.axis = "vibration_total",
            .title = "Vibration total values of the weighted accelerations",
            .rows = row.size(),
            .columns = {row("name", Kind::words, "result", &TotalValue::name),
                        row("value", Kind::quantity, "total value", &TotalValue::value, {.unit = "m/s²"}),
                        row("axes", Kind::words, "of",
                            [](const TotalValue& total) { return fmt::format("{}", fmt::join(total.axes, ", ")); },
                            {.forms = for_people})},
            .arrays = {{"vibration_total", "name"}, "value"}});
}

Document random_document(const project::Case&, const study::CaseResults& results) {
  const RandomResult& random = *results.random;
  const response::RandomResponse& found = random.response;
  const auto frequency = [](double omega) { return Quantity{omega, "rad/s", Kind::frequency, 4}; };
  Document document;
  document.add(Sentence{.parts = {"Random response, ", frequency(found.from), " to ", frequency(found.to)}});
  document.add(random_table(random));
  const bool is_coherent = std::ranges::any_of(found.channels, [](const RandomChannel& a) {
    return std::ranges::any_of(a.variance_share, [](double share) { return share < 0 || share > 1; });
  });
  if (is_coherent)
    document.add(Sentence{.parts = {"Excitations are coherent: one that cancels a part of another has a share of the "
                                    "variance below 0 %, and others have more than 100 % together."},
                          .place = Sentence::Place::note});
  if (random.bands) document.add(band_table(random));
  document.add(Sentence{.parts = {accuracy_words(found)}, .place = Sentence::Place::note});
  document.add(Single{.name = "method", .value = response::name(found.method)});
  document.add(Single{.name = "remark", .value = found.remark});
  document.add(Words{.key = "inputs", .axis = "input", .list = random.inputs});
  document.add(Single{.name = "band", .value = {found.from, json::number(found.to)}});
  document.add(densities(random));
  document.add(warnings_part(results));
  add_total_values(random.total_values, document);
  return document;
}

}  // namespace

const ResultWriter random_results = {.document = random_document,
                                     .files = {"random.csv", "densities.csv"},
                                     .optional_file = {"bands.csv", [](const study::CaseResults& results) {
                                                         return results.random->bands.has_value();
                                                       }}};

}  // namespace trivet::results
