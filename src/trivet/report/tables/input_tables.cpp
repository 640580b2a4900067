// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/tables/input_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <variant>

#include "trivet/documents/html_table.h"
#include "trivet/documents/text_table.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/foundation/unit_prefix.h"
#include "trivet/model/point_mass.h"
#include "trivet/report/drawing/in_documents.h"
#include "trivet/report/drawing/svg_canvas.h"
#include "trivet/report/tables/engine_facts.h"
#include "trivet/report/tables/folded_parts.h"
#include "trivet/results/model/law_assumptions.h"
#include "trivet/results/model/model_words.h"

namespace trivet::report {

namespace {

using results::number_text;

constexpr std::array<const char*, 6> motions = {"x", "y", "z", "θx", "θy", "θz"};
constexpr std::array<const char*, 6> forces = {"Fx", "Fy", "Fz", "Mx", "My", "Mz"};

template <typename Vector>
std::string listed(const Vector& values, int digits) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ", ") + number_text(value, digits);
  return text;
}

template <typename Vector>
std::string vector_words(const Vector& values) {
  return "(" + listed(values, 7) + ")";
}

std::string axes_words(const Eigen::Matrix3d& axes) {
  constexpr double round_off = 1e-12;
  if ((axes - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < round_off) return "are parallel to the ground axes";
  std::string rows;
  for (Eigen::Index i = 0; i < 3; ++i) rows += " " + vector_words(axes.row(i).transpose().eval());
  return "are the columns of the matrix with the rows" + rows + " in the ground";
}

/// A square matrix with the same labels for rows and columns.
std::string matrix_table(const std::vector<std::string>& labels, const Eigen::MatrixXd& matrix) {
  std::vector<Cell> headings = {{""}};
  for (const std::string& label : labels) headings.push_back({label});
  std::vector<Row> rows;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    rows.push_back({{{labels[static_cast<std::size_t>(i)]}}, ""});
    for (const double value : matrix.row(i)) rows.back().cells.push_back({number_text(value)});
  }
  return html_table(headings, rows, labels.size() == 12 ? "matrix of-ends" : "matrix");
}

std::vector<std::string> end_labels() {
  std::vector<std::string> labels;
  for (const char* end : {"N", "K"})
    for (const char* motion : motions) labels.push_back(fmt::format("{} {}", end, motion));
  return labels;
}

std::string coordinates_words(const std::array<bool, 6>& named) {
  std::string words;
  for (std::size_t j = 0; j < 6; ++j)
    if (named[j]) words += (words.empty() ? "" : " ") + std::string(motions[j]);
  return words.empty() ? "none" : words;
}

std::string bodies_tables(const std::vector<model::Body>& bodies) {
  std::vector<Row> rows;
  std::string inertia;
  for (const model::Body& b : bodies) {
    if (b.is_node) continue;
    const Eigen::Vector3d moments = spatial::principal_inertia(b.mass).moments;
    std::string points;
    for (const model::Point& p : b.points) points += "<div>" + escaped(p.name + " " + vector_words(p.at)) + "</div>";
    rows.push_back(
        {{{b.name},
          right(number_text(b.mass.mass)),
          {vector_words(b.mass.centre)},
          {listed(moments, 6), false, moments.minCoeff() <= 0 && !model::is_point_mass(b) ? Tone::bad : Tone::plain},
          {coordinates_words(b.free)},
          {vector_words(b.pose.position)},
          html_cell(points)},
         ""});
    inertia += paragraph(b.name + ": the body axes " + axes_words(b.pose.rotation)) +
        matrix_table({"x", "y", "z"}, spatial::inertia_about_pole(b.mass));
  }
  return html_table({{"body"},
                     right("mass [kg]"),
                     {"centre of mass [m]"},
                     {"principal central moments [kg m²]"},
                     {"free coordinates"},
                     {"pole in ground [m]"},
                     {"points [m]"}},
                    rows) +
      folded("Inertia about the pole [kg m²] and axes of the bodies", inertia);
}

std::string nodes_table(const std::vector<model::Body>& bodies) {
  std::vector<std::vector<Cell>> rows;
  for (const model::Body& b : bodies)
    if (b.is_node)
      rows.push_back({{b.name},
                      {vector_words(b.pose.position)},
                      {coordinates_words(b.free)},
                      {coordinates_words(b.left_out)},
                      {axes_words(b.pose.rotation)}});
  return rows.empty() ? ""
                      : html_table({{"node"},
                                    {"position in ground [m]"},
                                    {"free coordinates"},
                                    {"left out: held by no element"},
                                    {"its axes"}},
                                   rows);
}

