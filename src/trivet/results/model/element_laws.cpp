// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <variant>

#include "trivet/documents/shown_numbers.h"
#include "trivet/documents/text_table.h"
#include "trivet/foundation/constants.h"
#include "trivet/foundation/significant_digits.h"
#include "trivet/results/model/element_results.h"

/// What the 12×12 of an element does not contain: its uncertainty, damping, and what depends on the frequency and on
/// the amplitude.
namespace trivet::results {
namespace {

using foundation::two_pi;
using nonlinear::AmplitudeStiffness;
using nonlinear::LawLoop;
using project::DisplayUnits;

std::string law_of_damping(const elements::Law& law) {
  if (const auto* p = std::get_if<elements::ProportionalDamping>(&law.damping))
    return fmt::format("B = {:.6g} s × the {} stiffness", p->factor, p->of_nominal ? "nominal" : "scaled");
  if (const auto* l = std::get_if<elements::LossFactor>(&law.damping))
    return fmt::format("loss factor {:.6g}", l->value);
  if (std::holds_alternative<elements::DampingMatrix>(law.damping)) return "a viscous damping matrix";
  if (const auto* v = std::get_if<elements::Viscoelastic>(&law.damping)) return elements::law_description(*v);
  if (law.frequency_dependence && !law.frequency_dependence->elastic) return "in its table";
  return "none";
}

std::string words_of_damping(const model::Element& element) {
  const double over_distance = std::accumulate(
      element.distance_parts.begin(), element.distance_parts.end(), 0.0,
      [](double sum, const model::DistancePart& part) {
        return sum + elements::force_in_motion(part.law, part.at_rest, Eigen::Vector3d::Zero()).by_rate.trace();
      });
  return over_distance > 0
      ? foundation::prefixed_exactly(over_distance, "N s/m", 6) + " along the line between its ends, at rest"
      : law_of_damping(element.law);
}

std::vector<Sentence> notes_on_frequency(const model::Element& element) {
  const elements::Law& law = element.law;
  std::vector<Sentence> notes;
  const auto note = [&](std::vector<std::variant<std::string, Quantity>> words) {
    notes.push_back({.parts = std::move(words), .place = Sentence::Place::note});
  };
  const auto frequency = [](double omega) { return Quantity{omega, "rad/s", Kind::frequency, 6}; };
  for (const model::NonlinearPart& part : element.nonlinear_parts) {
    const double damping = elements::small_motion(part.laws, part.at_rest).damping;
    if (damping == 0 || part.is_inner()) continue;
    note({fmt::format("its laws add {} {} {} at rest",
                      foundation::prefixed_exactly(damping, part.is_rotation() ? "N m s/rad" : "N s/m", 6),
                      part.is_rotation() ? "about" : "along", "xyz"[part.axis % 3])});
  }
  if (const auto& given = law.frequency_dependence) {
    const std::string words = std::string("Frequency dependence: the stiffness above is static; ") +
        (given->elastic ? "with its own mass, exact at every frequency" : "a table");
    if (std::isfinite(given->to)) note({words + " from ", frequency(given->from), " to ", frequency(given->to)});
    else note({words});
  } else if (elements::is_frequency_dependent(law) || std::holds_alternative<elements::Viscoelastic>(law.damping)) {
    note({"Frequency dependence: the material relaxes; the stiffness above is static"});
  }
  if (law.inertia && law.inertia->angular_frequencies.size() > 0) {
    note({"Own natural frequencies, both ends held: "});
    for (const double omega : law.inertia->angular_frequencies) {
      if (notes.back().parts.size() > 1) notes.back().parts.emplace_back(", ");
      notes.back().parts.emplace_back(Quantity{omega, "rad/s", Kind::frequency});
    }
  }
  if (std::isfinite(element.massless_up_to))
    note({"Its mass is neglected: results are valid only below its first natural frequency, ",
          Quantity{element.massless_up_to, "rad/s", Kind::frequency}});
  return notes;
}

Table loop_table(const study::ElementLaws& laws) {
  const Rows row(laws.loops);
  const std::string deflection = laws.turns ? "rad" : "m", force = laws.turns ? "N m" : "N",
                    stiffness = laws.turns ? "N m/rad" : "N/m";
  const auto energy = [](const LawLoop& loop) {
    return without_round_off(loop.energy, loop.amplitude * loop.amplitude * loop.storage);
  };
  const auto shown = [](std::string unit) {
    return ColumnOptions{.unit = std::move(unit), .digits = 4, .forms = for_people};
  };
  const auto both = [](std::string unit) { return ColumnOptions{.unit = std::move(unit), .digits = 4}; };
  return {.key = "loops",
          .rows = row.size(),
          .columns = {row("amplitude", Kind::quantity, "amplitude", &LawLoop::amplitude, both(deflection)),
                      row(
                          "from", Kind::quantity, "force from",
                          [](const LawLoop& loop) { return std::ranges::min(loop.forces); }, shown(force)),
                      row(
                          "to", Kind::quantity, "to", [](const LawLoop& loop) { return std::ranges::max(loop.forces); },
                          shown(force)),
                      row("storage", Kind::quantity, "storage", &LawLoop::storage, both(stiffness)),
                      row("loss", Kind::quantity, "loss", &LawLoop::loss, both(stiffness)),
                      row("energy", Kind::quantity, "", &LawLoop::energy, {.unit = "J", .forms = in_json}),
                      row("energy", Kind::quantity, "lost per cycle", energy, shown("J")),
                      row("deflections", Kind::words, "", &LawLoop::deflections, {.forms = in_json}),
                      row("forces", Kind::words, "", &LawLoop::forces, {.forms = in_json})},
          .one_prefix = true};
}

/// At frequencies that divide the band evenly.
Table stiffness_over_frequency(const std::vector<AmplitudeStiffness>& list, const DisplayUnits& display) {
  constexpr int rows = 8;
  double from = foundation::infinity, to = 0;
  for (const AmplitudeStiffness& one : list)
    for (const double omega : one.angular_frequency) {
      from = std::min(from, omega);
      to = std::max(to, omega);
    }
  std::vector<double> frequencies;
  for (int i = 0; i < rows && to > 0; ++i) frequencies.push_back(from * std::pow(to / from, i / (rows - 1.0)));
  const Rows row(std::move(frequencies));
  Table table{.rows = row.size(),
              .columns = {row("frequency", Kind::frequency, "ω", [](double omega) { return omega; }, {.digits = 4})},
              .forms = for_people};
  for (const AmplitudeStiffness& one : list) {
    const auto words = [&one, unit = display_unit(display, "N/m")](double omega) {
      const std::optional<std::complex<double>> found = one.at(omega);
      return found
          ? Json(fmt::format("{}, {:.1f}°", value_text(std::abs(*found), unit), std::arg(*found) * 360 / two_pi))
          : Json();
    };
    table.columns.push_back(
        row("stiffness", Kind::words, "± " + value_text(one.amplitude, display_unit(display, "m")), words));
  }
  return table;
}

struct DiagonalEntry {
  std::string name;
  const char* unit;
  double value, half_width;
};

Group uncertainty_group(const model::Element& element) {
  if (!element.evidence) return {.key = "", .parts = {{Single{"uncertainty", nullptr}}}};
  const model::Evidence& evidence = *element.evidence;
  const elements::Matrix12 half = element.law.scale * evidence.uncertainty;
  std::vector<DiagonalEntry> diagonal;
  for (int i = 0; i < 12; ++i)
    diagonal.push_back({fmt::format("{} {}", i < 6 ? "N" : "K", study::component_name(i)),
                        i % 6 < 3 ? "N/m" : "N m/rad", element.law.scale * element.law.nominal_stiffness(i, i),
                        half(i, i)});
  const auto part = [](const DiagonalEntry& entry) {
    return entry.value != 0 ? std::optional(entry.half_width / std::abs(entry.value)) : std::nullopt;
  };
  const Rows row(std::move(diagonal));
  return {.key = "uncertainty",
          .parts = {{Single{"meaning", evidence.meaning}},
                    {Single{"stiffness", json::rows(half)}},
                    {Table{.rows = row.size(),
                           .columns = {row("entry", Kind::words, "diagonal entry", &DiagonalEntry::name),
                                       row("unit", Kind::words, "", &DiagonalEntry::unit),
                                       row("value", Kind::quantity, "value", &DiagonalEntry::value),
                                       row("half", Kind::quantity, "±", &DiagonalEntry::half_width, {.digits = 3}),
                                       row("part", Kind::share, "of the value", part)},
                           .forms = for_people}}},
          .title = "Uncertainty (" + evidence.meaning + ")"};
}

}  // namespace

Group damping_group(const model::Element& element) {
  const elements::Law& law = element.law;
  Group group{.key = "",
              .parts = {{Single{"damping", json::rows(elements::viscous_damping(law))}},
                        {Single{"loss_factor", elements::loss_factor(law)}},
                        {Single{"mass", law.inertia ? json::rows(law.inertia->mass) : Json(nullptr)}},
                        {Single{"internal_angular_frequencies",
                                law.inertia ? json::list(law.inertia->angular_frequencies) : Json::array()}},
                        {Single{"frequency_dependent", elements::is_frequency_dependent(law)}},
                        {Single{"massless_up_to", json::number(element.massless_up_to)}}},
              .title = "Damping: " + words_of_damping(element)};
  for (Sentence& note : notes_on_frequency(element)) group.parts.push_back({std::move(note)});
  return group;
}

void add_law_loops(const study::ElementSummary& summary, const DisplayUnits& display, Document& document) {
  document.add(Single{"laws", Json::array()});
  for (const study::ElementLaws& laws : summary.laws)
    document.add(
        Group{.key = "laws",
              .parts = {{Single{"axis", laws.axis}},
                        {Single{"at_rest", laws.at_rest}},
                        {Single{"has_dampers", laws.damped}},
                        {loop_table(laws)}},
              .title = fmt::format("{} {}{}, about rest at a deflection of {}{}", laws.whole ? "Force" : "Laws",
                                   laws.words, laws.whole ? "" : " alone (the 12×12 above contains their tangents)",
                                   value_text(laws.at_rest, display_unit(display, laws.turns ? "rad" : "m")),
                                   laws.damped ? "; dampers left out" : ""),
              .in_list = true});
  const Rows row(summary.over_amplitude);
  Group& over = document.add(Group{
      .key = "",
      .parts = {{Table{.key = "over_amplitude",
                       .rows = row.size(),
                       .columns = {row("amplitude", Kind::quantity, "", &AmplitudeStiffness::amplitude, {.unit = "m"}),
                                   row("angular_frequency", Kind::words, "", &AmplitudeStiffness::angular_frequency,
                                       {.forms = in_json}),
                                   row.lists("stiffness", "", "", {}, &AmplitudeStiffness::stiffness),
                                   row("ended", Kind::words, "", &AmplitudeStiffness::ended)},
                       .forms = in_json}},
                {stiffness_over_frequency(summary.over_amplitude, display)}},
      .title = row.size() == 0
          ? ""
          : "Dynamic stiffness along z of end K, N held, over frequency and amplitude: magnitude "
            "and loss angle"});
  for (const AmplitudeStiffness& one : summary.over_amplitude)
    if (!one.ended.empty())
      over.parts.push_back({Sentence{.parts = {"± ", Quantity{one.amplitude, "m", Kind::quantity, 4}, ": " + one.ended},
                                     .place = Sentence::Place::note}});
}

void add_uncertainty(const model::Element& element, Document& document) {
  using model::Residual;
  static const std::vector<Residual> none;
  const std::vector<Residual>& residuals = element.evidence ? element.evidence->residuals : none;
  document.add(uncertainty_group(element));
  const Rows row(residuals);
  document.add(Table{
      .key = "residuals",
      .rows = row.size(),
      .columns = {row("what", Kind::words, "", &Residual::what), row("measured", Kind::number, "", &Residual::measured),
                  row("fitted", Kind::number, "", &Residual::fitted),
                  row("standardised", Kind::number, "", &Residual::standardised),
                  row("outlier", Kind::yes_no, "", &Residual::outlier)},
      .forms = in_json});
  for (const Residual& r : residuals)
    if (r.outlier)
      document.add(
          Sentence{.parts = {fmt::format("outlier: {}: measured {:.6g}, fitted {:.6g} ({:+.1f} standard deviations)",
                                         r.what, r.measured, r.fitted, r.standardised)},
                   .place = Sentence::Place::note});
}

}  // namespace trivet::results
