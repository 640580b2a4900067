// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "trivet/results/format/result_writer.h"
#include "trivet/study/analyses/analysis_results.h"

/// Run-up and Campbell diagram.
namespace trivet::results {
namespace {

using response::RunUp;

Curves run_up_curves(const RunUp& run) {
  Curves curves{.axis = "speed",
                .unit = "rad/s",
                .points = run.speed,
                .file = "orders.csv",
                .axis_columns = {"speed [rad/s]", "speed [rpm]"}};
  for (const response::Overall& o : run.overall) {
    curves.list.push_back({.name = o.name + " rms", .unit = o.unit, .values = o.rms});
    curves.list.push_back({.name = o.name + " bound", .unit = o.unit, .values = o.bound, .forms = in_arrays});
  }
  for (const response::OrderCurves& order : run.orders)
    for (const response::Curve& c : order.curves)
      curves.list.push_back({.name = fmt::format("{} order {}", c.name, order.order),
                             .unit = c.unit,
                             .values = c.value,
                             .harmonic = true});
  return curves;
}

Table order_table(const RunUp& run) {
  using response::OrderCurves;
  const Rows row(run.orders);
  return {.key = "orders",
          .axis = "order",
          .rows = row.size(),
          .columns = {row("order", Kind::number, "", &OrderCurves::order),
                      row("results", Kind::words, "",
                          [](const OrderCurves& order) { return json::curves(order.curves); }, {.forms = in_json})}};
}

Table overall_table(const RunUp& run) {
  using response::Overall;
  const Rows row(run.overall);
  return {.key = "overall",
          .axis = "result",
          .title = "All orders together",
          .rows = row.size(),
          .columns = {row("name", Kind::words, "result", &Overall::name), row("unit", Kind::words, "", &Overall::unit),
                      row("highest_rms", Kind::quantity, "highest rms", &Overall::highest_rms),
                      row("highest_rms_at", Kind::speed, "at", &Overall::highest_rms_at),
                      row.lists("rms", "", "", {}, &Overall::rms, {.forms = in_json}),
                      row.lists("bound", "", "", {}, &Overall::bound, {.forms = in_json})},
          .arrays = {{"result", "name"}, "unit", "highest_rms", "highest_rms_at"}};
}

/// Rows for people: the tall peaks in the order of their speeds.
std::vector<std::size_t> tall_peaks(const RunUp& run) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < run.critical.size(); ++i)
    if (!(run.critical[i].relative_height < study::listed_height)) rows.push_back(i);
  std::ranges::stable_sort(rows, {}, [&](std::size_t i) { return run.critical[i].speed; });
  return rows;
}

Table critical_speeds(const RunUp& run) {
  constexpr double low = 0.2;  // of the highest peak of the same result: of less importance
  using response::CriticalSpeed;
  const Rows row(run.critical);
  const auto curve = [&run](const CriticalSpeed& c) -> const response::Overall& { return run.overall[c.curve]; };
  return {.key = "critical_speeds",
          .axis = "critical_speed",
          .file = "critical_speeds.csv",
          .title = "Critical speeds: peaks of single orders above 1 % of the highest peak of the same result",
          .rows = row.size(),
          .columns = {row("name", Kind::words, "result", [curve](const CriticalSpeed& c) { return curve(c).name; }),
                      row("unit", Kind::words, "", [curve](const CriticalSpeed& c) { return curve(c).unit; }),
                      row("order", Kind::number, "order", &CriticalSpeed::order),
                      row("speed", Kind::speed, "speed", &CriticalSpeed::speed, {.digits = 5}),
                      row("angular_frequency", Kind::frequency, "f", &CriticalSpeed::angular_frequency),
                      row("amplitude", Kind::amplitude, "", &CriticalSpeed::amplitude),
                      row("rms", Kind::quantity, "rms",
                          [](const CriticalSpeed& c) {
                            return c.amplitude * project::level_factor(project::Level::rms);  // as all orders together
                          },
                          {.digits = 4, .forms = for_people}),
                      row("prominence", Kind::amplitude, "", &CriticalSpeed::prominence),
                      row("relative_height", Kind::share, "of its highest", &CriticalSpeed::relative_height),
                      row("nearest_mode", Kind::number, "nearest mode", &CriticalSpeed::nearest_mode)},
          .csv = {"name", "order", "speed [rad/s]", "speed [rpm]", "angular_frequency [rad/s]", "amplitude", "unit",
                  "relative_height", "nearest_mode"},
          .people = {"speed", "order", "angular_frequency", "name", "rms", "relative_height", "nearest_mode"},
          .people_rows = tall_peaks(run),
          .most_rows = 40,
          .height = [&run](std::size_t i) { return run.critical[i].relative_height; },
          .mark = [&run](std::size_t i) { return run.critical[i].relative_height < low ? Mark::minor : Mark::plain; },
          .without_rows = "No critical speed in the range"};
}

