// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/results/answer_writer.h"
#include "trivet/results/csv_field.h"
#include "trivet/results/shown_numbers.h"
#include "trivet/results/text_table.h"
#include "trivet/study/orders_answer.h"

/// Run-up and Campbell diagram.
namespace trivet::results {
namespace json {
namespace {

Json orders(const project::Case&, const study::Answers& answers) {
  const response::RunUp& run = answers.find<study::OrdersResult>("orders")->run_up;
  const response::Campbell& campbell = answers.find<study::OrdersResult>("orders")->campbell;
  Json result{{"speed", list(run.speed)},
              {"orders", Json::array()},
              {"overall", Json::array()},
              {"critical_speeds", Json::array()},
              {"campbell", {{"orders", campbell.orders}, {"natural", Json::array()}, {"interference", Json::array()}}},
              {"warnings", warnings(answers.warnings)}};
  for (const response::OrderCurves& order : run.orders) {
    Json curves = Json::array();
    for (const response::Curve& c : order.curves) curves.push_back(curve(c));
    result["orders"].push_back({{"order", order.order}, {"results", std::move(curves)}});
  }
  for (const response::Overall& o : run.overall)
    result["overall"].push_back({{"name", o.name},
                                 {"unit", o.unit},
                                 {"highest_rms", number(o.highest_rms)},
                                 {"highest_rms_at", number(o.highest_rms_at)},
                                 {"rms", list(o.rms)},
                                 {"bound", list(o.bound)}});
  for (const response::CriticalSpeed& c : run.critical)
    result["critical_speeds"].push_back({{"name", run.overall[c.curve].name},
                                         {"unit", run.overall[c.curve].unit},
                                         {"order", c.order},
                                         {"speed", c.speed},
                                         {"angular_frequency", c.angular_frequency},
                                         {"amplitude", number(c.amplitude)},
                                         {"prominence", number(c.prominence)},
                                         {"relative_height", c.relative_height},
                                         {"nearest_mode", optional(c.nearest_mode)}});
  for (const response::NaturalLine& line : campbell.natural)
    result["campbell"]["natural"].push_back({{"angular_frequency", line.angular_frequency},
                                             {"damping_ratio", line.damping_ratio},
                                             {"nearest_mode", optional(line.nearest_mode)}});
  for (const response::Interference& point : campbell.points)
    result["campbell"]["interference"].push_back({{"order", point.order},
                                                  {"speed", point.speed},
                                                  {"angular_frequency", point.angular_frequency},
                                                  {"mode", optional(point.mode)},
                                                  {"modal_force_share", optional(point.modal_force_share)},
                                                  {"excited", point.excited}});
  return result;
}

}  // namespace
}  // namespace json

namespace {

using foundation::two_pi;

/// Revolutions per minute, in this order of operations: CSV files have all digits of it.
double rpm(double omega) { return omega * 60 / two_pi; }

std::string orders_csv(const project::Case&, const study::Answers& answers) {
  const response::RunUp& run = answers.find<study::OrdersResult>("orders")->run_up;
  std::string text = "speed [rad/s],speed [rpm]";
  for (const response::Overall& o : run.overall) text += "," + csv_field(fmt::format("{} rms [{}]", o.name, o.unit));
  for (const response::OrderCurves& order : run.orders)
    for (const response::Curve& c : order.curves)
      text += "," + csv_field(fmt::format("{} order {} [{}]", c.name, order.order, c.unit));
  text += "\n";
  for (std::size_t k = 0; k < run.speed.size(); ++k) {
    text += fmt::format("{},{}", run.speed[k], rpm(run.speed[k]));
    for (const response::Overall& o : run.overall) append_csv_number(text, o.rms(to_index(k)));
    for (const response::OrderCurves& order : run.orders)
      for (const response::Curve& c : order.curves) append_csv_number(text, std::abs(c.value(to_index(k))));
    text += "\n";
  }
  return text;
}

std::string critical_speeds_csv(const project::Case&, const study::Answers& answers) {
  const response::RunUp& run = answers.find<study::OrdersResult>("orders")->run_up;
  std::string text =
      "name,order,speed [rad/s],speed [rpm],angular_frequency [rad/s],amplitude,unit,relative_height,nearest_mode\n";
  for (const response::CriticalSpeed& c : run.critical)
    text += fmt::format("{},{},{},{},{},{},{},{},{}\n", csv_field(run.overall[c.curve].name), c.order, c.speed,
                        rpm(c.speed), c.angular_frequency, csv_number(c.amplitude),
                        csv_field(run.overall[c.curve].unit), c.relative_height, csv_number(c.nearest_mode));
  return text;
}

std::string orders_text(const project::Case&, const study::Answers& answers) {
  constexpr std::size_t most_rows = 40;
  const response::RunUp& run = answers.find<study::OrdersResult>("orders")->run_up;
  std::vector<response::CriticalSpeed> tall;
  for (const response::CriticalSpeed& c : run.critical)
    if (!(c.relative_height < study::listed_height)) tall.push_back(c);
  std::stable_sort(tall.begin(), tall.end(), [](const auto& a, const auto& b) { return a.speed < b.speed; });
  const std::string frequency = frequency_heading(answers.display);
  const auto in_unit = [&](double omega) { return number_text(shown_frequency(answers.display, omega)); };
  TextTable table({"speed [rpm]", "order", frequency, "result", "amplitude", "unit", "of its highest", "nearest mode"});
  for (std::size_t i = 0; i < std::min(most_rows, tall.size()); ++i) {
    const response::CriticalSpeed& c = tall[i];
    const DisplayUnit unit = amplitude_unit(answers.display, run.overall[c.curve].unit);
    table.add({number_text(rpm(c.speed)), number_text(c.order, 4), in_unit(c.angular_frequency),
               run.overall[c.curve].name, number_text(c.amplitude * unit.factor), unit.label(),
               percent(c.relative_height), mode_words(c.nearest_mode)});
  }
  std::string text = "Critical speeds (peaks of single orders above 1 % of the highest peak of the same result)\n" +
      (tall.empty() ? std::string("  none in the range\n") : table.text());
  if (tall.size() > most_rows)
    text += fmt::format("  (the first {} of {}; --csv or --json gives all)\n", most_rows, tall.size());
  TextTable overall({"result", "highest rms of all orders", "at [rpm]", "unit"});
  for (const response::Overall& o : run.overall) {
    const DisplayUnit unit = display_unit(answers.display, o.unit);
    overall.add({o.name, number_text(o.highest_rms * unit.factor), number_text(rpm(o.highest_rms_at)), unit.unit});
  }
  TextTable points({"speed [rpm]", "order", frequency, "mode", "share of the modal force", "excited"});
  for (const response::Interference& p : answers.find<study::OrdersResult>("orders")->campbell.points)
    points.add({number_text(rpm(p.speed)), number_text(p.order, 4), in_unit(p.angular_frequency), mode_words(p.mode),
                p.modal_force_share ? percent(*p.modal_force_share) : "–", p.excited ? "yes" : "no"});
  return text + overall.text() +
      (answers.find<study::OrdersResult>("orders")->campbell.points.empty()
           ? ""
           : "Campbell diagram: intersections of orders and natural frequencies\n" + points.text());
}

void run_up_arrays(const response::RunUp& run, LabelledArrays& list) {
  using response::CriticalSpeed;
  using response::Overall;
  list.view("speed", "rad/s", "speed", run.speed);
  for (const Overall& o : run.overall) {
    list.view(o.name + " rms", o.unit, "speed", o.rms);
    list.view(o.name + " bound", o.unit, "speed", o.bound);
  }
  list.field("order", "1", "order", run.orders, &response::OrderCurves::order);
  for (const response::OrderCurves& order : run.orders)
    for (const response::Curve& c : order.curves) {
      const std::string name = fmt::format("{} order {}", c.name, order.order);
      list.view(name, c.unit, "speed", c.value);
      list.mark_harmonic({name});
    }
  list.texts("result", "result", run.overall, &Overall::name);
  list.texts("result.unit", "result", run.overall, &Overall::unit);
  list.field("result.highest_rms", unit_of_the_row, "result", run.overall, &Overall::highest_rms);
  list.field("result.highest_rms_at", "rad/s", "result", run.overall, &Overall::highest_rms_at);
  const std::string axis = "critical_speed";
  list.count(axis, run.critical.size());
  list.texts(axis + ".name", axis, run.critical, [&](const CriticalSpeed& c) { return run.overall[c.curve].name; });
  list.texts(axis + ".unit", axis, run.critical, [&](const CriticalSpeed& c) { return run.overall[c.curve].unit; });
  list.field(axis + ".order", "1", axis, run.critical, &CriticalSpeed::order);
  list.field(axis + ".speed", "rad/s", axis, run.critical, &CriticalSpeed::speed);
  list.field(axis + ".angular_frequency", "rad/s", axis, run.critical, &CriticalSpeed::angular_frequency);
  list.field(axis + ".amplitude", unit_of_the_row, axis, run.critical, &CriticalSpeed::amplitude);
  list.field(axis + ".prominence", unit_of_the_row, axis, run.critical, &CriticalSpeed::prominence);
  list.field(axis + ".relative_height", "1", axis, run.critical, &CriticalSpeed::relative_height);
  list.column(axis + ".nearest_mode", "1", axis, run.critical, &CriticalSpeed::nearest_mode);
  list.mark_harmonic({axis + ".unit", axis + ".amplitude", axis + ".prominence"});
}

void campbell_arrays(const response::Campbell& campbell, LabelledArrays& list) {
  using response::Interference;
  using response::NaturalLine;
  list.count("natural", campbell.natural.size());
  list.field("natural.angular_frequency", "rad/s", "natural", campbell.natural, &NaturalLine::angular_frequency);
  list.field("natural.damping_ratio", "1", "natural", campbell.natural, &NaturalLine::damping_ratio);
  list.column("natural.nearest_mode", "1", "natural", campbell.natural, &NaturalLine::nearest_mode);
  const std::string axis = "interference";
  list.count(axis, campbell.points.size());
  list.field(axis + ".order", "1", axis, campbell.points, &Interference::order);
  list.field(axis + ".speed", "rad/s", axis, campbell.points, &Interference::speed);
  list.field(axis + ".angular_frequency", "rad/s", axis, campbell.points, &Interference::angular_frequency);
  list.column(axis + ".mode", "1", axis, campbell.points, &Interference::mode);
  list.column(axis + ".modal_force_share", "1", axis, campbell.points, &Interference::modal_force_share);
  list.column(axis + ".excited", "1", axis, campbell.points, &Interference::excited);
}

void orders_arrays(const project::Case&, const study::Answers& answers, LabelledArrays& list) {
  const study::OrdersResult& found = *answers.find<study::OrdersResult>("orders");
  run_up_arrays(found.run_up, list);
  campbell_arrays(found.campbell, list);
}

}  // namespace

const AnswerWriter orders_results = {
    .json = json::orders,
    .tables = {{"orders.csv", orders_csv}, {"critical_speeds.csv", critical_speeds_csv}},
    .text = orders_text,
    .arrays = orders_arrays,
};

}  // namespace trivet::results
