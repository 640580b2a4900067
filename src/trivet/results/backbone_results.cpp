// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "trivet/documents/csv_field.h"
#include "trivet/documents/shown_numbers.h"
#include "trivet/documents/text_table.h"
#include "trivet/foundation/index.h"
#include "trivet/nonlinear/backbone.h"
#include "trivet/results/answer_writer.h"
#include "trivet/results/motion_numbers.h"
#include "trivet/results/steady_kinds.h"

/// Nonlinear modes.
namespace trivet::results {

using nonlinear::Backbone;
using nonlinear::BackbonePoint;

namespace {

const std::vector<Backbone>& modes_of(const study::Answers& answers) {
  return *answers.find<std::vector<Backbone>>("backbone");
}

/// A point, and the number of its mode from 1.
struct ModeRow {
  double mode;
  const BackbonePoint* point;
};

std::vector<ModeRow> mode_rows(const study::Answers& answers) {
  std::vector<ModeRow> rows;
  for (const Backbone& mode : modes_of(answers))
    for (const BackbonePoint& point : mode.points) rows.push_back({static_cast<double>(mode.mode + 1), &point});
  return rows;
}

}  // namespace

namespace json {
namespace {

Json point(const BackbonePoint& p) {
  Json motions = Json::array();
  for (const nonlinear::ObservedMotion& m : p.results) motions.push_back(motion(m));
  return {{"angular_frequency", p.angular_frequency},
          {"energy", p.energy},
          {"damping_ratio", p.damping_ratio},
          {"deflection", p.deflection},
          {"results", std::move(motions)}};
}

Json backbone(const project::Case&, const study::Answers& answers) {
  Json result{{"modes", Json::array()}, {"warnings", warnings(answers.warnings)}};
  for (const Backbone& found : modes_of(answers)) {
    Json mode{{"mode", found.mode + 1},       {"angular_frequency", found.angular_frequency},
              {"harmonics", found.harmonics}, {"left_out", number(found.left_out)},
              {"ended", found.ended},         {"held", found.held},
              {"results", Json::array()},     {"points", Json::array()}};
    for (std::size_t c = 0; c < found.results.size(); ++c)
      mode["results"].push_back({{"name", found.results[c]}, {"unit", found.units[c]}});
    for (const BackbonePoint& p : found.points) mode["points"].push_back(point(p));
    result["modes"].push_back(std::move(mode));
  }
  return result;
}

}  // namespace
}  // namespace json

namespace {

std::string backbone_csv(const project::Case&, const study::Answers& answers) {
  const Backbone& first = modes_of(answers).front();
  std::string text = "mode,angular_frequency [rad/s],energy [J],damping ratio,deflection [m or rad]";
  for (std::size_t c = 0; c < first.results.size(); ++c)
    for (const MotionNumber& number : motion_numbers)
      text += "," + csv_field(fmt::format("{} {} [{}]", first.results[c], number.name, first.units[c]));
  text += "\n";
  for (const ModeRow& row : mode_rows(answers)) {
    text += fmt::format("{},{},{}", row.mode, row.point->angular_frequency, row.point->energy);
    append_csv_number(text, row.point->damping_ratio);
    append_csv_number(text, row.point->deflection);
    for (const nonlinear::ObservedMotion& motion : row.point->results)
      for (const MotionNumber& number : motion_numbers) append_csv_number(text, number.value(motion));
    text += "\n";
  }
  return text;
}

/// About a dozen points of one mode, evenly spread along its branch.
std::vector<const BackbonePoint*> shown_points(const Backbone& mode) {
  constexpr std::size_t most = 12;
  std::vector<const BackbonePoint*> shown;
  const std::size_t last = mode.points.size() - 1, count = std::min(most, mode.points.size());
  for (std::size_t i = 0; i < count; ++i) shown.push_back(&mode.points[count == 1 ? 0 : i * last / (count - 1)]);
  return shown;
}

std::string backbone_text(const project::Case& variant, const study::Answers& answers) {
  const project::ShownUnits& display = variant.display;
  const std::string unit = frequency_unit(display);
  std::string text;
  for (const Backbone& mode : modes_of(answers)) {
    text += fmt::format(
        "Nonlinear mode {}: {} {} about rest; {} points, {} {} at most {:.2g} of the "
        "deflections\n",
        mode.mode + 1, number_text(shown_frequency(display, mode.angular_frequency), 6), unit, mode.points.size(),
        mode.harmonics, harmonics_that_leave_out(mode.harmonics), mode.left_out);
    if (!mode.ended.empty()) text += "  " + mode.ended + "\n";
    for (const std::string& name : mode.held)
      text += fmt::format("  friction of {} sticks at every amplitude; with damped = true it slips\n", name);
    const bool damped = std::any_of(mode.points.begin(), mode.points.end(),
                                    [](const BackbonePoint& point) { return point.damping_ratio != 0; });
    if (!damped) text += "  without dampers; damped = true shows the damping ratio over the amplitude\n";
    std::vector<std::string> headings = {"at [" + unit + "]", "energy [J]", "damping ratio"};
    if (!damped) headings.pop_back();
    constexpr std::size_t most_results = 6;
    const std::size_t results = std::min(most_results, mode.results.size());
    for (std::size_t c = 0; c < results; ++c) headings.push_back(mode.results[c]);
    TextTable table(headings);
    for (const BackbonePoint* point : shown_points(mode)) {
      std::vector<std::string> cells = {number_text(shown_frequency(display, point->angular_frequency), 6),
                                        number_text(point->energy, 4)};
      if (damped) cells.push_back(number_text(point->damping_ratio, 4));
      for (std::size_t c = 0; c < results; ++c)
        cells.push_back(value_text(point->results[c].half_of_range(), display_unit(display, mode.units[c])));
      table.add(cells);
    }
    text += table.text() + "  results: half of the range of each";
    text += results < mode.results.size() ? fmt::format("; {} more in --json\n", mode.results.size() - results) : "\n";
  }
  return text;
}

void backbone_arrays(const project::Case&, const study::Answers& answers, LabelledArrays& list) {
  const std::string axis = "point";
  const std::vector<ModeRow> rows = mode_rows(answers);
  list.count(axis, rows.size());
  list.column("mode", "1", axis, rows, [](const ModeRow& row) { return row.mode; });
  list.column("angular_frequency", "rad/s", axis, rows,
              [](const ModeRow& row) { return row.point->angular_frequency; });
  list.column("energy", "J", axis, rows, [](const ModeRow& row) { return row.point->energy; });
  list.column("damping_ratio", "1", axis, rows, [](const ModeRow& row) { return row.point->damping_ratio; });
  const Backbone& first = modes_of(answers).front();
  for (std::size_t c = 0; c < first.results.size(); ++c)
    for (const MotionNumber& number : motion_numbers)
      list.column(first.results[c] + " " + number.name, first.units[c], axis, rows,
                  [&](const ModeRow& row) { return number.value(row.point->results[c]); });
}

}  // namespace

const AnswerWriter backbone_results = {
    .json = json::backbone,
    .tables = {{"backbone.csv", backbone_csv}},
    .text = backbone_text,
    .arrays = backbone_arrays,
};

}  // namespace trivet::results