Group campbell_diagram(const response::Campbell& campbell) {
  using response::Interference;
  using response::NaturalLine;
  const Rows line(campbell.natural);
  const Rows point(campbell.points);
  return {
      .key = "campbell",
      .parts = {{Single{.name = "orders", .value = campbell.orders}},
                {Table{.key = "natural",
                       .axis = "natural",
                       .rows = line.size(),
                       .columns = {line("angular_frequency", Kind::frequency, "", &NaturalLine::angular_frequency),
                                   line("damping_ratio", Kind::number, "", &NaturalLine::damping_ratio),
                                   line("nearest_mode", Kind::number, "", &NaturalLine::nearest_mode)},
                       .forms = for_programs}},
                {Table{.key = "interference",
                       .axis = "interference",
                       .title = "Campbell diagram: intersections of orders and natural frequencies",
                       .rows = point.size(),
                       .columns = {point("order", Kind::number, "order", &Interference::order),
                                   point("speed", Kind::speed, "speed", &Interference::speed),
                                   point("angular_frequency", Kind::frequency, "f", &Interference::angular_frequency),
                                   point("mode", Kind::number, "mode", &Interference::mode),
                                   point("modal_force_share", Kind::share, "share of the modal force",
                                         &Interference::modal_force_share),
                                   point("excited", Kind::yes_no, "excited", &Interference::excited)},
                       .people = {"speed", "order", "angular_frequency", "mode", "modal_force_share", "excited"},
                       .folded = true}}}};
}

/// Every result at single speeds, all orders together.
Table orders_at(const std::vector<std::vector<study::OperatingValue>>& at) {
  using study::OperatingValue;
  std::vector<OperatingValue> list;
  for (const auto& values : at) list.insert(list.end(), values.begin(), values.end());
  const Rows row(std::move(list));
  return {.key = "at",
          .axis = "single",
          .title = "At single speeds: all orders together",
          .rows = row.size(),
          .columns = {row("speed", Kind::speed, "speed", &OperatingValue::at),
                      row("name", Kind::words, "result", &OperatingValue::name),
                      row("unit", Kind::words, "", &OperatingValue::unit),
                      row("amplitude", Kind::amplitude, "", &OperatingValue::amplitude),
                      row("rms", Kind::quantity, "rms", &OperatingValue::rms),
                      row("bound", Kind::quantity, "", &OperatingValue::bound),
                      row("order", Kind::number, "most in order", &OperatingValue::order)}};
}

Document orders_document(const project::Case&, const study::CaseResults& results) {
  const study::OrdersResult& found = *results.orders;
  Document document{{{run_up_curves(found.run_up)},
                     {order_table(found.run_up)},
                     {overall_table(found.run_up)},
                     {critical_speeds(found.run_up)},
                     {campbell_diagram(found.campbell)}}};
  if (!found.at.empty()) document.add(orders_at(found.at));
  document.add(warnings_part(results));
  return document;
}

}  // namespace

const ResultWriter orders_results = {.document = orders_document, .files = {"orders.csv", "critical_speeds.csv"}};

}  // namespace trivet::results