/// A table of what the input file states too: paper leaves it out, because the file is in the appendix.
std::string marked_if_in_file(const std::string& table, const std::vector<std::string>& names,
                              const std::string& file_text) {
  const bool is_in_file = !file_text.empty() &&
      std::ranges::all_of(names, [&](const std::string& name) { return file_text.find(name) != std::string::npos; });
  return is_in_file ? "<div data-in-file>" + table + "</div>\n" : table;
}

std::string facts_table(const std::vector<model::Fact>& facts) {
  std::vector<std::vector<Cell>> rows;
  for (const model::Fact& fact : facts) rows.push_back({{fact.what}, {fact.value}});
  return html_table({{"what"}, {"value"}}, rows);
}

std::string elements_tables(const model::Description& d, const std::string& file_text) {
  const auto owner = [&](const model::End& end) -> std::string {
    return end.body      ? d.bodies[*end.body].name
        : end.foundation ? d.foundations[end.foundation->foundation].name
                         : "ground";
  };
  std::vector<std::vector<Cell>> rows;
  std::vector<std::string> names;
  FoldedParts facts("How it was determined: "), laws("Laws of "), stiffness("Stiffness 12×12 of "),
      viscous("Viscous damping 12×12 of ");
  for (const model::Element& e : d.elements) {
    const spatial::Pose n = model::end_in_ground(d.bodies, e.n), k = model::end_in_ground(d.bodies, e.k);
    names.push_back(e.name);
    rows.push_back({{e.name},
                    {e.type},
                    {owner(e.n)},
                    {vector_words(n.position)},
                    {owner(e.k)},
                    {vector_words(k.position)},
                    right(number_text(e.law.scale)),
                    {results::damping_words(e.law.damping)}});
    if (!e.facts.empty()) facts.add(e.name, facts_table(e.facts));
    if (model::has_laws(e)) laws.add(e.name, facts_table(results::law_facts(e)));
    stiffness.add(e.name,
                  hint("Scale included; [N/m], [N/rad], [N m/m], [N m/rad]. The local axes of N " +
                       axes_words(n.rotation) + "; those of K " + axes_words(k.rotation) + ".") +
                      matrix_table(end_labels(), elements::stiffness(e.law)));
    if (std::holds_alternative<elements::DampingMatrix>(e.law.damping))
      viscous.add(e.name,
                  hint("[N s/m], [N s/rad], [N m s/m], [N m s/rad], in the same axes.") +
                      matrix_table(end_labels(), elements::viscous_damping(e.law)));
  }
  const std::string table = html_table({{"element"},
                                        {"type"},
                                        {"end N on"},
                                        {"N in ground [m]"},
                                        {"end K on"},
                                        {"K in ground [m]"},
                                        right("scale"),
                                        {"damping"}},
                                       rows);
  return marked_if_in_file(table, names, file_text) + facts.html() + laws.html() + stiffness.html() + viscous.html();
}

/// "Fz 18 N, Mx 2 N m": the components that are not zero.
std::string component_words(const std::array<const char*, 6>& names, const Eigen::Vector3d& linear,
                            const std::string& linear_unit, const Eigen::Vector3d& angular,
                            const std::string& angular_unit) {
  std::string words;
  for (std::size_t j = 0; j < 6; ++j) {
    const double value = j < 3 ? linear(static_cast<Eigen::Index>(j)) : angular(static_cast<Eigen::Index>(j) - 3);
    if (value != 0)
      words += fmt::format("{}{} {} {}", words.empty() ? "" : ", ", names[j], number_text(value),
                           j < 3 ? linear_unit : angular_unit);
  }
  return words.empty() ? "–" : words;
}

std::string excitations_table(const project::Case& variant) {
  const model::Description& d = variant.system.description();
  std::vector<std::vector<Cell>> rows;
  for (const model::Excitation& e : d.excitations) {
    const results::ExcitationNumbers n = results::excitation_numbers(e);
    const Eigen::VectorXd degrees = n.phase * (360 / foundation::two_pi);
    rows.push_back(
        {{e.name},
         {n.type},
         {e.action.body ? d.bodies[*e.action.body].name : "ground"},
         {vector_words(e.action.at)},
         {std::holds_alternative<model::Orders>(e.course)
              ? "at each order: its course"
              : component_words(e.action.body ? forces : motions, n.linear, n.linear_unit, n.angular, n.angular_unit)},
         {degrees.isZero(0) ? "–" : vector_words(degrees)}});
  }
  for (const model::ConstantForce& f : d.constant_forces)
    rows.push_back({{f.name},
                    {"constant"},
                    {d.bodies[f.body].name},
                    {vector_words(f.at)},
                    {component_words(forces, f.wrench.force, "N", f.wrench.moment, "N m")},
                    {"–"}});
  FoldedParts courses("Course of ");
  for (const model::Excitation& e : d.excitations) {
    std::vector<model::Fact> facts = engine_facts(variant, e.name);
    for (model::Fact& fact : results::course_facts(e)) facts.push_back(std::move(fact));
    if (!facts.empty()) courses.add(e.name, facts_table(facts));
  }
  return rows.empty() ? ""
                      : html_table({{"excitation"},
                                    {"type"},
                                    {"on"},
                                    {"at, body or ground axes [m]"},
                                    {"components"},
                                    {"phases of the six [°]"}},
                                   rows) +
          courses.html();
}

