// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "trivet/documents/shown_numbers.h"
#include "trivet/documents/text_table.h"
#include "trivet/foundation/index.h"
#include "trivet/results/format/json_parts.h"
#include "trivet/results/model/element_results.h"
#include "trivet/results/model/model_words.h"

/// An element and its part in its model.
namespace trivet::results {
namespace json {

Json end(const project::Case& variant, const model::End& end) {
  const spatial::Pose in_ground = model::end_in_ground(variant.system.bodies(), end);
  return {{"on", end.body ? Json(variant.system.bodies()[*end.body].name) : Json("ground")},
          {"at", json::list(end.at)},
          {"in_ground", json::list(in_ground.position)},
          {"axes_in_ground", json::rows(in_ground.rotation)}};
}

}  // namespace json
namespace {

using elements::Matrix12;
using project::DisplayUnits;
using study::ElementInMode;

constexpr double round_off = 1e-12;

Part note_part(std::string words) { return {Sentence{.parts = {std::move(words)}, .place = Sentence::Place::note}}; }

std::string vector_words(const Eigen::Vector3d& v, double least) {
  const auto part = [&](int i) { return number_text(std::abs(v(i)) < least ? 0.0 : v(i), 4); };
  return fmt::format("({}, {}, {})", part(0), part(1), part(2));
}

std::string axes_words(const Eigen::Matrix3d& axes) {
  return fmt::format("x {}, y {}, z {}", vector_words(axes.col(0), round_off), vector_words(axes.col(1), round_off),
                     vector_words(axes.col(2), round_off));
}

void add_ends(const project::Case& variant, const model::Element& element, Document& document) {
  const std::vector<model::Body>& bodies = variant.system.bodies();
  const DisplayUnit length = display_unit(variant.display, "m");
  const auto place = [&](const Eigen::Vector3d& at) {
    return vector_words(length.factor * at, round_off) + " " + length.unit;
  };
  for (const auto& [letter, end] : {std::pair{'N', &element.n}, std::pair{'K', &element.k}}) {
    const spatial::Pose pose = model::end_in_ground(bodies, *end);
    document.parts.push_back(note_part(fmt::format(
        "end {} on {} at {}{}", letter, end->body ? "body \"" + bodies[*end->body].name + "\"" : "the ground",
        place(end->at),
        pose.position.isApprox(end->at, round_off) ? "" : ", in the ground frame at " + place(pose.position))));
  }
  const Eigen::Matrix3d n = model::end_in_ground(bodies, element.n).rotation,
                        k = model::end_in_ground(bodies, element.k).rotation;
  const bool same = n.isApprox(k, round_off);
  const auto axes = [&](const char* of, const Eigen::Matrix3d& rotation) {
    document.parts.push_back(note_part(fmt::format("local axes{} in the ground frame: {}", of, axes_words(rotation))));
  };
  if (!same) axes(" of N", n);
  axes(same ? "" : " of K", k);
}

void add_facts(const model::Element& element, const study::ElementSummary& summary, Document& document) {
  Json list = Json::array();
  for (const model::Fact& fact : element.facts) list.push_back({{"what", fact.what}, {"value", fact.value}});
  document.add(Single{"facts", std::move(list)});
  if (element.law.scale != 1)
    document.parts.push_back(note_part(fmt::format("stiffness scaled by {:.6g}", element.law.scale)));
  for (const std::vector<model::Fact>& facts : {element.facts, law_facts(element)})
    for (const model::Fact& fact : facts) document.parts.push_back(note_part(fact.what + ": " + fact.value));
  for (const auto& problem : summary.warnings.list())
    document.add(Sentence{.parts = {foundation::message(problem)}, .place = Sentence::Place::note, .forms = on_page});
}

/// A force or moment on an end, or its displacement. @param component  0 … 11
DisplayUnit load_unit(const DisplayUnits& display, int component) {
  return display_unit(display, component % 6 < 3 ? "N" : "N m");
}
DisplayUnit motion_unit(const DisplayUnits& display, int component) {
  return display_unit(display, component % 6 < 3 ? "m" : "rad");
}
std::string load_name(int component) {
  return fmt::format("{}_{}", component % 6 < 3 ? "F" : "M", "xyz"[component % 3]);
}
std::string load_heading(const DisplayUnits& display, int component) {
  return fmt::format("{} [{}]", load_name(component), load_unit(display, component).unit);
}

/// Twelve rows with the six columns of one end: a width of 80 characters fits a terminal.
Table half_matrix(const Matrix12& matrix, int first_column, const DisplayUnits& display) {
  std::vector<std::string> loads;
  for (int i = 0; i < 12; ++i) loads.push_back(load_heading(display, i));
  const Rows row(std::move(loads));
  Table table{.rows = row.size(),
              .columns = {row("end", Kind::words, "end", [](std::size_t i) { return i < 6 ? "N" : "K"; }),
                          row("load", Kind::words, "load", [](const std::string& load) { return load; })},
              .forms = for_people};
  for (int j = first_column; j < first_column + 6; ++j) {
    Eigen::Matrix<double, 12, 1> column;
    for (int i = 0; i < 12; ++i) {
      const double factor = load_unit(display, i).factor / motion_unit(display, j).factor;
      const bool is_zero = std::abs(matrix(i, j)) <= round_off * std::sqrt(std::abs(matrix(i, i) * matrix(j, j)));
      column(i) = is_zero ? 0.0 : factor * matrix(i, j);
    }
    table.columns.push_back(row("entry", Kind::number,
                                fmt::format("{} {} [{}]", first_column == 0 ? 'N' : 'K', study::component_name(j),
                                            motion_unit(display, j).unit),
                                [column](std::size_t i) { return column(to_index(i)); }));
  }
  return table;
}

void add_stiffness(const Matrix12& matrix, const DisplayUnits& display, Document& document) {
  document.add(
      Group{.key = "",
            .parts = {{Single{"stiffness", json::rows(matrix)}}, {half_matrix(matrix, 0, display)}},
            .title = fmt::format("Stiffness 12×12, local axes: load per unit displacement, so F rows are "
                                 "{0}/{2} and {0}/{3}, M rows {1}/{2} and {1}/{3}\n(entries below 1e-12 √(K_ii "
                                 "K_jj) shown as 0)",
                                 load_unit(display, 0).unit, load_unit(display, 3).unit, motion_unit(display, 0).unit,
                                 motion_unit(display, 3).unit)});
  document.add(
      Group{.key = "", .parts = {{half_matrix(matrix, 6, display)}}, .title = "The same per displacement of K"});
}

Group preload_group(const elements::Law& law) {
  if (!law.preload) return {.key = "", .parts = {{Single{"preload", nullptr}}}};
  const Rows row(std::vector<std::string>{"N", "K"});
  Table table{.rows = row.size(),
              .columns = {row("end", Kind::words, "preload on", [](const std::string& end) { return end; })},
              .forms = for_people};
  const double least = round_off * law.preload->cwiseAbs().maxCoeff();
  for (int j = 0; j < 6; ++j)
    table.columns.push_back(row(load_name(j), Kind::number, load_name(j),
                                [&preload = *law.preload, j, least](std::size_t end) {
                                  const double load = preload(6 * to_index(end) + j);
                                  return std::abs(load) <= least ? 0.0 : load;
                                },
                                {.unit = j < 3 ? "N" : "N m"}));
  return {.key = "",
          .parts = {{Single{"preload", json::list(*law.preload)}}, {std::move(table)}},
          .title = "Preload in the equilibrium state (local axes of each end)"};
}

struct StiffnessCheck {
  const char* what;
  std::string value, verdict;
};

Group check_group(const model::Element& element, const elements::MatrixVerdict& v) {
  const auto verdict = [](bool passed) { return passed ? "ok" : "CHECK IT"; };
  const bool preloaded = element.law.preload.has_value();
  std::vector<StiffnessCheck> checks = {
      {element.symmetric ? "symmetric" : "declared unsymmetric", fmt::format("{:.1e}", v.asymmetry),
       element.symmetric ? verdict(v.asymmetry <= elements::rounding_of_data) : "as declared"}};
  if (element.distance_parts.empty())  // else its force turns with the line between its ends
    checks.push_back({preloaded ? "rigid motion only rotates the preload" : "no force under rigid motion",
                      fmt::format("{:.1e}", v.rigid_residual), verdict(v.rigid_residual <= elements::silent_residual)});
  // A preloaded element does work when rotated as a whole, so N is held.
  const double lowest =
      preloaded ? elements::lowest_of_held_end(elements::stiffness(element.law)) : v.lowest_eigenvalue;
  checks.push_back(
      {preloaded ? "generates no energy with N held" : "generates no energy",
       fmt::format("eigenvalues {:.2g} to {:.2g}", std::abs(lowest) < 1e-13 ? 0.0 : lowest, v.highest_eigenvalue),
       verdict(preloaded ? lowest >= -elements::rounding_of_data : elements::is_semidefinite(v))});
  const Rows row(std::move(checks));
  return {
      .key = "",
      .parts = {{Single{"rigid_motion_residual", json::rows(v.residual)}},
                {Table{.rows = row.size(),
                       .columns = {row("check", Kind::words, "check of the stiffness", &StiffnessCheck::what),
                                   row("value", Kind::words, "value (scaled by √(K_ii K_jj))", &StiffnessCheck::value),
                                   row("verdict", Kind::words, "verdict", &StiffnessCheck::verdict)},
                       .forms = for_people}}},
      .title = "Checks"};
}

/// Three principal stiffnesses, or rotational ones, with their axes.
struct Principal {
  std::string stiffness, axis, rotational, rotational_axis;
};

Group character_group(const elements::StiffnessProperties& c, const DisplayUnits& display) {
  constexpr double least = 1e-9;
  const DisplayUnit along = display_unit(display, "N/m"), about = display_unit(display, "N m/rad"),
                    length = display_unit(display, "m");
  std::vector<Principal> list;
  for (int i = 0; i < 3; ++i) {
    const double rotational = c.principal_rotational_stiffnesses(i);
    const bool is_zero = std::abs(rotational) < least * std::abs(c.principal_rotational_stiffnesses(2));
    list.push_back({number_text(along.factor * c.principal_stiffnesses(i)) + " " + along.unit,
                    vector_words(c.principal_axes.col(i), least),
                    number_text(is_zero ? 0.0 : about.factor * rotational) + " " + about.unit,
                    vector_words(c.principal_rotational_axes.col(i), least)});
  }
  const Rows row(std::move(list));
  return {
      .key = "character",
      .parts =
          {{Single{"principal_stiffnesses", json::list(c.principal_stiffnesses)}},
           {Single{"principal_axes", json::rows(c.principal_axes.transpose())}},
           {Single{"elastic_center_from_k", json::list(c.elastic_centre)}},
           {Single{"elastic_center_is_unique", c.centre_is_unique}},
           {Single{"principal_rotational_stiffnesses", json::list(c.principal_rotational_stiffnesses)}},
           {Single{"principal_rotational_axes", json::rows(c.principal_rotational_axes.transpose())}},
           {Single{"coupling_at_k", json::number(c.coupling_at_k)}},
           {Single{"coupling_at_elastic_center", json::number(c.coupling_at_centre)}},
           {Single{"softest_combination", json::number(c.softest_combination)}},
           {Single{"stiffest_combination", json::number(c.stiffest_combination)}},
           {Table{.rows = row.size(),
                  .columns = {row("stiffness", Kind::words, "principal stiffness of K, N held", &Principal::stiffness),
                              row("axis", Kind::words, "axis (local)", &Principal::axis),
                              row("rotational", Kind::words, "principal rotational stiffness", &Principal::rotational),
                              row("rotational_axis", Kind::words, "axis (local)", &Principal::rotational_axis)},
                  .forms = for_people}},
           note_part(fmt::format("elastic centre: {} {} from K{}; rotational stiffnesses are about it",
                                 vector_words(length.factor * c.elastic_centre, least), length.unit,
                                 c.centre_is_unique ? "" : " (not unique: the nearest point of a line)")),
           note_part(fmt::format("coupling of translation and rotation, largest |K_ij|/√(K_ii K_jj): {:.3f} at K, "
                                 "{:.3f} at the elastic centre",
                                 c.coupling_at_k, c.coupling_at_centre)),
           note_part(fmt::format("strain energy of combined unit motions of end K over the sum of their single "
                                 "energies: {:.3g} … {:.3g} (1 … 1: uncoupled)",
                                 c.softest_combination, c.stiffest_combination))},
      .title = "Character"};
}

Group energy_group(const std::vector<ElementInMode>& modes) {
  constexpr double idle = 1e-4;  // share of the strain energy of a mode below which the element is not listed
  std::vector<std::size_t> shown;
  for (std::size_t k = 0; k < modes.size(); ++k)
    if (std::abs(modes[k].of_stored) >= idle && modes[k].inside.energy > 0) shown.push_back(k);
  const std::size_t others = modes.size() - shown.size();
  const Rows row(modes);
  const auto inside = [&](const char* name, const char* heading, double elements::EnergyShares::* part) {
    return row(name, Kind::share, heading, [part](const ElementInMode& mode) { return mode.inside.*part; });
  };
  return {.key = "",
          .parts = {{Table{.key = "modes",
                           .rows = row.size(),
                           .columns = {row("mode", Kind::number, "mode", &ElementInMode::number),
                                       row("frequency", Kind::frequency, "ω", &ElementInMode::angular_frequency,
                                           {.forms = for_people}),
                                       row("strain_energy_share", Kind::share, "", &ElementInMode::share),
                                       row("of_stored", Kind::share, "of the model's strain energy",
                                           &ElementInMode::of_stored, {.forms = for_people}),
                                       inside("translation", "in translation", &elements::EnergyShares::translation),
                                       inside("rotation", "in rotation", &elements::EnergyShares::rotation),
                                       inside("coupling", "in coupling", &elements::EnergyShares::coupling),
                                       row("name", Kind::words, "motion", &ElementInMode::name, {.forms = for_people})},
                           .people_rows = shown}},
                    note_part(shown.empty() || others == 0 ? "" : fmt::format("below 0.01 % in {} more", others))},
          .title = shown.empty() ? "Its strain energy is below 0.01 % in every undamped mode"
                                 : "Strain energy in the undamped modes and its parts inside the element, with K as "
                                   "reference point: three springs\nrepresent only the part in translation (coupling "
                                   "may be negative)"};
}

}  // namespace

Document element_document(const project::Case& variant, std::size_t index, const study::ElementSummary& summary,
                          const std::optional<study::Simplification>& simple) {
  const model::Element& element = variant.system.elements()[index];
  Document document = {{{Single{"name", element.name}},
                        {Single{"type", element.type}},
                        {Single{"n", json::end(variant, element.n)}},
                        {Single{"k", json::end(variant, element.k)}},
                        {Sentence{{fmt::format("Element \"{}\", {}", element.name, element.type)}}}}};
  add_ends(variant, element, document);
  add_facts(element, summary, document);
  add_stiffness(summary.stiffness, variant.display, document);
  document.add(damping_group(element));
  document.add(preload_group(element.law));
  document.add(check_group(element, summary.verdict));
  document.add(character_group(summary.stiffness_properties, variant.display));
  document.add(energy_group(summary.modes));
  add_law_loops(summary, variant.display, document);
  add_uncertainty(element, document);
  if (simple) document.add(simplification_group(*simple));
  else document.add(Single{"simplification", nullptr});
  document.add(Single{"warnings", json::warnings(summary.warnings)});
  return document;
}

}  // namespace trivet::results
