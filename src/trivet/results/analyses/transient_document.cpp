// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "trivet/documents/text_table.h"
#include "trivet/results/format/result_writer.h"
#include "trivet/study/analyses/analysis_results.h"

/// Motion in time.
namespace trivet::results {
namespace {

using response::TimeCurve;

Curves time_curves(const response::TransientResponse& found) {
  Curves curves{
      .axis = "time", .unit = "s", .points = found.time, .file = "transient.csv", .axis_columns = {"time [s]"}};
  for (const TimeCurve& c : found.curves) curves.list.push_back({.name = c.name, .unit = c.unit, .values = c.values});
  return curves;
}

Table extreme_table(const response::TransientResponse& found) {
  const Rows row(found.curves);
  const auto extreme = [](response::Extreme TimeCurve::* which) {
    return [which](const TimeCurve& c) -> Json { return {{"value", (c.*which).value}, {"time", (c.*which).time}}; };
  };
  const auto value = [](response::Extreme TimeCurve::* which) {
    return [which](const TimeCurve& c) { return (c.*which).value; };
  };
  const auto time = [](response::Extreme TimeCurve::* which) {
    return [which](const TimeCurve& c) { return (c.*which).time; };
  };
  constexpr unsigned no_json = in_arrays | for_people;
  return {
      .key = "results",
      .axis = "result",
      .title = found.time.size() == 0
          ? std::string()
          : fmt::format("Time history, {} to {} s, {} points", number_text(found.time(0), 4),
                        number_text(found.time(found.time.size() - 1), 4), found.time.size()),
      .rows = row.size(),
      .columns = {row("name", Kind::words, "result", &TimeCurve::name), row("unit", Kind::words, "", &TimeCurve::unit),
                  row("largest", Kind::words, "", extreme(&TimeCurve::largest), {.forms = in_json}),
                  row("smallest", Kind::words, "", extreme(&TimeCurve::smallest), {.forms = in_json}),
                  row("largest", Kind::quantity, "largest", value(&TimeCurve::largest), {.forms = no_json}),
                  row("largest_at", Kind::number, "at", time(&TimeCurve::largest),
                      {.unit = "s", .digits = 5, .forms = no_json}),
                  row("smallest", Kind::quantity, "smallest", value(&TimeCurve::smallest), {.forms = no_json}),
                  row("smallest_at", Kind::number, "at", time(&TimeCurve::smallest),
                      {.unit = "s", .digits = 5, .forms = no_json}),
                  row("rms", Kind::quantity, "rms over the time", &TimeCurve::rms),
                  row.lists("value", "", "", {}, &TimeCurve::values, {.forms = in_json})},
      .arrays = {{"result", "name"}, "unit", "largest", "largest_at", "smallest", "smallest_at", "rms"}};
}

Document transient_document(const project::Case& variant, const study::CaseResults& results) {
  const response::TransientResponse& found = results.transient->response;
  return {{{excited_part(variant, "transient")},
           {time_curves(found)},
           {extreme_table(found)},
           {Sentence{.parts = {"Relative to the position of rest. The extremes are those of the exact motion, also "
                               "between the time points."},
                     .place = Sentence::Place::note,
                     .forms = on_page}},
           {warnings_part(results)}}};
}

}  // namespace

const ResultWriter transient_results = {.document = transient_document, .files = {"transient.csv"}};

}  // namespace trivet::results
