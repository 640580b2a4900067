// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "trivet/response/machinery/deflection_shape.h"
#include "trivet/results/answer_writer.h"
#include "trivet/results/csv_field.h"
#include "trivet/results/text_table.h"

/// Operating deflection shapes.
namespace trivet::results {
namespace json {
namespace {

Json place(const response::MovingPlace& p) {
  return {{"name", p.name}, {"position", list(p.position)}, {"motion", list(p.motion)}};
}

Json shapes(const project::Case&, const study::Answers& answers) {
  Json result{{"shapes", Json::array()}, {"warnings", warnings(answers.warnings)}};
  for (const response::DeflectionShape& shape : *answers.find<std::vector<response::DeflectionShape>>("shapes")) {
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

std::string shapes_csv(const project::Case&, const study::Answers& answers) {
  std::string text = "angular_frequency [rad/s],place,x [m],y [m],z [m]";
  for (const char* part : {"re", "im"})
    for (const char* name : model::coordinate_names) text += fmt::format(",{} {}", name, part);
  text += "\n";
  for (const response::DeflectionShape& shape : *answers.find<std::vector<response::DeflectionShape>>("shapes"))
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

std::string shapes_text(const project::Case& variant, const study::Answers& answers) {
  std::string text = excited_at_once(variant, "shapes");
  for (const response::DeflectionShape& shape : *answers.find<std::vector<response::DeflectionShape>>("shapes")) {
    TextTable table({"place", "|x| [m]", "|y| [m]", "|z| [m]", "phase x", "phase y", "phase z"});
    for (const auto* group : {&shape.bodies, &shape.points, &shape.feet, &shape.heads})
      for (const response::MovingPlace& p : *group) {
        std::vector<std::string> row = {p.name};
        for (int j = 0; j < 3; ++j) row.push_back(number_text(std::abs(p.motion(j))));
        for (int j = 0; j < 3; ++j)
          row.push_back(
              std::abs(p.motion(j)) > 0 ? fmt::format("{:.1f}°", std::arg(p.motion(j)) * 180 / std::numbers::pi) : "–");
        table.add(row);
      }
    text += fmt::format("Operating deflection shape at {} Hz, largest excursion {} m\n",
                        number_text(hertz(shape.angular_frequency)), number_text(shape.largest_excursion)) +
        table.text();
  }
  return text;
}

}  // namespace

const AnswerWriter shapes_results = {
    .json = json::shapes,
    .tables = {{"shapes.csv", shapes_csv}},
    .text = shapes_text,
};

}  // namespace trivet::results
