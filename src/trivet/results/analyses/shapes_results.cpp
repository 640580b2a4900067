// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "trivet/documents/csv_field.h"
#include "trivet/documents/shown_numbers.h"
#include "trivet/documents/text_table.h"
#include "trivet/response/machinery/deflection_shape.h"
#include "trivet/results/format/result_writer.h"

/// Operating deflection shapes.
namespace trivet::results {
namespace json {
namespace {

Json place(const response::MovingPlace& p) {
  return {{"name", p.name}, {"position", list(p.position)}, {"motion", list(p.motion)}};
}

Json shapes(const project::Case&, const study::CaseResults& results) {
  Json result{{"shapes", Json::array()}, {"warnings", warnings(results.warnings)}};
  for (const response::DeflectionShape& shape : *results.find<std::vector<response::DeflectionShape>>("shapes")) {
    Json places = Json::array();
    for (const auto* group : {&shape.bodies, &shape.points, &shape.feet, &shape.heads})
      for (const response::MovingPlace& p : *group) places.push_back(place(p));
    result["shapes"].push_back({{"angular_frequency", shape.angular_frequency},
                                {"largest_excursion", shape.largest_excursion},
                                {"places", std::move(places)}});
  }
  return result;
}

}  // namespace
}  // namespace json

namespace {

std::string shapes_csv(const project::Case&, const study::CaseResults& results) {
  std::string text = "angular_frequency [rad/s],place,x [m],y [m],z [m]";
  for (const char* part : {"re", "im"})
    for (std::size_t j = 0; j < model::coordinate_names.size(); ++j)
      text += fmt::format(",{} {} [{}]", model::coordinate_names[j], part, j < 3 ? "m" : "rad");
  text += "\n";
  for (const response::DeflectionShape& shape : *results.find<std::vector<response::DeflectionShape>>("shapes"))
    for (const auto* group : {&shape.bodies, &shape.points, &shape.feet, &shape.heads})
      for (const response::MovingPlace& p : *group) {
        text += fmt::format("{},{},{},{},{}", shape.angular_frequency, csv_field(p.name), p.position.x(),
                            p.position.y(), p.position.z());
        for (int j = 0; j < 6; ++j) append_csv_number(text, p.motion(j).real());
        for (int j = 0; j < 6; ++j) append_csv_number(text, p.motion(j).imag());
        text += "\n";
      }
  return text;
}

std::string shapes_text(const project::Case& variant, const study::CaseResults& results) {
  std::string text = excited_at_once(variant, "shapes");
  const DisplayUnit length = amplitude_unit(variant.display, "m");
  const std::string in_length = "| [" + length.label() + "]";
  for (const response::DeflectionShape& shape : *results.find<std::vector<response::DeflectionShape>>("shapes")) {
    TextTable table({"place", "|x" + in_length, "|y" + in_length, "|z" + in_length, "phase x", "phase y", "phase z"});
    for (const auto* group : {&shape.bodies, &shape.points, &shape.feet, &shape.heads})
      for (const response::MovingPlace& p : *group) {
        std::vector<std::string> row = {p.name};
        for (int j = 0; j < 3; ++j) row.push_back(number_text(std::abs(p.motion(j)) * length.factor));
        for (int j = 0; j < 3; ++j)
          row.push_back(
              std::abs(p.motion(j)) > 0 ? fmt::format("{:.1f}°", std::arg(p.motion(j)) * 180 / std::numbers::pi) : "–");
        table.add(row);
      }
    text += fmt::format("Operating deflection shape at {} {}, largest excursion {} {}\n",
                        number_text(shown_frequency(variant.display, shape.angular_frequency)),
                        frequency_unit(variant.display), number_text(shape.largest_excursion * length.factor),
                        length.label()) +
        table.text();
  }
  return text;
}

/// All places of a shape, in the order of the tables.
std::vector<response::MovingPlace> places_of(const response::DeflectionShape& shape) {
  std::vector<response::MovingPlace> places;
  for (const auto* group : {&shape.bodies, &shape.points, &shape.feet, &shape.heads})
    places.insert(places.end(), group->begin(), group->end());
  return places;
}

void shapes_arrays(const project::Case&, const study::CaseResults& results, LabelledArrays& list) {
  using response::DeflectionShape;
  using response::MovingPlace;
  const auto& shapes = *results.find<std::vector<DeflectionShape>>("shapes");
  if (shapes.empty()) return;
  const std::vector<MovingPlace> places = places_of(shapes.front());
  const std::string axis = "angular_frequency";
  list.field(axis, "rad/s", axis, shapes, &DeflectionShape::angular_frequency);
  list.field("largest_excursion", "m", axis, shapes, &DeflectionShape::largest_excursion);
  list.texts("place", "place", places, &MovingPlace::name);
  list.texts("direction", "direction", {"x", "y", "z"});
  list.lists("position", "m", {"place", "direction"}, 3, places, &MovingPlace::position);
  add_motion_coordinates(list);
  std::vector<std::complex<double>> motions;
  for (const DeflectionShape& shape : shapes)
    for (const MovingPlace& place : places_of(shape))
      motions.insert(motions.end(), place.motion.begin(), place.motion.end());
  list.copy("motion", unit_of_the_row, {axis, "place", "coordinate"}, {shapes.size(), places.size(), 6},
            std::move(motions));
  list.mark_harmonic({"largest_excursion", "motion", "coordinate.unit"});
}

}  // namespace

void add_motion_coordinates(Document& document) {
  document.add(Words{.axis = "coordinate", .list = {model::coordinate_names.begin(), model::coordinate_names.end()}});
  document.add(Words{.axis = "coordinate", .list = {"m", "m", "m", "rad", "rad", "rad"}, .name = "coordinate.unit"});
}

void add_motion_coordinates(LabelledArrays& list) {
  Document coordinates;
  add_motion_coordinates(coordinates);
  add_arrays(coordinates, list);
}

const ResultWriter shapes_results = {
    .json = json::shapes,
    .tables = {{"shapes.csv", shapes_csv}},
    .text = shapes_text,
    .arrays = shapes_arrays,
};

}  // namespace trivet::results
