// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "trivet/foundation/index.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/identification/stiffness_fit.h"
#include "trivet/project/elements/element_law.h"
#include "trivet/project/elements/element_table_readers.h"
#include "trivet/project/text/column_units.h"
#include "trivet/project/text/csv_table.h"
#include "trivet/project/text/source_file.h"

namespace trivet::project {
namespace {

using identification::LoadCase;
using identification::StiffnessFit;

constexpr std::array<const char*, 6> motions = {"x", "y", "z", "rx", "ry", "rz"},
                                     loads = {"fx", "fy", "fz", "mx", "my", "mz"};

/// Units of the columns: length [m], angle [rad], force [N]; moments in force × length.
struct RigUnits {
  double length = 1, angle = 1, force = 1;
};

/// What the columns x … rz and fx … mz measure, also with the prefix "n_".
std::optional<ColumnQuantity> rig_quantity(std::string_view name, const RigUnits& units) {
  if (name.starts_with("n_")) name.remove_prefix(2);
  for (std::size_t j = 0; j < 6; ++j) {
    const bool turns = j >= 3;
    if (name == motions[j])
      return turns ? ColumnQuantity(Quantity::angle, units.angle, "")
                   : ColumnQuantity(Quantity::length, units.length, "");
    if (name == loads[j])
      return turns ? ColumnQuantity(Quantity::moment, units.force * units.length, "")
                   : ColumnQuantity(Quantity::force, units.force, "");
  }
  return std::nullopt;
}

void add_problems(TableReader& reader, const foundation::Problems& problems, const char* key) {
  for (foundation::Problem problem : problems.list()) {
    if (problem.origin.line == 0) problem.origin = reader.node(key)->origin;
    problem.subject = reader.path() + "." + key +
        (problem.subject.empty() || problem.subject == key ? "" : " (" + problem.subject + ")");
    reader.problems().add(std::move(problem));
  }
}

/// Load cases from the columns x … rz and fx … mz of the moved end K, and with the prefix "n_" of end N. Without them,
/// N is fixed and its loads are not measured.
std::optional<std::vector<LoadCase>> load_cases(TableReader& reader, const CsvTable& table, const RigUnits& units) {
  const auto column = [&](const std::string& name) -> Eigen::Index {
    const auto found = std::ranges::find(table.columns, name);
    return found == table.columns.end() ? -1 : found - table.columns.begin();
  };
  const auto needed = columns(table, {motions.begin(), motions.end()});
  if (!needed) {
    add_problems(reader, needed.error(), "load_cases");
    return std::nullopt;
  }
  std::vector<std::string> known;
  double largest_turn = 0, largest_shift = 0;
  std::vector<LoadCase> cases;
  for (Eigen::Index row = 0; row < table.values.rows(); ++row) {
    LoadCase one;
    one.name = table.names.empty() ? fmt::format("row {}", row + 1) : table.names[row];
    for (int j = 0; j < 12; ++j) {
      const std::string end = j < 6 ? "n_" : "";
      const auto k = to_size(j % 6);
      const Eigen::Index motion = column(end + motions[k]), load = column(end + loads[k]);
      one.displacement(j) = motion < 0 ? 0 : table.values(row, motion) * (k < 3 ? units.length : units.angle);
      if (load >= 0) one.wrench(j) = table.values(row, load) * units.force * (k < 3 ? 1 : units.length);
      if (row == 0) known.insert(known.end(), {end + motions[k], end + loads[k]});
    }
    const double turn = std::max(one.displacement.segment<3>(3).cwiseAbs().maxCoeff(),
                                 one.displacement.tail<3>().cwiseAbs().maxCoeff());
    const double shift = std::max(one.displacement.head<3>().cwiseAbs().maxCoeff(),
                                  one.displacement.segment<3>(6).cwiseAbs().maxCoeff());
    largest_turn = std::isfinite(turn) ? std::max(largest_turn, turn) : largest_turn;
    largest_shift = std::isfinite(shift) ? std::max(largest_shift, shift) : largest_shift;
    cases.push_back(std::move(one));
  }
  for (const std::string& name : table.columns)
    if (std::ranges::find(known, name) == known.end())
      reader.error("load_cases", "column " + foundation::quoted(name),
                   "columns are name, x … rz, fx … mz of end K, and the same with n_ of end N", "rename or remove it");
  constexpr double largest_sane_turn = 0.2, largest_sane_shift = 0.1;
  foundation::Problems doubts;
  if (largest_turn > largest_sane_turn)
    doubts.warning("load_cases", fmt::format("rotations up to {:.4g} rad", largest_turn),
                   "a linear stiffness is measured at small rotations",
                   "give angle_unit = \"1 deg\" if the columns are in degrees");
  if (largest_shift > largest_sane_shift)
    doubts.warning("load_cases", fmt::format("displacements up to {:.4g} m", largest_shift),
                   "a mount moves by millimetres on a rig",
                   "give length_unit = \"1 mm\" if the columns are in millimetres");
  reader.add(doubts);
  return cases;
}

void add_facts(const StiffnessFit& fit, std::size_t cases, double confidence, model::Element& element) {
  element.facts.push_back({"found from",
                           fmt::format("{} load cases, {} readings, {:.4g} degrees of freedom", cases,
                                       fit.readings.size(), fit.degrees_of_freedom)});
  std::string noise;
  for (int j = 0; j < 12; ++j)
    if (std::isfinite(fit.noise(j)))
      noise += fmt::format("{}{} {:.3g} {}", noise.empty() ? "" : ", ", identification::channel_words(j), fit.noise(j),
                           j % 6 < 3 ? "N" : "N m");
  element.facts.push_back({"noise (standard deviation)", noise});
  element.facts.push_back({"outliers", fit.outliers.empty() ? "none" : fmt::format("{}", fit.outliers.size())});
  if (fit.semidefinite)
    element.facts.push_back({"nearest semidefinite matrix",
                             fmt::format("taken as requested, {:.3g} % away", 100 * fit.semidefinite->distance)});
  element.evidence = model::Evidence{fit.half_width, fmt::format("{:.4g} % confidence", 100 * confidence), {}};
}

void read_measured(TableReader& reader, Placement& ends, model::Element& element) {
  const auto file = read_file_name(reader, "load_cases");
  identification::StiffnessFitOptions options;
  if (reader.choice("unknowns", {"self_balanced", "full_symmetric"}) == "full_symmetric")
    options.unknowns = identification::Unknowns::full_symmetric;
  options.confidence = reader.number("confidence", Quantity::pure).value_or(options.confidence);
  options.zero_offsets = reader.boolean("zero_offsets").value_or(false);
  options.nearest_semidefinite = reader.boolean("nearest_semidefinite").value_or(false);
  RigUnits units;
  units.length = reader.number("length_unit", Quantity::length).value_or(1);
  units.angle = reader.number("angle_unit", Quantity::angle).value_or(1);
  units.force = reader.number("force_unit", Quantity::force).value_or(1);
  for (const auto& [key, unit] : {std::pair{"length_unit", units.length}, std::pair{"angle_unit", units.angle},
                                  std::pair{"force_unit", units.force}})
    if (!(unit > 0))
      reader.error(key, fmt::format("{:.6g}", unit), "a unit is > 0", "write \"1 mm\", \"1 deg\", \"1 kN\"");
  if (!(options.confidence > 0 && options.confidence < 1)) {
    reader.error("confidence", fmt::format("{:.6g}", options.confidence), "it lies between 0 and 1", "0.95 is usual");
    return;
  }
  if (!file) return;
  auto table = read_csv_table(*file);
  if (!table) {
    reader.add_of_file("load_cases", table.error());
    return;
  }
  reader.add_of_file("load_cases", table->warnings);
  foundation::Problems wrong_units;
  convert_columns(*table, [&](const std::string& name) { return rig_quantity(name, units); }, wrong_units);
  if (wrong_units.has_errors()) {
    reader.add_of_file("load_cases", wrong_units);
    return;
  }
  const auto cases = load_cases(reader, *table, units);
  if (!cases) return;
  const auto fit = identification::identified_stiffness(*cases, ends.span.arm, options);
  if (!fit) {
    add_problems(reader, fit.error(), "load_cases");
    return;
  }
  add_problems(reader, fit->warnings, "load_cases");
  element.law.nominal_stiffness = elements::in_end_axes(
      options.nearest_semidefinite && fit->semidefinite ? fit->semidefinite->stiffness : fit->stiffness,
      ends.span.n_from_k);
  add_facts(*fit, cases->size(), options.confidence, element);
  for (const identification::Reading& reading : fit->readings) {
    const bool outlier = std::ranges::any_of(fit->outliers, [&](const identification::Outlier& o) {
      return o.load_case == reading.load_case && o.channel == reading.channel;
    });
    element.evidence->residuals.push_back(
        {(*cases)[reading.load_case].name + ", " + identification::channel_words(reading.channel), reading.measured,
         reading.fitted, reading.standardised, outlier});
  }
}

}  // namespace

const ElementLaw measured_law = {.type = "measured",
                                 .placed = read_measured,
                                 .keys = R"json({"properties": {
   "load_cases": {"type": "string",
     "description": "CSV relative to the project file: name, x y z rx ry rz, fx fy fz mx my mz of end K; the )json"
                                         R"json(same with n_ of end N"},
   "unknowns": {"enum": ["self_balanced", "full_symmetric"],
     "description": "21 or 78 constants (default: self_balanced)"},
   "confidence": {"$ref": "#/$defs/number", "description": "of the intervals, above 0, below 1 (default: 0.95)"},
   "zero_offsets": {"type": "boolean", "description": "also fit the zero of each channel (default: false)"},
   "nearest_semidefinite": {"type": "boolean",
     "description": "take the nearest positive semidefinite matrix (default: false)"},
   "length_unit": {"$ref": "#/$defs/number", "description": "length of 1 in the file, m (default: 1)"},
   "force_unit": {"$ref": "#/$defs/number", "description": "force of 1 in the file, N (default: 1)"},
   "angle_unit": {"$ref": "#/$defs/number", "description": "angle of 1 in the file, rad (default: 1)"}},
  "required": ["load_cases"]})json"};

}  // namespace trivet::project
