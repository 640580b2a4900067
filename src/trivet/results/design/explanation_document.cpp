// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "trivet/documents/shown_numbers.h"
#include "trivet/foundation/constants.h"
#include "trivet/results/design/explanation_results.h"
#include "trivet/results/format/json_parts.h"
#include "trivet/results/format/shown_words.h"

/// Causes of peaks, and the parameters that change them.
namespace trivet::results {
namespace {

using response::ElementShare;
using response::ModeShare;
using response::PeakShares;
using study::ExplainedPeak;
using study::Explanation;

constexpr double worth_a_row = 0.005, worth_a_digit = 5e-4;

Json trial_json(const std::optional<study::Trial>& trial) {
  if (!trial) return nullptr;
  return {{"parameter", trial->parameter},
          {"amount", trial->amount},
          {"first_order",
           {{"angular_frequency", json::optional(trial->predicted_angular_frequency)},
            {"amplitude", json::optional(trial->predicted_amplitude)}}},
          {"solved_again",
           {{"angular_frequency", json::optional(trial->angular_frequency)},
            {"amplitude", json::optional(trial->amplitude)}}}};
}

Table mode_shares(const Explanation& explanation, const PeakShares& shares) {
  const Rows row(shares.modes);
  std::vector<std::size_t> shown;
  for (std::size_t k = 0; k < row.size(); ++k)
    if (std::abs(shares.modes[k].share) >= worth_a_row) shown.push_back(k);
  const auto name = [&explanation](const ModeShare& mode) { return explanation.modes.list[mode.mode - 1].name; };
  return {.key = "modes",
          .rows = row.size(),
          .columns = {row("mode", Kind::number, "mode", &ModeShare::mode),
                      row("name", Kind::words, "", name, {.forms = in_json}),
                      row("part", Kind::words, "", &ModeShare::part, {.forms = in_json}),
                      row("share", Kind::share, "share of the amplitude", &ModeShare::share),
                      row("name", Kind::words, "motion", name, {.forms = for_people})},
          .people_rows = shown};
}

/// Shares of the sum, which may exceed 1 where other energies are negative.
Table element_shares(const project::Case& variant, const PeakShares& shares) {
  const Rows row(shares.elements);
  return {.key = "elements",
          .rows = row.size(),
          .columns = {row("name", Kind::words, "", [&](std::size_t e) { return variant.system.elements()[e].name; }),
                      row("stored", Kind::share, "", &ElementShare::stored),
                      row.lists("by_direction", "", "", {}, &ElementShare::by_direction),
                      row("dissipated", Kind::share, "", &ElementShare::dissipated)},
          .forms = in_json};
}

struct ShownEnergy {
  std::string of;
  std::optional<double> stored, dissipated;
  std::optional<std::array<double, 6>> by_direction = {};
};

/// Shares of the positive energies, where none exceeds 1.
Table energy_table(const project::Case& variant, const PeakShares& shares) {
  std::vector<ShownEnergy> list;
  for (std::size_t e = 0; e < shares.elements.size(); ++e) {
    const ElementShare& of = shares.elements[e];
    std::array<double, 6> by_direction{};
    std::ranges::transform(of.by_direction, by_direction.begin(),
                           [](double share) { return std::abs(share) < worth_a_digit ? 0 : share; });
    list.push_back({variant.system.elements()[e].name, of.stored, of.dissipated, by_direction});
  }
  const auto add = [&](const char* of, std::optional<double> stored, std::optional<double> dissipated) {
    const auto large = [](const std::optional<double>& share) { return share && std::abs(*share) >= worth_a_row; };
    if (large(stored) || large(dissipated)) list.push_back({of, stored, dissipated});
  };
  add("geometric stiffness (preload, weight)", shares.geometric, {});
  add("foundations", shares.in_foundations, shares.by_foundations);
  add("damping of the whole system", {}, shares.system_damping);
  const Rows row(std::move(list));
  Table table{.rows = row.size(),
              .columns = {row("element", Kind::words, "element", &ShownEnergy::of),
                          row("stored", Kind::share, "strain energy", &ShownEnergy::stored)},
              .forms = for_people};
  static constexpr std::array directions = {"along x", "y", "z", "about x", "y", "z"};
  for (std::size_t j = 0; j < directions.size(); ++j)
    table.columns.push_back(row("by_direction", Kind::share, directions[j], [j](const ShownEnergy& energy) {
      return energy.by_direction ? std::optional((*energy.by_direction)[j]) : std::nullopt;
    }));
  table.columns.push_back(row("dissipated", Kind::share, "dissipated", &ShownEnergy::dissipated));
  return table;
}

/// A parameter with its effect on a peak.
struct Lever {
  const ExplainedPeak* on;
  const response::Sensitivity* slope;
  const response::Parameter* parameter;

