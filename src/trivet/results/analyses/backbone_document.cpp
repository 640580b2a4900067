// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "trivet/nonlinear/modes/backbone.h"
#include "trivet/results/format/motion_numbers.h"
#include "trivet/results/format/result_writer.h"

/// Nonlinear modes.
namespace trivet::results {
namespace {

using nonlinear::Backbone;
using nonlinear::BackbonePoint;

json::Json point_json(const BackbonePoint& p) {
  json::Json motions = json::Json::array();
  for (const nonlinear::ObservedMotion& m : p.results) motions.push_back(json::motion(m));
  return {{"angular_frequency", p.angular_frequency},
          {"energy", p.energy},
          {"damping_ratio", p.damping_ratio},
          {"deflection", p.deflection},
          {"results", std::move(motions)}};
}

json::Json points_json(const Backbone& mode) {
  json::Json points = json::Json::array();
  for (const BackbonePoint& p : mode.points) points.push_back(point_json(p));
  return points;
}

json::Json observed_results(const Backbone& mode) {
  json::Json results = json::Json::array();
  for (std::size_t c = 0; c < mode.results.size(); ++c)
    results.push_back({{"name", mode.results[c]}, {"unit", mode.units[c]}});
  return results;
}

/// The damping ratio, or nothing if the mode is undamped.
std::optional<double> ratio(const BackbonePoint& point) {
  return point.damping_ratio == 0 ? std::nullopt : std::optional(point.damping_ratio);
}

Table nonlinear_modes(const std::vector<Backbone>& modes) {
  const Rows row(modes);
  const auto end = [](const Backbone& mode) -> const BackbonePoint& { return mode.points.back(); };
  return {.key = "modes",
          .title = "Nonlinear modes",
          .rows = row.size(),
          .columns = {row("mode", Kind::number, "mode", [](const Backbone& mode) { return mode.mode + 1; }),
                      row("angular_frequency", Kind::frequency, "about rest", &Backbone::angular_frequency),
                      row("harmonics", Kind::number, "harmonics", &Backbone::harmonics),
                      row("left_out", Kind::number, "left out", &Backbone::left_out, {.digits = 2}),
                      row("ended", Kind::words, "", &Backbone::ended, {.forms = in_json}),
                      row("held", Kind::words, "", &Backbone::held, {.forms = in_json}),
                      row("results", Kind::words, "", observed_results, {.forms = in_json}),
                      row("points", Kind::words, "", points_json, {.forms = in_json}),
                      row("number_of_points", Kind::number, "points",
                          [](const Backbone& mode) { return mode.points.size(); }, {.forms = for_people}),
                      row("end", Kind::frequency, "at the end",
                          [end](const Backbone& mode) { return end(mode).angular_frequency; }, {.forms = for_people}),
                      row("energy", Kind::quantity, "energy there",
                          [end](const Backbone& mode) { return end(mode).energy; },
                          {.unit = "J", .digits = 4, .forms = for_people}),
                      row("first_ratio", Kind::number, "damping ratio at first",
                          [](const Backbone& mode) { return ratio(mode.points.front()); },
                          {.digits = 4, .forms = for_people}),
                      row("last_ratio", Kind::number, "there", [end](const Backbone& mode) { return ratio(end(mode)); },
                          {.digits = 4, .forms = for_people})},
          .people = {"mode", "angular_frequency", "end", "energy", "first_ratio", "last_ratio", "number_of_points",
                     "harmonics", "left_out"}};
}

/// A point, and the number of its mode from 1.
struct PointOfMode {
  Eigen::Index mode;
  const BackbonePoint* point;
};

/// The points of all modes for programs.
Table backbone_points(const std::vector<Backbone>& modes) {
  std::vector<PointOfMode> points;
  for (const Backbone& mode : modes)
    for (const BackbonePoint& point : mode.points) points.push_back({mode.mode + 1, &point});
  const Rows row(std::move(points));
  const auto of_point = [](double BackbonePoint::* member) {
    return [member](const PointOfMode& one) { return one.point->*member; };
  };
  const Backbone& first = modes.front();
  Table table{.axis = "point",
              .plain_names = true,
              .file = "backbone.csv",
              .rows = row.size(),
              .columns = {row("mode", Kind::number, "", &PointOfMode::mode),
                          row("angular_frequency", Kind::frequency, "", of_point(&BackbonePoint::angular_frequency)),
                          row("energy", Kind::number, "", of_point(&BackbonePoint::energy), {.unit = "J"}),
                          row("damping_ratio", Kind::number, "", of_point(&BackbonePoint::damping_ratio)),
                          row("deflection", Kind::number, "", of_point(&BackbonePoint::deflection), {.forms = in_csv})},
              .csv = {"mode",
                      "angular_frequency [rad/s]",
                      "energy [J]",
                      {"damping ratio", "damping_ratio"},
                      "deflection [m or rad]"},
              .forms = for_programs};
  for (std::size_t c = 0; c < first.results.size(); ++c)
    for (const MotionNumber& number : motion_numbers) {
      const std::string name = first.results[c] + " " + number.name;
      table.columns.push_back(row(name, Kind::number, "",
                                  [c, number](const PointOfMode& one) { return number.value(one.point->results[c]); },
                                  {.unit = first.units[c]}));
      table.csv.emplace_back(fmt::format("{} [{}]", name, first.units[c]), name);
    }
  return table;
}

Table points_of_mode(const Backbone& mode) {
  constexpr std::size_t most_results = 6;
  const std::size_t results = std::min(most_results, mode.results.size());
  const Rows row(mode.points);
  Table table{
      .title = fmt::format(
          "Mode {}: half the peak-to-peak value of each result{}", mode.mode + 1,
          results < mode.results.size() ? fmt::format("; {} more in JSON and CSV", mode.results.size() - results) : ""),
      .rows = row.size(),
      .columns = {row("angular_frequency", Kind::frequency, "at", &BackbonePoint::angular_frequency),
                  row("energy", Kind::quantity, "energy", &BackbonePoint::energy, {.unit = "J", .digits = 4})},
      .people_rows = spread_rows(row.size(), 12),
      .folded = true,
      .forms = for_people};
  if (std::ranges::any_of(mode.points, [](const BackbonePoint& point) { return point.damping_ratio != 0; }))
    table.columns.push_back(
        row("damping_ratio", Kind::number, "damping ratio", &BackbonePoint::damping_ratio, {.digits = 4}));
  for (std::size_t c = 0; c < results; ++c)
    table.columns.push_back(row(fmt::format("result {}", c), Kind::quantity, mode.results[c],
                                [c](const BackbonePoint& point) { return point.results[c].half_of_range(); },
                                {.unit = mode.units[c], .digits = 4}));
  return table;
}

/// What a mode lacks.
void add_remarks(const Backbone& mode, Document& document) {
  const auto add = [&](const std::string& words) {
    document.add(Sentence{.parts = {fmt::format("Mode {}: {}", mode.mode + 1, words)}, .place = Sentence::Place::item});
  };
  if (!mode.ended.empty()) add(mode.ended);
  for (const std::string& name : mode.held)
    add(fmt::format("friction of {} sticks at every amplitude; with damped = true it slips", name));
  if (std::ranges::all_of(mode.points, [](const BackbonePoint& point) { return point.damping_ratio == 0; }))
    add("without dampers; damped = true shows the damping ratio over the amplitude");
}

Document backbone_document(const project::Case&, const study::CaseResults& results) {
  const auto& modes = *results.backbone;
  Document document;
  document.add(nonlinear_modes(modes));
  document.add(backbone_points(modes));
  for (const Backbone& mode : modes) add_remarks(mode, document);
  document.add(
      Sentence{.parts = {"Free periodic motions that the modes about rest become as their amplitude grows. Left "
                         "out: largest share of the deflections beyond the harmonics."},
               .place = Sentence::Place::note});
  for (const Backbone& mode : modes) document.add(points_of_mode(mode));
  document.add(warnings_part(results));
  return document;
}

}  // namespace

const ResultWriter backbone_results = {.document = backbone_document, .files = {"backbone.csv"}};

}  // namespace trivet::results
