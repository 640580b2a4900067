// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "trivet/results/answer_writer.h"
#include "trivet/results/csv_field.h"
#include "trivet/results/shown_numbers.h"
#include "trivet/results/text_table.h"
#include "trivet/study/transient_answer.h"

/// Motion in time.
namespace trivet::results {
namespace json {
namespace {

Json extreme(const response::Extreme& e) { return {{"value", number(e.value)}, {"time", number(e.time)}}; }

Json transient(const project::Case&, const study::Answers& answers) {
  const response::TransientResponse& found = answers.find<study::TransientResult>("transient")->response;
  Json result{{"time", list(found.time)}, {"results", Json::array()}, {"warnings", warnings(answers.warnings)}};
  for (const response::TimeCurve& c : found.curves)
    result["results"].push_back({{"name", c.name},
                                 {"unit", c.unit},
                                 {"largest", extreme(c.largest)},
                                 {"smallest", extreme(c.smallest)},
                                 {"rms", number(c.rms)},
                                 {"value", list(c.values)}});
  return result;
}

}  // namespace
}  // namespace json

namespace {

std::string transient_csv(const project::Case&, const study::Answers& answers) {
  const response::TransientResponse& found = answers.find<study::TransientResult>("transient")->response;
  std::string text = "time [s]";
  for (const response::TimeCurve& c : found.curves) text += "," + csv_field(fmt::format("{} [{}]", c.name, c.unit));
  text += "\n";
  for (Eigen::Index k = 0; k < found.time.size(); ++k) {
    text += csv_number(found.time(k));
    for (const response::TimeCurve& c : found.curves) append_csv_number(text, c.values(k));
    text += "\n";
  }
  return text;
}

std::string transient_text(const project::Case& variant, const study::Answers& answers) {
  const response::TransientResponse& found = answers.find<study::TransientResult>("transient")->response;
  TextTable table({"result", "largest", "at [s]", "smallest", "at [s]", "rms", "unit"});
  LargestOfKind largest;
  for (const response::TimeCurve& c : found.curves)
    for (const double value : {c.largest.value, c.smallest.value}) largest.add(c.unit, value);
  for (const response::TimeCurve& c : found.curves) {
    const DisplayUnit unit = display_unit(variant.display, c.unit);
    const auto shown = [&](double value) { return number_text(largest.shown(c.unit, value) * unit.factor); };
    table.add({c.name, shown(c.largest.value), number_text(c.largest.time, 5), shown(c.smallest.value),
               number_text(c.smallest.time, 5), shown(c.rms), unit.unit});
  }
  const Eigen::Index n = found.time.size();
  return excited_at_once(variant, "transient") +
      fmt::format("Time history, {} to {} s, {} points\n", number_text(found.time(0), 4),
                  number_text(found.time(n - 1), 4), n) +
      table.text();
}

void transient_arrays(const project::Case&, const study::Answers& answers, LabelledArrays& list) {
  using response::TimeCurve;
  const response::TransientResponse& found = answers.find<study::TransientResult>("transient")->response;
  list.view("time", "s", "time", found.time);
  for (const TimeCurve& c : found.curves) list.view(c.name, c.unit, "time", c.values);
  list.texts("result", "result", found.curves, &TimeCurve::name);
  list.texts("result.unit", "result", found.curves, &TimeCurve::unit);
  list.column("result.largest", unit_of_the_row, "result", found.curves,
              [](const TimeCurve& c) { return c.largest.value; });
  list.column("result.largest_at", "s", "result", found.curves, [](const TimeCurve& c) { return c.largest.time; });
  list.column("result.smallest", unit_of_the_row, "result", found.curves,
              [](const TimeCurve& c) { return c.smallest.value; });
  list.column("result.smallest_at", "s", "result", found.curves, [](const TimeCurve& c) { return c.smallest.time; });
  list.field("result.rms", unit_of_the_row, "result", found.curves, &TimeCurve::rms);
}

}  // namespace

const AnswerWriter transient_results = {
    .json = json::transient,
    .tables = {{"transient.csv", transient_csv}},
    .text = transient_text,
    .arrays = transient_arrays,
};

}  // namespace trivet::results