  [[nodiscard]] std::optional<double> change(std::optional<double> response::Sensitivity::* of) const {
    return slope->*of ? std::optional(*(slope->*of) * parameter->size) : std::nullopt;
  }
};

void add_levers(const Explanation& explanation, const ExplainedPeak& peak, std::vector<Lever>& list) {
  for (const response::Sensitivity& slope : peak.sensitivities)
    list.push_back({&peak, &slope, &explanation.parameters[slope.parameter]});
}

Table lever_table(std::vector<Lever> levers) {
  using response::Sensitivity;
  const Rows row(std::move(levers));
  const auto peak = [&](const char* name, Kind kind, auto value) {
    return row(name, kind, "", [value](const Lever& one) { return value(*one.on); }, {.forms = in_csv});
  };
  const auto slope = [&](const char* name, auto of) {
    return row(name, Kind::number, "", [of](const Lever& one) { return one.slope->*of; }, {.forms = in_json});
  };
  const auto change = [&](const char* name, auto of) {
    return row(name, Kind::number, "", [of](const Lever& one) { return one.change(of); }, {.forms = in_csv});
  };
  const auto percents = [&](const char* heading, auto of) {
    const auto words = [of](const Lever& one) {
      const std::optional<double> share = one.change(of);
      return share ? Json(fmt::format("{:+.3g} %", 100 * *share)) : Json();
    };
    return row(heading, Kind::words, heading, words, {.forms = for_people});
  };
  return {.key = "sensitivities",
          .rows = row.size(),
          .columns = {peak("name", Kind::words, [](const ExplainedPeak& p) { return p.name; }),
                      peak("unit", Kind::words, [](const ExplainedPeak& p) { return p.unit; }),
                      peak("angular_frequency [rad/s]", Kind::frequency,
                           [](const ExplainedPeak& p) { return p.peak.angular_frequency; }),
                      peak("amplitude", Kind::amplitude, [](const ExplainedPeak& p) { return p.peak.amplitude; }),
                      row("parameter", Kind::words, "parameter, strongest first",
                          [](const Lever& one) { return one.parameter->name; }),
                      slope("height", &Sensitivity::height), slope("frequency", &Sensitivity::frequency),
                      row("change", Kind::words, "change", [](const Lever& one) { return one.parameter->change; }),
                      row("change_size", Kind::number, "", [](const Lever& one) { return one.parameter->size; },
                          {.forms = in_json}),
                      change("relative height change", &Sensitivity::height),
                      change("relative frequency change", &Sensitivity::frequency),
                      percents("height", &Sensitivity::height), percents("frequency", &Sensitivity::frequency)},
          .most_rows = 12};
}

Group share_group(const project::Case& variant, const Explanation& explanation, const PeakShares& shares) {
  Group group{.key = "shares", .parts = {{mode_shares(explanation, shares)}}};
  const auto add = [&](const char* name, double share) { group.parts.push_back({Single{name, json::number(share)}}); };
  constexpr double shown_above_all = 1.0005;
  const auto moves_against = [](const auto& mode) { return mode.share < 0; };
  const auto is_outside = [](const auto& mode) { return mode.share <= -worth_a_row || mode.share > shown_above_all; };
  if (std::ranges::any_of(shares.modes, is_outside) && std::ranges::any_of(shares.modes, moves_against))
    group.parts.push_back({Sentence{.parts = {"a mode below 0 %, also one too small for a row, moves against the "
                                              "others at the peak, which therefore add up to more than 100 %"},
                                    .place = Sentence::Place::note}});
  if (std::abs(shares.beyond_modes) >= worth_a_row)
    group.parts.push_back(
        {Sentence{.parts = {"beyond the undamped modes: ", Quantity{shares.beyond_modes, "1", Kind::share}},
                  .place = Sentence::Place::note}});
  add("beyond_modes", shares.beyond_modes);
  add("strain_energy", shares.strain_energy);
  group.parts.push_back({element_shares(variant, shares)});
  group.parts.push_back({energy_table(variant, response::of_positive_parts(shares))});
  add("geometric_stiffness", shares.geometric);
  add("foundations", shares.in_foundations);
  add("dissipated_power", shares.dissipated_power);
  add("system_damping", shares.system_damping);
  add("foundation_damping", shares.by_foundations);
  return group;
}

/// Without tables: for people alone.
Group sentences_group(const ExplainedPeak& peak) {
  Group group{.key = "", .parts = {}, .in_list = true};
  Sentence sentence = shown_words(peak.sentence);
  sentence.place = Sentence::Place::text;
  group.parts.push_back({std::move(sentence)});
  for (const std::string& note : peak.notes)
    group.parts.push_back({Sentence{.parts = {"note: " + note}, .place = Sentence::Place::note}});
  return group;
}

Group peak_group(const project::Case& variant, const Explanation& explanation, const ExplainedPeak& peak) {
  std::vector<Lever> levers;
  add_levers(explanation, peak, levers);
  const response::Peak& place = peak.peak;
  Sentence sentence = shown_words(peak.sentence);
  sentence.place = Sentence::Place::text;
  Group group{.key = "peaks",
              .parts = {{Single{"name", peak.name}},
                        {Single{"unit", peak.unit}},
                        {Single{"angular_frequency", place.angular_frequency}},
                        {Single{"frequency_hz", place.angular_frequency / foundation::two_pi}},
                        {Single{"amplitude", json::number(place.amplitude)}},
                        {Single{"unbounded", std::isinf(place.amplitude)}},
                        {Single{"nearest_mode", json::optional(place.nearest_mode)}},
                        {Single{"sentence", study::words_in_si(peak.sentence)}},
                        {std::move(sentence)},
                        {share_group(variant, explanation, peak.shares)},
                        {lever_table(std::move(levers))},
                        {Single{"trial", trial_json(peak.trial)}},
                        {Words{.key = "notes", .list = peak.notes}}},
              .in_list = true};
  for (const std::string& note : peak.notes)
    group.parts.push_back({Sentence{.parts = {"note: " + note}, .place = Sentence::Place::note}});
  return group;
}

}  // namespace

Document explanation_document(const project::Case& variant, const Explanation& explanation, std::size_t with_tables) {
  Document document;
  for (const foundation::Problem& problem : explanation.warnings.list())
    document.add(Sentence{.parts = {foundation::message(problem)}, .forms = on_page});
  for (const std::string& note : explanation.notes) document.add(Sentence{.parts = {"note: " + note}});
  document.add(Single{"peaks", Json::array()});
  for (std::size_t i = 0; i < explanation.peaks.size(); ++i)
    document.add(i < with_tables ? peak_group(variant, explanation, explanation.peaks[i])
                                 : sentences_group(explanation.peaks[i]));
  if (with_tables < explanation.peaks.size())
    document.add(Sentence{
        .parts = {fmt::format("… the tables of {} more peaks: --full", explanation.peaks.size() - with_tables)},
        .forms = on_screen});
  document.add(Single{"left_out", explanation.left_out});
  document.add(Single{"warnings", json::warnings(explanation.warnings)});
  if (!explanation.notes.empty()) document.add(Words{.key = "notes", .list = explanation.notes});
  std::vector<Lever> levers;
  for (const ExplainedPeak& peak : explanation.peaks) add_levers(explanation, peak, levers);
  Table& all = document.add(lever_table(std::move(levers)));
  all.file = "explain.csv";
  all.forms = in_csv;
  document.add(
      Sentence{{explanation.peaks.empty()
                    ? "No resonance peaks: nothing to explain"
                    : "Energy by direction: deformation at the elastic centre of each element, in its local axes. "
                      "Changes are to first order, from exact slopes; a moved element keeps its stiffness."},
               Sentence::Place::text});
  if (explanation.left_out > 0)
    document.add(Sentence{{fmt::format("{} further {} not explained; --of NAME selects one result, --most N shows more",
                                       explanation.left_out, explanation.left_out == 1 ? "peak" : "peaks")}});
  return document;
}

}  // namespace trivet::results
