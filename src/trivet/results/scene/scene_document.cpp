// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/scene/scene_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "trivet/documents/integer_list.h"
#include "trivet/model/adjustments.h"
#include "trivet/results/format/in_documents.h"
#include "trivet/results/model/model_words.h"
#include "trivet/results/scene/scene_shapes.h"

namespace trivet::results {
namespace {

using Body = DrawnMachine::Body;

/// Unit vectors of a frame, one after the other.
Json axes_json(const Eigen::Matrix3d& axes) { return json::rows(Eigen::Matrix3d(axes.transpose())); }

std::vector<std::string> directions() { return {"direction x", "y", "z"}; }

std::size_t solids_of(const Scene& scene, std::size_t body) {
  return static_cast<std::size_t>(std::ranges::count_if(
      scene.machine.solids, [body](const auto& solid) { return solid.body == body && !solid.equivalent; }));
}

Json solids_json(const Scene& scene, std::size_t body, double size) {
  Json list = Json::array();
  for (const DrawnMachine::Solid& solid : scene.machine.solids)
    if (solid.body == body && !solid.equivalent) list.push_back(mesh_json(solid.surface, size));
  return list;
}

Json box_json(const model::Body& body) {
  if (body.is_node || !(body.mass.mass > 0) || !body.has_inertia) return nullptr;
  const EquivalentBox box = equivalent_box(body.mass);
  return {{"centre", json::list(Eigen::Vector3d(body.pose.position + body.pose.rotation * box.centre))},
          {"axes", axes_json(body.pose.rotation * box.axes)},
          {"size", json::list(Eigen::Vector3d(2 * box.half))}};
}

/// Places of the coordinates x, y, z, θx, θy, θz of a body in mode shapes.
Json coordinate_places(std::size_t body) {
  std::vector<int> places(6);
  std::iota(places.begin(), places.end(), 6 * static_cast<int>(body));
  return json::integer_list(places);
}

std::string drawn_as(const Scene& scene, std::size_t body) {
  if (scene.machine.bodies[body].is_node) return "node";
  const std::size_t solids = solids_of(scene, body);
  if (solids > 0) return fmt::format("{} solid{}", solids, solids == 1 ? "" : "s");
  const bool box = std::ranges::any_of(scene.machine.solids, [&](const auto& solid) { return solid.body == body; });
  return box ? "box of equal inertia" : "point";
}

Table body_table(const project::Case& variant, const Scene& scene, double size) {
  const auto& bodies = variant.system.bodies();
  const Rows row(scene.machine.bodies);
  const auto json_only = [&](const char* name, auto value) {
    return row(name, Kind::words, "", value, {.forms = in_json});
  };
  return {.key = "bodies",
          .title = "Bodies",
          .rows = row.size(),
          .columns = {row("name", Kind::words, "body", &Body::name),
                      json_only("node", [](const Body& body) { return body.is_node; }),
                      row("mass", Kind::quantity, "mass", &Body::mass, {.unit = "kg"}),
                      row("drawn_as", Kind::words, "drawn as", [&](std::size_t b) { return drawn_as(scene, b); }),
                      json_only("pole", [](const Body& body) { return json::list(body.pose.position); }),
                      row.lists("centre_of_mass", "centre of mass", "", {"centre of mass x", "y", "z"}, &Body::centre,
                                {.unit = "m", .digits = 4, .forms = in_json | for_people}),
                      json_only("axes", [](const Body& body) { return axes_json(body.pose.rotation); }),
                      json_only("dofs", [](std::size_t b) { return coordinate_places(b); }),
                      json_only("free", [&bodies](std::size_t b) { return Json(bodies[b].free); }),
                      json_only("box", [&bodies](std::size_t b) { return box_json(bodies[b]); }),
                      json_only("solids", [&scene, size](std::size_t b) { return solids_json(scene, b, size); })},
          .forms = in_json | for_people};
}

Json place_json(const model::Description& d, const model::End& end) {
  const Json at = json::list(model::end_in_ground(d.bodies, end).position);
  if (end.body) return {{"body", d.bodies[*end.body].name}, {"at", at}};
  if (end.foundation) return {{"foundation", d.foundations[end.foundation->foundation].name}, {"at", at}};
  return {{"ground", true}, {"at", at}};
}

std::string place_words(const model::Description& d, const model::End& end) {
  if (end.body) return d.bodies[*end.body].name;
  return end.foundation ? d.foundations[end.foundation->foundation].name : "ground";
}

/// An element with its place in the model.
struct SceneElement {
  const model::Element* element;
  ShownElement shown;
};

std::vector<SceneElement> scene_elements(const project::Case& variant) {
  std::vector<SceneElement> list;
  for (std::size_t e = 0; e < variant.system.elements().size(); ++e)
    if (const model::Element& element = variant.system.elements()[e]; !element.is_foundation)
      list.push_back({&element, shown_element(variant, e)});
  return list;
}

Json element_json(const model::Description& d, const SceneElement& one) {
  const std::string key(model::stiffness_key(*one.element));
  Json result{{"name", one.element->name},
              {"type", one.element->type},
              {"kind", one.shown.kind},
              {"stiffness_key", key.empty() ? Json() : Json(key)},
              {"from", place_json(d, one.element->n)},
              {"to", place_json(d, one.element->k)},
              {"axes", axes_json(model::end_in_ground(d.bodies, one.element->k).rotation)},
              {"size", {one.shown.length, json::optional(one.shown.diameter)}}};
  if (!one.shown.key.empty()) result[one.shown.key] = one.shown.dimensions;
  return result;
}

/// JSON has the whole element as one value.
void add_elements(const project::Case& variant, Document& document) {
  const model::Description& d = variant.system.description();
  std::vector<SceneElement> list = scene_elements(variant);
  Json all = Json::array();
  for (const SceneElement& one : list) all.push_back(element_json(d, one));
  document.add(Single{"elements", std::move(all)});
  const Rows row(std::move(list));
  document.add(
      Table{.title = "Elements",
            .rows = row.size(),
            .columns = {row("name", Kind::words, "element", [](const SceneElement& one) { return one.element->name; }),
                        row("type", Kind::words, "type", [](const SceneElement& one) { return one.element->type; }),
                        row("kind", Kind::words, "drawn as", [](const SceneElement& one) { return one.shown.kind; }),
                        row("from", Kind::words, "from",
                            [&d](const SceneElement& one) { return place_words(d, one.element->n); }),
                        row("to", Kind::words, "to",
                            [&d](const SceneElement& one) { return place_words(d, one.element->k); }),
                        row("length", Kind::quantity, "length",
                            [](const SceneElement& one) { return one.shown.length; }, {.unit = "m"}),
                        row("diameter", Kind::quantity, "diameter",
                            [](const SceneElement& one) { return one.shown.diameter; }, {.unit = "m"})},
            .forms = for_people});
}

Table stop_table(const project::Case& variant, const Scene& scene) {
  const auto& elements = variant.system.elements();
  const Rows row(scene.stops);
  const auto unit = [](const DrawnStop& stop) { return stop.kind == DrawnStop::Kind::turn ? "rad" : "m"; };
  return {.key = "stops",
          .title = "Stops",
          .rows = row.size(),
          .columns = {row("name", Kind::words, "element",
                          [&elements](const DrawnStop& stop) { return elements[stop.element].name; }),
                      row("kind", Kind::words, "kind", [](const DrawnStop& stop) { return word_of(stop.kind); }),
                      row.lists("at", "", "", {}, &DrawnStop::at, {.unit = "m", .forms = in_json}),
                      row.lists("direction", "direction", "", directions(), &DrawnStop::direction,
                                {.digits = 4, .forms = in_json | for_people}),
                      row("gap", Kind::quantity, "gap at rest", &DrawnStop::gap), row("unit", Kind::words, "", unit)},
          .forms = in_json | for_people};
}

/// An arrow of an excitation or a constant force.
struct Arrow {
  std::string name, type;
  std::optional<std::size_t> body;
  Eigen::Vector3d at, direction;
  const char* kind;  ///< "force", "moment", "rotating_force", "ground_translation", "ground_rotation"
};

std::vector<Arrow> arrows(const model::Description& d, const Scene& scene) {
  std::vector<Arrow> list;
  const auto add = [&](const Arrow& arrow) {
    if (arrow.direction.norm() > 0) list.push_back(arrow);
  };
  for (std::size_t i = 0; i < scene.machine.excitations.size(); ++i) {
    const DrawnMachine::Excitation& e = scene.machine.excitations[i];
    const std::string type = excitation_numbers(d.excitations[i]).type;
    add({e.name, type, e.body, e.at, e.force, e.body ? "force" : "ground_translation"});
    add({e.name, type, e.body, e.at, e.moment, e.body ? "moment" : "ground_rotation"});
    add({e.name, type, e.body, e.at, e.rotation, "rotating_force"});
  }
  for (const model::ConstantForce& force : d.constant_forces) {
    const spatial::Pose& pose = d.bodies[force.body].pose;
    const Eigen::Vector3d at = pose.position + pose.rotation * force.at;
    add({force.name, "constant", force.body, at, pose.rotation * force.wrench.force.normalized(), "force"});
    add({force.name, "constant", force.body, at, pose.rotation * force.wrench.moment.normalized(), "moment"});
  }
  return list;
}

Table force_table(const model::Description& d, const Scene& scene) {
  const Rows row(arrows(d, scene));
  return {
      .key = "forces",
      .title = "Forces and motions of the ground",
      .rows = row.size(),
      .columns = {row("name", Kind::words, "excitation", &Arrow::name), row("type", Kind::words, "type", &Arrow::type),
                  row("kind", Kind::words, "drawn as", &Arrow::kind),
                  row("body", Kind::words, "on",
                      [&d](const Arrow& arrow) { return arrow.body ? Json(d.bodies[*arrow.body].name) : Json(); }),
                  row.lists("at", "", "", {}, &Arrow::at, {.unit = "m", .forms = in_json}),
                  row.lists("direction", "direction", "", directions(), &Arrow::direction,
                            {.digits = 4, .forms = in_json | for_people})},
      .forms = in_json | for_people};
}

Json clearances_json(const model::Description& d) {
  Json list = Json::array();
  for (const model::Clearance& clearance : d.clearances) {
    const auto of = model::position(d.bodies, clearance.of), to = model::position(d.bodies, clearance.to);
    const auto place = [&](const model::Place& side, const Eigen::Vector3d& at) -> Json {
      if (side.body) return {{"body", d.bodies[*side.body].name}, {"at", json::list(at)}};
      return {{"ground", true}, {"at", json::list(at)}};
    };
    const Eigen::Vector3d across = clearance.gap * clearance.direction;
    list.push_back({{"name", clearance.name},
                    {"from", place(clearance.of, of ? *of : Eigen::Vector3d(*to - across))},
                    {"to", place(clearance.to, to ? *to : Eigen::Vector3d(*of + across))},
                    {"direction", json::list(clearance.direction)},
                    {"gap", clearance.gap}});
  }
  return list;
}

void add_places(const model::Description& d, const Scene& scene, Document& document) {
  Json points = Json::array(), foundations = Json::array();
  for (const DrawnMachine::Point& point : scene.machine.points)
    points.push_back({{"name", point.name}, {"body", d.bodies[point.body].name}, {"at", json::list(point.at)}});
  for (const DrawnMachine::Foundation& foundation : scene.machine.foundations)
    foundations.push_back({{"name", foundation.name}, {"at", json::list(foundation.at)}});
  document.add(Single{"foundations", std::move(foundations)});
  document.add(Single{"points", std::move(points)});
  document.add(Single{"clearances", clearances_json(d)});
}

}  // namespace

Scene scene_of(const project::Case& variant) { return {drawn_machine(variant), drawn_stops(variant.system)}; }

Document scene_document(const project::Case& variant, const Scene& scene) {
  const model::Description& d = variant.system.description();
  constexpr double least_size = 0.05;  // of a machine whose places all coincide [m]
  const double size = std::max(scene.machine.bounds().size(), least_size);
  Document document;
  document.add(Single{"title", d.title});
  document.add(Single{"size", size});
  document.add(Single{"gravity", d.gravity ? json::list(*d.gravity) : Json(nullptr)});
  document.add(body_table(variant, scene, size));
  add_elements(variant, document);
  document.add(stop_table(variant, scene));
  add_places(d, scene, document);
  document.add(force_table(d, scene));
  return document;
}

}  // namespace trivet::results
