// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "trivet/documents/shown_table.h"
#include "trivet/response/machinery/deflection_shape.h"
#include "trivet/results/format/result_writer.h"

/// Operating deflection shapes.
namespace trivet::results {
namespace {

using response::DeflectionShape;
using response::MovingPlace;

/// A place with the shape in which it moves: a line of CSV.
struct PlaceOfShape {
  const DeflectionShape* shape;
  const MovingPlace* place;
};
/// All places, in the order of the tables.
std::vector<PlaceOfShape> places_of(const DeflectionShape& shape) {
  std::vector<PlaceOfShape> places;
  for (const auto* group : {&shape.bodies, &shape.points, &shape.feet, &shape.heads})
    for (const MovingPlace& place : *group) places.push_back({&shape, &place});
  return places;
}
std::vector<PlaceOfShape> places_of(const std::vector<DeflectionShape>& shapes) {
  std::vector<PlaceOfShape> all;
  for (const DeflectionShape& shape : shapes)
    for (const PlaceOfShape& one : places_of(shape)) all.push_back(one);
  return all;
}

/// Real and imaginary parts.
Numbers parts_of(const PlaceOfShape& one) {
  Eigen::Matrix<double, 12, 1> parts;
  parts << one.place->motion.real(), one.place->motion.imag();
  return Numbers(std::move(parts));
}

std::optional<double> phase_in_degrees(const std::complex<double>& motion) {
  return motion == 0.0 ? std::nullopt : std::optional(std::arg(motion) * 180 / std::numbers::pi);
}

Table moving_places(std::vector<PlaceOfShape> places, unsigned forms) {
  const Rows row(std::move(places));
  std::vector<std::string> headings;
  for (const char* part : {"re", "im"})
    for (std::size_t j = 0; j < model::coordinate_names.size(); ++j)
      headings.push_back(fmt::format("{} {} [{}]", model::coordinate_names[j], part, j < 3 ? "m" : "rad"));
  Column parts = row.lists("parts", "", "", std::move(headings), parts_of, {.forms = in_csv});
  parts.kind = Kind::amplitude;
  Table table{
      .key = "places",
      .axis = "place",
      .plain_names = true,
      .file = forms & in_csv ? "shapes.csv" : "",
      .rows = row.size(),
      .columns = {row("angular_frequency", Kind::frequency, "",
                      [](const PlaceOfShape& one) { return one.shape->angular_frequency; }, {.forms = in_csv}),
                  row("name", Kind::words, "place", [](const PlaceOfShape& one) { return one.place->name; }),
                  row.lists("position", "", "direction", {"x [m]", "y [m]", "z [m]"},
                            [](const PlaceOfShape& one) -> const Eigen::Vector3d& { return one.place->position; },
                            {.unit = "m", .forms = for_programs}),
                  row.lists("motion", "", "", {},
                            [](const PlaceOfShape& one) -> const auto& { return one.place->motion; },
                            {.forms = in_json}),
                  std::move(parts)},
      .csv = {"angular_frequency [rad/s]", {"place", "name"}, {"{}", "position"}, {"{}", "parts"}},
      .arrays = {{"place", "name"}, "position"},
      .together = 2,
      .folded = true,
      .one_prefix = true,
      .forms = forms};
  for (int j = 0; j < 3; ++j) {
    const std::string name = model::coordinate_names[static_cast<std::size_t>(j)];
    table.columns.push_back(row(name, Kind::amplitude, "|" + name + "|",
                                [j](const PlaceOfShape& one) { return std::abs(one.place->motion(j)); },
                                {.unit = "m", .digits = 4, .forms = for_people}));
    table.columns.push_back(row("phase " + name, Kind::number, "phase of " + name,
                                [j](const PlaceOfShape& one) { return phase_in_degrees(one.place->motion(j)); },
                                {.unit = "°", .digits = 4, .forms = for_people}));
  }
  return table;
}

Table shape_table(const std::vector<DeflectionShape>& shapes) {
  const Rows row(shapes);
  const auto places = [](const DeflectionShape& shape) {
    return as_json({{{moving_places(places_of(shape), in_json)}}})["places"];
  };
  return {.key = "shapes",
          .axis = shapes.empty() ? "" : "angular_frequency",
          .plain_names = true,
          .rows = row.size(),
          .columns = {row("angular_frequency", Kind::frequency, "", &DeflectionShape::angular_frequency),
                      row("largest_excursion", Kind::amplitude, "", &DeflectionShape::largest_excursion, {.unit = "m"}),
                      row("places", Kind::words, "", places, {.forms = in_json})},
          .forms = for_programs};
}

/// The motions of all shapes, over three axes.
LabelledArrays motions_of(const std::vector<DeflectionShape>& shapes) {
  Document coordinates;
  add_motion_coordinates(coordinates);
  LabelledArrays list;
  add_arrays(coordinates, list);
  std::vector<std::complex<double>> motions;
  for (const PlaceOfShape& one : places_of(shapes))
    motions.insert(motions.end(), one.place->motion.begin(), one.place->motion.end());
  const std::size_t places = motions.size() / shapes.size() / 6;
  list.copy("motion", unit_of_the_row, {"angular_frequency", "place", "coordinate"}, {shapes.size(), places, 6},
            std::move(motions));
  list.mark_harmonic({"motion", "coordinate.unit"});
  return list;
}

Document shapes_document(const project::Case& variant, const study::CaseResults& results) {
  const auto& shapes = *results.shapes;
  Document document;
  document.add(excited_part(variant, "shapes"));
  document.add(shape_table(shapes));
  for (const DeflectionShape& shape : shapes)
    document.add(moving_places(places_of(shape), for_people)).title = shown_sentence(
        {.parts = {"Operating deflection shape at ", Quantity{shape.angular_frequency, "rad/s", Kind::frequency},
                   ", largest excursion ", Quantity{shape.largest_excursion, "m", Kind::amplitude}}},
        variant.display);
  document.add(moving_places(places_of(shapes), in_csv));
  if (!shapes.empty()) {
    document.add(moving_places(places_of(shapes.front()), in_arrays));
    document.add(Words{.axis = "direction", .list = {"x", "y", "z"}});
    document.add(motions_of(shapes));
  }
  document.add(warnings_part(results));
  return document;
}

}  // namespace

void add_motion_coordinates(Document& document) {
  document.add(Words{.axis = "coordinate", .list = {model::coordinate_names.begin(), model::coordinate_names.end()}});
  document.add(Words{.axis = "coordinate", .list = {"m", "m", "m", "rad", "rad", "rad"}, .name = "coordinate.unit"});
}

const ResultWriter shapes_results = {.document = shapes_document, .files = {"shapes.csv"}};

}  // namespace trivet::results
