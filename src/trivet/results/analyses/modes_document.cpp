// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>

#include "trivet/documents/shown_numbers.h"
#include "trivet/documents/text_table.h"
#include "trivet/foundation/index.h"
#include "trivet/modal/foundation_feet.h"
#include "trivet/modal/modes.h"
#include "trivet/results/analyses/modes_document.h"
#include "trivet/results/format/result_writer.h"

/// Undamped modes.
namespace trivet::results {
namespace {

using modal::Mode;

constexpr const char* kinetic_share_words =
    "Shares of kinetic energy by coordinate at the poles: with those of elements and foundations they sum to 100 %; "
    "the "
    "inertia couples coordinates, so single ones may be above 100 % and others below 0";

json::Json screws(const Mode& mode) {
  json::Json result = json::Json::array();
  for (const spatial::Screw& screw : mode.screws) {
    json::Json one{{"direction", json::list(screw.direction)},
                   {"point", nullptr},
                   {"pitch", nullptr},
                   {"rotation", screw.rotation}};
    if (!screw.pure_translation) {
      one["point"] = json::list(screw.point);
      one["pitch"] = screw.pitch;
    }
    result.push_back(std::move(one));
  }
  return result;
}

/// "front left 38.2 %"; on the page also ", 3 more with the same share".
std::string most_strained(const project::Case& variant, const Mode& mode, bool with_others) {
  const auto most = modal::most_strained(mode);
  if (!most) return "–";
  const std::string where = most->in_foundations ? "foundations" : variant.system.elements()[most->element].name;
  return where + " " + percent(most->share) + modal::given_back_words(most->given_back) +
      (with_others && most->alike > 0 ? fmt::format(", {} more with the same share", most->alike) : "");
}

std::string motion_words(const Mode& mode) {
  return (mode.angular_frequency ? "" : "▲ unstable: ") + mode.name +
      (mode.repeated ? " (repeated root: one vector of an orthonormal basis)" : "");
}

/// Shares of a body in the kinetic energy of the machine with its foundations and the masses of elements:
/// "93.1 % / 6.9 %".
std::string kinetic_words(const Mode& mode, std::size_t body) {
  const double elsewhere = mode.foundation_kinetic_energy_share + mode.element_kinetic_energy_share.sum();
  const auto sum = [&](Eigen::Index from) {
    return percent((1 - elsewhere) * mode.principal_kinetic_energy_share.segment(6 * to_index(body) + from, 3).sum());
  };
  return sum(0) + " / " + sum(3);
}

std::vector<Column> kinetic_columns(const project::Case& variant, const Rows<Mode>& row) {
  const auto& bodies = variant.system.bodies();
  const auto massive = std::ranges::count_if(bodies, [](const model::Body& body) { return !body.is_node; });
  std::vector<Column> columns;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (!bodies[b].is_node)
      columns.push_back(
          row("kinetic " + bodies[b].name, Kind::words,
              fmt::format("kinetic energy{}: translation / rotation", massive > 1 ? " of " + bodies[b].name : ""),
              [b](const Mode& mode) { return kinetic_words(mode, b); }, {.forms = on_page}));
  return columns;
}

/// One row per mode, one column per coordinate of each body.
Table coordinate_table(const Rows<Mode>& row, const char* title, Column numbers) {
  numbers.digits = 4;
  numbers.forms = on_page;
  return {.title = title,
          .rows = row.size(),
          .columns = {row("mode", Kind::number, "mode", &Mode::number), std::move(numbers)},
          .folded = true,
          .forms = on_page};
}

/// Kinetic energy of each body; it does not depend on the pole.
Numbers body_shares(const Mode& mode) {
  std::vector<double> shares;
  for (Eigen::Index from = 0; from < mode.kinetic_energy_share.size(); from += 6)
    shares.push_back(mode.kinetic_energy_share.segment(from, 6).sum());
  return Numbers(std::move(shares));
}

/// The numbers of those modes of which they are wanted.
auto wanted(int shapes_of, auto list) {
  return [number = shapes_of, list](const Mode& mode) {
    return number == 0 || mode.number == number ? Numbers(std::invoke(list, mode)) : Numbers();
  };
}

Table mode_table(const project::Case& variant, const study::CaseResults& results, int shapes_of, const Column& shape,
                 const Column& kinetic_energy) {
  const Rows row(results.modes.list);
  const std::vector<std::string> elements = names_of(variant.system.elements());
  const auto of_coordinates = [&](const char* name, auto list, unsigned forms, const char* unit = "1") {
    return row.lists(name, "", "coordinate", shape.entries, wanted(shapes_of, list), {.unit = unit, .forms = forms});
  };
  const auto of_elements = [&](const char* name, auto list, unsigned forms) {
    return row.lists(name, "", "element", elements, wanted(shapes_of, list), {.forms = forms});
  };
  const auto screws_if_wanted = [number = shapes_of](const Mode& mode) {
    return number == 0 || mode.number == number ? screws(mode) : json::Json();
  };
  const unsigned on_a_screen_in_rad = frequency_unit(variant.display) == "rad/s" ? on_screen | in_summary : 0U;
  Table table{
      .key = "modes",
      .axis = "mode",
      .plain_names = true,
      .file = "modes.csv",
      .rows = row.size(),
      .columns = {row("number", Kind::number, "mode", &Mode::number),
                  row("eigenvalue_squared", Kind::number, "ω²", &Mode::eigenvalue_squared,
                      {.unit = "rad²/s²", .digits = 7, .forms = for_programs | on_a_screen_in_rad}),
                  row("angular_frequency", Kind::frequency, "ω", &Mode::angular_frequency, {.digits = 7}),
                  row("modal_mass", Kind::number, "", &Mode::modal_mass),
                  row("repeated", Kind::yes_no, "", &Mode::repeated), shape,
                  of_coordinates("shape_at_center_of_mass", &Mode::shape_at_centre, for_programs, unit_of_the_row),
                  kinetic_energy,
                  row.lists("body_kinetic_energy_share", "", "body", names_of(variant.system.bodies()), body_shares,
                            {.forms = in_json}),
                  of_coordinates("principal_kinetic_energy_share", &Mode::principal_kinetic_energy_share, in_json),
                  of_elements("element_kinetic_energy_share", &Mode::element_kinetic_energy_share, for_programs),
                  of_elements(
                      "strain_energy_share",
                      [](const Mode& mode) {
                        return mode.strain_energy_share ? Numbers(*mode.strain_energy_share) : Numbers();
                      },
                      for_programs),
                  row("foundation_strain_energy_share", Kind::number, "", &Mode::foundation_strain_energy_share,
                      {.forms = in_json}),
                  row("foundation_kinetic_energy_share", Kind::number, "", &Mode::foundation_kinetic_energy_share,
                      {.forms = in_json}),
                  row("screws", Kind::words, "", screws_if_wanted, {.forms = in_json}),
                  row("name", Kind::words, "", &Mode::name),
                  row("strained", Kind::words, "most strain energy in",
                      [&variant](const Mode& mode) { return most_strained(variant, mode, false); },
                      {.forms = on_screen | in_summary}),
                  row("strained", Kind::words, "most strain energy in",
                      [&variant](const Mode& mode) { return most_strained(variant, mode, true); }, {.forms = on_page}),
                  row("motion", Kind::words, "motion", motion_words, {.forms = for_people})},
      .json = {"number",
               "eigenvalue_squared",
               "angular_frequency",
               {"frequency_hz", "angular_frequency [Hz]"},
               "modal_mass",
               "repeated",
               "shape",
               "shape_at_center_of_mass",
               "kinetic_energy_share",
               "body_kinetic_energy_share",
               "principal_kinetic_energy_share",
               "element_kinetic_energy_share",
               "strain_energy_share",
               "foundation_strain_energy_share",
               "foundation_kinetic_energy_share",
               "screws",
               "name"},
      .csv = {{"mode", "number"},
              {"angular_frequency_squared [rad2/s2]", "eigenvalue_squared"},
              "angular_frequency [rad/s]",
              {"frequency [Hz]", "angular_frequency [Hz]"},
              "name",
              {"shape {}", "shape"},
              {"strain energy share {}", "strain_energy_share"}},
      .arrays = {{"mode", "number"},
                 "eigenvalue_squared",
                 "angular_frequency",
                 {"frequency", "angular_frequency [Hz]"},
                 "name",
                 "modal_mass",
                 "repeated",
                 "shape",
                 "shape_at_center_of_mass",
                 "kinetic_energy_share",
                 "element_kinetic_energy_share",
                 "strain_energy_share"},
      .mark = [&results](std::size_t i) { return results.modes.list[i].angular_frequency ? Mark::plain : Mark::bad; }};
  std::ranges::move(kinetic_columns(variant, row), std::back_inserter(table.columns));
  if (!modal::elements_on_foundations(variant.system).empty()) {
    const auto feet = [&system = variant.system, layout = assembly::Layout(variant.system.description()),
                       number = shapes_of](const Mode& mode) {
      if (number != 0 && mode.number != number) return json::Json();
      return json::rows(modal::foundation_feet(system, layout, mode.coordinates).transpose().eval());
    };
    table.columns.push_back(row("feet", Kind::words, "", feet, {.forms = in_json}));
    table.json.emplace_back("feet");
  }
  return table;
}

}  // namespace

Document modes_document(const project::Case& variant, const study::CaseResults& results, int shapes_of) {
  const Rows row(results.modes.list);
  const std::vector<std::string> coordinates = shape_coordinates(variant);
  const Column shape = row.lists("shape", "shape", "coordinate", coordinates, wanted(shapes_of, &Mode::shape),
                                 {.unit = unit_of_the_row, .forms = for_programs});
  const Column kinetic = row.lists("kinetic_energy_share", "share", "coordinate", coordinates,
                                   wanted(shapes_of, &Mode::kinetic_energy_share), {.forms = for_programs});
  Document document;
  document.add(Words{.key = "bodies", .list = names_of(variant.system.bodies())});
  document.add(Words{.key = "elements", .list = names_of(variant.system.elements())});
  add_feet(variant, document);
  document.add(Sentence{
      .parts = {"Undamped modes" +
                (results.lowest_modes > 0 ? fmt::format(", the lowest {}", results.lowest_modes) : std::string())},
      .forms = on_screen | in_summary});
  document.add(mode_table(variant, results, shapes_of, shape, kinetic));
  add_shape_coordinates(variant, {"1/√kg", "rad/(m √kg)"}, document);
  document.add(Words{.axis = "element", .list = names_of(variant.system.elements())});
  document.add(
      coordinate_table(row, "Mode shapes at the poles: x, y, z [m], θx, θy, θz [rad], unit modal mass", shape));
  document.add(coordinate_table(row, kinetic_share_words, kinetic));
  document.add(Single{.name = "kinetic_energy_share_words", .value = kinetic_share_words});
  document.add(Single{.name = "free_motions", .value = results.free_motions});
  document.add(warnings_part(results));
  return document;
}

std::vector<std::string> shape_coordinates(const project::Case& variant) {
  std::vector<std::string> names;
  for (const model::Body& body : variant.system.bodies())
    for (const char* coordinate : model::coordinate_names) names.push_back(body.name + "." + coordinate);
  return names;
}

void add_feet(const project::Case& variant, Document& document) {
  std::vector<std::string> names;
  for (const std::size_t e : modal::elements_on_foundations(variant.system))
    names.push_back(variant.system.elements()[e].name + ".foot");
  if (!names.empty()) document.add(Words{.key = "feet", .list = std::move(names)});
}

void add_shape_coordinates(const project::Case& variant, const ShapeUnits& shape, Document& document) {
  std::vector<std::string> units;
  for (std::size_t j = 0; j < 6 * variant.system.bodies().size(); ++j)
    units.emplace_back(j % 6 < 3 ? shape.translation : shape.rotation);
  document.add(Words{.axis = "coordinate", .list = shape_coordinates(variant)});
  document.add(Words{.axis = "coordinate", .list = std::move(units), .name = "coordinate.unit"});
}

const ResultWriter modes_results = {
    .has_result = [](const project::Case& variant, const study::CaseResults&) { return variant.analyses.modes; },
    .document = [](const project::Case& variant,
                   const study::CaseResults& results) { return modes_document(variant, results, 0); },
    .files = {"modes.csv"}};

}  // namespace trivet::results
