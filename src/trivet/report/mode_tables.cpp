// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/foundation/index.h"
#include "trivet/modal/stored_energy.h"
#include "trivet/report/html_table.h"
#include "trivet/report/result_tables.h"

namespace trivet::report {
namespace {

constexpr std::array<const char*, 6> coordinates = {"x", "y", "z", "θx", "θy", "θz"};

void add_mode_frequency(std::vector<Cell>& row, const modal::Mode& m, const project::ShownUnits& display) {
  const int columns = static_cast<int>(results::frequency_units(display).size());
  if (!m.angular_frequency)
    row.push_back({"▲ unstable, ω² = " + aligned_number(m.eigenvalue_squared) + " rad²/s²", false, Tone::bad, columns});
  else if (*m.angular_frequency == 0) row.push_back({"rigid body (ω = 0)", false, Tone::plain, columns});
  else add_frequency(row, *m.angular_frequency, display);
}

/// "front left (38.2 %), 3 more with the same share"
std::string most_strained(const project::Case& variant, const modal::Mode& m) {
  const auto most = modal::most_strained(m);
  if (!most) return "–";
  return fmt::format("{} ({}{}){}", variant.system.elements()[most->element].name, percent_words(most->share),
                     modal::given_back_words(most->given_back),
                     most->alike > 0 ? fmt::format(", {} more with the same share", most->alike) : "");
}

/// Shares of the kinetic energy of a body: "93.1 % / 6.9 %".
std::string kinetic_words(const modal::Mode& m, std::size_t body) {
  const auto sum = [&](Eigen::Index from) {
    return percent_words(m.principal_kinetic_energy_share.segment(6 * to_index(body) + from, 3).sum());
  };
  return sum(0) + " / " + sum(3);
}

/// One row per mode, one column per coordinate of each body.
std::string coordinates_table(const project::Case& variant, const study::Answers& answers,
                              Eigen::VectorXd modal::Mode::* values) {
  constexpr double round_off = 1e-12;
  const auto& bodies = variant.system.bodies();
  std::vector<Cell> headings = {right("mode")};
  for (const auto& body : bodies)
    for (const char* coordinate : coordinates)
      headings.push_back(right(bodies.size() > 1 ? body.name + " " + coordinate : coordinate));
  std::vector<Row> rows;
  for (const modal::Mode& m : answers.modes.list) {
    rows.push_back({{right(std::to_string(m.number))}, ""});
    for (const double value : m.*values) {
      rows.back().cells.push_back(aligned_cell(value, 4));
      if (value != 0 && std::abs(value) < round_off) rows.back().cells.back().tone = Tone::quiet;
    }
  }
  return html_table(headings, rows);
}

}  // namespace

std::string modes_tables(const project::Case& variant, const study::Answers& answers) {
  if (!variant.analyses.modes) return "";
  std::vector<std::size_t> massive;
  for (std::size_t b = 0; b < variant.system.bodies().size(); ++b)
    if (!variant.system.bodies()[b].is_node) massive.push_back(b);
  const auto& bodies = variant.system.bodies();
  std::vector<Cell> headings = {right("mode")};
  add_frequency_headings(headings, answers.display);
  headings.push_back({"motion"});
  headings.push_back({"most strained element (share)"});
  for (const std::size_t b : massive)
    headings.push_back(right(
        fmt::format("kinetic energy{}: translation / rotation", massive.size() > 1 ? " of " + bodies[b].name : "")));
  std::vector<Row> rows;
  for (const modal::Mode& m : answers.modes.list) {
    Row row{{right(std::to_string(m.number))}, m.angular_frequency ? "" : "failed"};
    add_mode_frequency(row.cells, m, answers.display);
    row.cells.push_back({m.name + (m.repeated ? " (repeated root)" : "")});
    row.cells.push_back({most_strained(variant, m)});
    for (const std::size_t b : massive) row.cells.push_back(right(kinetic_words(m, b)));
    rows.push_back(std::move(row));
  }
  return html_table(headings, rows) +
      folded("Mode shapes at the poles: x, y, z [m], θx, θy, θz [rad], unit modal mass",
             coordinates_table(variant, answers, &modal::Mode::shape)) +
      folded("Shares of kinetic energy by coordinate at the poles (they sum to 1; single ones may be outside 0 … 1)",
             coordinates_table(variant, answers, &modal::Mode::kinetic_energy_share));
}

namespace {

/// Has a root its conjugate in the list?
bool paired(const modal::Root& root, const std::vector<modal::Root>& list) {
  constexpr double same = 1e-9;
  return root.eigenvalue.imag() != 0 && std::any_of(list.begin(), list.end(), [&](const modal::Root& other) {
           return std::abs(other.eigenvalue - std::conj(root.eigenvalue)) < same * std::abs(root.eigenvalue);
         });
}

Cell optional_cell(const std::optional<double>& value, int digits) {
  return value ? aligned_cell(*value, digits) : right("–");
}

}  // namespace

std::string roots_table(const project::Case& variant, const study::Answers& answers) {
  if (!variant.analyses.roots) return "";
  const auto in_unit = [&](double omega) { return results::shown_frequency(answers.display, omega, "rad/s"); };
  const auto optional_in_unit = [&](const std::optional<double>& omega) {
    return omega ? std::optional(in_unit(*omega)) : std::nullopt;
  };
  const std::string unit = " [" + results::frequency_unit(answers.display, "rad/s") + "]";
  std::vector<Row> rows;
  for (const modal::Root& r : answers.roots.list) {
    const bool pair = paired(r, answers.roots.list), grows = r.kind == modal::RootKind::growing;
    if (pair && r.eigenvalue.imag() < 0) continue;
    rows.push_back({{aligned_cell(r.eigenvalue.real(), 6),
                     right((pair ? "± " : "") + aligned_number(in_unit(r.eigenvalue.imag()), 6)),
                     {grows ? "▲ GROWING" : modal::name(r.kind), false, grows ? Tone::bad : Tone::plain},
                     optional_cell(optional_in_unit(r.angular_frequency), 6),
                     optional_cell(optional_in_unit(r.damped_angular_frequency), 6),
                     optional_cell(r.damping_ratio, 5),
                     right(r.nearest_mode ? std::to_string(*r.nearest_mode) : "–")},
                    grows ? "failed" : ""});
  }
  return html_table({right("Re λ [1/s]"),
                     right("Im λ" + unit),
                     {"kind"},
                     right("|λ|" + unit),
                     right((answers.display.frequency.empty() ? "damped ω" : "damped") + unit),
                     right("damping ratio"),
                     right("nearest mode")},
                    rows);
}

}  // namespace trivet::report