std::string foundations_table(const std::vector<model::Foundation>& foundations, const std::string& file_text) {
  std::vector<std::vector<Cell>> rows;
  std::vector<std::string> names;
  for (const model::Foundation& f : foundations) {
    names.push_back(f.name);
    for (Eigen::Index i = 0; i < f.mass.rows(); ++i) {
      const bool of_element = f.stiffness(i, i) == 0;  // an impedance or a mobility is in the table of elements
      rows.push_back({{f.name},
                      right(std::to_string(i + 1)),
                      right(number_text(f.mass(i, i))),
                      of_element ? right("see elements") : right(number_text(f.stiffness(i, i))),
                      of_element ? right("see elements") : right(number_text(f.damping(i, i)))});
    }
  }
  const std::string table = html_table({{"foundation"},
                                        right("coordinate"),
                                        right("mass [kg, kg m²]"),
                                        right("stiffness [N/m, N m/rad]"),
                                        right("damping [N s/m, N m s/rad]")},
                                       rows);
  return marked_if_in_file(table, names, file_text);
}

std::string gravity_words(const model::Description& d) {
  if (!d.gravity) return "No gravity.";
  return "Gravity " + vector_words(*d.gravity) +
      " m/s², ground axes: the weight of the bodies and of elements with mass" +
      (d.foundations.empty() ? "" : ", not that of flexible foundations") + ". It acts in static results" +
      (d.second_order ? ", and its forces at rest change the stiffness." : " alone (second_order = false).");
}

std::string damping_of_all_words(const model::Description& d) {
  const bool none = std::holds_alternative<std::monostate>(d.damping);
  return "Damping of the system: " + results::damping_words(d.damping) +
      (d.foundations.empty() ? ""
           : none            ? " and of the flexible foundations"
                             : ", besides that of the elements and the flexible foundations") +
      ".";
}

std::string part(const std::string& title, const std::string& html) {
  return "<h3>" + title + "</h3>\n" + (html.empty() ? "<p>None.</p>\n" : html);
}

}  // namespace

std::string input_tables(const project::Case& variant, const std::string& file_text) {
  const model::Description& d = variant.system.description();
  const std::string nodes = nodes_table(d.bodies);
  const std::string assumptions = as_html(results::assumptions_document(variant), variant.display);
  return part("Bodies", d.bodies.empty() ? "" : bodies_tables(d.bodies)) + (nodes.empty() ? "" : part("Nodes", nodes)) +
      part("Elements", d.elements.empty() ? "" : elements_tables(d, file_text)) +
      (assumptions.empty() ? "" : part("Laws of the elements and what they assume", assumptions)) +
      part("Excitations", excitations_table(variant)) +
      (d.foundations.empty() ? "" : part("Flexible foundations", foundations_table(d.foundations, file_text))) +
      (d.relative_motions.empty() && d.sections.empty() && d.clearances.empty()
           ? ""
           : part("Relative motions, sections and clearances", observations_table(d))) +
      paragraph(gravity_words(d)) + paragraph(damping_of_all_words(d));
}

namespace {

std::string components_words(const Eigen::Vector3d& v) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", v(0), v(1), v(2));
}

std::string section_words(const model::Description& d, const model::Section& section) {
  std::vector<std::string> names;
  for (const std::size_t e : section.elements) names.push_back(d.elements[e].name);
  return foundation::comma_separated(names);
}

}  // namespace

std::string observations_table(const model::Description& d) {
  std::vector<std::vector<Cell>> rows;
  for (const model::RelativeMotion& motion : d.relative_motions)
    rows.push_back({{motion.name},
                    {"relative motion"},
                    {motion.of.name + " relative to " + motion.to.name},
                    {"axis " + components_words(motion.axes.col(2))}});
  for (const model::Section& section : d.sections)
    rows.push_back({{section.name},
                    {"section"},
                    {section_words(d, section)},
                    {"about " + components_words(section.at) + " m, z axis " + components_words(section.axes.col(2))}});
  for (const model::Clearance& clearance : d.clearances)
    rows.push_back({{clearance.name},
                    {"clearance"},
                    {clearance.of.name + " to " + clearance.to.name},
                    {fmt::format("gap {} along {}", foundation::prefixed(clearance.gap, "m"),
                                 components_words(clearance.direction))}});
  return html_table({{"name"}, {"kind"}, {"of"}, {"ground frame"}}, rows);
}

}  // namespace trivet::report
