// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "trivet/excitation/engine_orders.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/project/excitations/excitation_reader.h"
#include "trivet/project/text/pairs_reader.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::project {
namespace {

constexpr double perpendicular_within = 1e-6;
constexpr std::size_t most_orders = 200;  // an engine has some tens; each is a response over the whole run-up

/// Balance quality grade G; as a text such as "G 6.3" or "6.3 mm/s", as standards and drawings write it, an error that
/// says how to write it here.
double read_grade(TableReader& reader) {
  const Node* node = reader.has("grade") ? reader.node("grade") : nullptr;
  if (!node || node->kind != Node::Kind::text || to_si(node->text, Quantity::pure))
    return reader.required_number("grade", Quantity::pure);
  reader.error("grade", foundation::quoted(node->text), "a balance quality grade is its number alone, in mm/s",
               "write grade = 6.3 for G 6.3");
  return 0;
}

/// Columns: crank axis x, y and up z of the engine in body axes.
std::optional<Eigen::Matrix3d> read_engine_axes(TableReader& engine) {
  const Eigen::Vector3d crank = engine.direction("crank").value_or(Eigen::Vector3d::UnitX());
  const Eigen::Vector3d up = engine.direction("up").value_or(Eigen::Vector3d::UnitZ());
  if (std::abs(crank.dot(up)) > perpendicular_within) {
    engine.error("up",
                 fmt::format("{:.3g}° from the crank axis",
                             std::acos(std::min(1.0, std::abs(crank.dot(up)))) * 180 / std::numbers::pi),
                 "up is perpendicular to the crank axis", "for instance crank = \"x\", up = \"z\"");
    return std::nullopt;
  }
  Eigen::Matrix3d axes;
  axes << crank, spatial::cross_matrix(up) * crank, up;
  return axes;
}

excitation::EngineLayout::Kind read_kind(TableReader& engine) {
  using Kind = excitation::EngineLayout::Kind;
  if (!engine.has("layout")) engine.missing("layout", "layout = \"inline\", \"vee\" or \"boxer\"");
  const auto word = engine.choice("layout", {"inline", "vee", "boxer"});
  return word == "vee" ? Kind::vee : word == "boxer" ? Kind::boxer : Kind::in_line;
}

int whole_number(TableReader& reader, const std::string& key, double value, int from, int to) {
  if (value >= from && value <= to && value == std::floor(value)) return static_cast<int>(value);
  reader.error(key, fmt::format("{:.6g}", value), fmt::format("a whole number from {} to {} is expected", from, to),
               "change it");
  return from;
}

excitation::EngineLayout read_layout(TableReader& engine) {
  excitation::EngineLayout layout;
  layout.kind = read_kind(engine);
  layout.cylinders = whole_number(engine, "cylinders", engine.required_number("cylinders", Quantity::pure), 1, 24);
  layout.spacing = engine.number("spacing", Quantity::length).value_or(0);
  layout.bank_angle = engine.number("bank_angle", Quantity::angle).value_or(0);
  layout.bank_offset = engine.number("bank_offset", Quantity::length).value_or(0);
  if (layout.kind == excitation::EngineLayout::Kind::vee && !engine.has("bank_angle"))
    engine.missing("bank_angle", "give the angle between the banks: bank_angle = \"60 deg\"");
  if (layout.kind != excitation::EngineLayout::Kind::vee && engine.has("bank_angle"))
    engine.error("bank_angle", "of an engine that is not a vee",
                 "an inline engine has one bank, a boxer 180° between them", "remove it");
  if (layout.kind == excitation::EngineLayout::Kind::in_line && engine.has("bank_offset"))
    engine.error("bank_offset", "of an inline engine", "it has one bank", "remove it");
  layout.strokes = whole_number(engine, "strokes", engine.number("strokes", Quantity::pure).value_or(4), 2, 4);
  if (layout.cylinders > 1 && !engine.has("spacing"))
    engine.missing("spacing", "give the distance of neighbouring cylinders along the crank axis");
  if (const auto order = engine.numbers("firing_order", Quantity::pure))
    for (const double number : *order)
      layout.firing_order.push_back(whole_number(engine, "firing_order", number, 1, layout.cylinders));
  return layout;
}

/// A cylinder reaches at least some ten times the pressure of the atmosphere; less than a fifth of it is a trace in bar
/// or MPa that is read as Pa, and more than a thousand bar one in Pa that is read as bar.
void warn_of_unlikely_pressures(TableReader& pressure, const std::vector<double>& trace) {
  constexpr double smallest = 2e4, highest = 1e8;
  const double largest = trace.empty() ? 0 : std::ranges::max(trace);
  if (!(largest > 0) || (largest >= smallest && largest <= highest)) return;
  foundation::Problems doubts;
  doubts.warning(
      largest > highest && pressure.has("unit") ? "unit" : "file",
      fmt::format("a largest pressure of {:.4g} Pa", largest), "a cylinder reaches 10 to 200 bar, 1e6 to 2e7 Pa",
      largest < smallest
          ? "write unit = \"bar\" if the column is in bar, or the unit in its heading: pressure [bar]"
          : "correct the unit: the column seems to be in Pa, the unit without `unit` and without one in the heading");
  pressure.add(doubts);
}

/// The same trace with its last point at the end of the cycle, if the rounding of two decimals in radians (and less
/// than half a step) is between them: 0 … 12.5664 rad is two turns.
excitation::PressureTrace closed_cycle(excitation::PressureTrace trace, double cycle) {
  constexpr double rounding = 0.005;  // [rad]
  const std::size_t count = trace.angles.size();
  if (count < 3) return trace;
  const double end = trace.angles.front() + cycle, last_step = trace.angles[count - 1] - trace.angles[count - 2];
  if (std::abs(trace.angles.back() - end) <= std::min(rounding, 0.5 * last_step)) trace.angles.back() = end;
  return trace;
}

/// `gas_torque = [[order, amplitude, phase], …]` per cylinder, or `pressure = {file, …}` with the bore.
std::vector<excitation::TorqueHarmonic> read_gas(TableReader& engine, const excitation::Engine& data, double highest) {
  if (engine.has("gas_torque")) {
    std::vector<excitation::TorqueHarmonic> harmonics;
    const Node* rows = engine.node("gas_torque");
    if (rows->kind != Node::Kind::array || rows->items.empty()) {
      engine.error("gas_torque", rows->kind == Node::Kind::array ? "an empty list" : kind_name(rows->kind),
                   "rows of [order, amplitude in N m, phase in rad] of one cylinder are expected",
                   "give them, or remove the key");
      return {};
    }
    if (engine.has("pressure"))
      engine.error("pressure", "together with gas_torque", "only one of them sets the gas torque", "remove one");
    for (std::size_t i = 0; i < rows->items.size(); ++i) {
      const Node& row = rows->items[i];
      const std::string where = fmt::format("{}.gas_torque[{}]", engine.path(), i);
      if (row.kind != Node::Kind::array || row.items.size() != 3) {
        engine.error("gas_torque", fmt::format("row {} is not a list of three", i + 1),
                     "each row is [order, amplitude in N m, phase in rad] of one cylinder", "complete it");
        return {};
      }
      const auto order = engine.scalar(row.items[0], where + "[0]", Quantity::pure),
                 amplitude = engine.scalar(row.items[1], where + "[1]", Quantity::moment, Levels::of_harmonic),
                 phase = engine.scalar(row.items[2], where + "[2]", Quantity::angle);
      if (order && amplitude && phase)
        harmonics.push_back({*order, *amplitude * std::exp(std::complex<double>(0, *phase))});
    }
    return harmonics;
  }
  const Node* node = engine.table("pressure");
  if (!node) return {};
  TableReader pressure(*node, engine.path() + ".pressure", engine.problems());
  const double bore = pressure.required_number("bore", Quantity::length);
  if (pressure.has("bore") && !(bore > 0))
    pressure.error("bore", fmt::format("{:.6g} m", bore), "a bore is > 0", "correct it");
  const ColumnQuantity angle(Quantity::angle, std::numbers::pi / 180, "deg"),
      value = read_bare_unit(pressure, Quantity::pressure);
  const auto rows = read_pairs_of_file(pressure, "crank_angle_deg", "pressure", angle, value);
  pressure.finish();
  if (!rows || !(bore > 0)) return {};
  excitation::PressureTrace trace;
  for (const double degrees : rows->col(0)) trace.angles.push_back(degrees * angle.bare);
  for (const double one : rows->col(1)) trace.pressures.push_back(one * value.bare);
  warn_of_unlikely_pressures(pressure, trace.pressures);
  trace = closed_cycle(std::move(trace), data.cycle());
  const foundation::Problems findings = excitation::check(trace, data.cycle(), "file");
  pressure.add(findings);
  return findings.has_errors() || pressure.errors() > 0 ? std::vector<excitation::TorqueHarmonic>{}
                                                        : excitation::gas_harmonics(trace, data, bore, highest);
}

std::optional<std::vector<excitation::Order>> read_engine(const Node& node, const std::string& path,
                                                          foundation::Problems& problems) {
  TableReader engine(node, path, problems);
  const std::size_t before = engine.errors();
  const excitation::EngineLayout layout = read_layout(engine);
  excitation::Engine data;
  data.strokes = layout.strokes;
  data.crank_radius = engine.required_number("crank_radius", Quantity::length);
  const auto rod = engine.number("rod_length", Quantity::length);
  if (!rod) engine.missing("rod_length", "give the length of the connecting rod between its eyes");
  data.rod_ratio = rod && *rod > 0 ? data.crank_radius / *rod : 0;
  data.oscillating_mass = engine.required_number("oscillating_mass", Quantity::mass);
  data.rotating_mass = engine.number("rotating_mass", Quantity::mass).value_or(0);
  data.counterweight = engine.number("counterweight", Quantity::mass_length).value_or(0);
  const double highest =
      whole_number(engine, "highest_order", engine.number("highest_order", Quantity::pure).value_or(6), 1, 100);
  const auto axes = read_engine_axes(engine);
  std::vector<excitation::Order> orders;
  if (engine.errors() == before) {
    try {
      data.cylinders = excitation::evenly_firing_cylinders(layout);
      const foundation::Problems findings = excitation::check(data, "");
      engine.add(findings,
                 {{".rod_ratio", "rod_length"},
                  {".crank_radius", "crank_radius"},
                  {".oscillating_mass", "oscillating_mass"},
                  {".rotating_mass", "rotating_mass"},
                  {".counterweight", "counterweight"}});
      if (engine.errors() == before) {
        orders = excitation::inertia_orders(data, static_cast<int>(highest));
        const auto gas = read_gas(engine, data, highest);
        if (!gas.empty() && engine.errors() == before)
          orders = excitation::joined(orders, excitation::gas_orders(data, gas));
      }
    } catch (const foundation::InvalidInput& wrong) {
      engine.error("", wrong.what(), "the engine must be physically possible", "correct the number");
    }
  }
  for (const char* key : {"gas_torque", "pressure"}) static_cast<void>(engine.node(key));
  engine.finish();
  if (engine.errors() > before || !axes) return std::nullopt;
  const spatial::Matrix6 turn = spatial::both_blocks(*axes);
  for (excitation::Order& order : orders) {
    order.per_speed_squared = (turn.cast<std::complex<double>>() * order.per_speed_squared).eval();
    order.fixed = (turn.cast<std::complex<double>>() * order.fixed).eval();
  }
  return orders;
}

excitation::Order read_order(TableReader& row) {
  excitation::Order order;
  order.order = row.required_number("order", Quantity::pure);
  if (row.has("order") && !(order.order > 0))
    row.error("order", fmt::format("{:.6g}", order.order), "an order is > 0",
              "a mean force is an excitation of type \"constant\"");
  const std::complex<double> turn = std::exp(std::complex<double>(0, row.number("phase", Quantity::angle).value_or(0)));
  const auto three = [&](const char* key, Quantity quantity) -> Eigen::Vector3cd {
    return turn * row.vector(key, quantity, Levels::of_harmonic).value_or(Eigen::Vector3d::Zero());
  };
  order.per_speed_squared << three("force_per_speed2", Quantity::mass_length),
      three("moment_per_speed2", Quantity::inertia);
  order.fixed << three("force", Quantity::force), three("moment", Quantity::moment);
  if (!row.has("force_per_speed2") && !row.has("moment_per_speed2") && !row.has("force") && !row.has("moment"))
    row.error("force_per_speed2", "no force and no moment",
              "an order has at least one of force_per_speed2, moment_per_speed2, force, moment", "give one");
  row.finish();
  return order;
}

}  // namespace

std::optional<model::Orders> read_orders(TableReader& reader) {
  const Node* table = reader.node("table");
  const Node* engine = reader.table("engine");
  if (!table && !engine) {
    if (!reader.has("engine"))
      reader.missing("engine", "give engine = {layout = …} or table = [{order = 2, force_per_speed2 = [0, 0, 0.02]}]");
    return std::nullopt;
  }
  const std::size_t before = reader.errors();
  model::Orders orders;
  if (engine)
    if (auto list = read_engine(*engine, reader.path() + ".engine", reader.problems())) orders.list = std::move(*list);
  if (table && table->kind != Node::Kind::array) {
    reader.error("table", kind_name(table->kind), "a list of orders is expected",
                 "table = [{order = 2, force_per_speed2 = [0, 0, 0.02]}]");
  } else if (table && table->items.size() > most_orders) {
    reader.error("table", fmt::format("{} orders", table->items.size()),
                 fmt::format("at most {} orders are computed", most_orders), "keep the strong ones");
  } else if (table) {
    std::vector<excitation::Order> rows;
    for (std::size_t i = 0; i < table->items.size(); ++i) {
      if (table->items[i].kind != Node::Kind::table) {
        reader.error("table", fmt::format("row {} is {}", i + 1, kind_name(table->items[i].kind)),
                     "each order is a table", "{order = 2, force_per_speed2 = [0, 0, 0.02]}");
        continue;
      }
      TableReader row(table->items[i], fmt::format("{}.table[{}]", reader.path(), i), reader.problems());
      rows.push_back(read_order(row));
    }
    orders.list = excitation::joined(orders.list, rows);
  }
  return reader.errors() > before ? std::nullopt : std::optional(orders);
}

double read_unbalance(TableReader& reader, model::Action& action) {
  const auto axis = reader.direction("axis");
  if (!reader.has("axis")) reader.missing("axis", "give the axis of the rotor: axis = \"x\"");
  const bool backward = reader.choice("direction", {"forward", "backward"}) == "backward";
  const double phase = reader.number("phase", Quantity::angle).value_or(0);
  double mass_eccentricity = 0, service_speed = 0;
  const bool part_of_grade = reader.has("rotor_mass") || reader.has("service_speed");
  if (reader.has("grade") || (part_of_grade && !reader.has("mass_eccentricity"))) {
    const std::size_t before = reader.errors();
    const double grade = read_grade(reader), mass = reader.required_number("rotor_mass", Quantity::mass),
                 speed = reader.required_number("service_speed", Quantity::angular_frequency);
    if (reader.has("mass_eccentricity"))
      reader.error("mass_eccentricity", "together with a grade", "only one of them sets the unbalance", "remove one");
    for (const auto& [key, value] : {std::pair{"grade", grade}, {"rotor_mass", mass}, {"service_speed", speed}})
      if (reader.errors() == before && reader.has(key) && !(value > 0))
        reader.error(key, value_text(*reader.node(key), 0), "it must be > 0", "give a positive number");
    if (grade > 0 && mass > 0 && speed > 0) mass_eccentricity = excitation::permissible_unbalance(grade, mass, speed);
    service_speed = std::max(speed, 0.0);
  } else {
    const bool called_unbalance = !reader.has("mass_eccentricity") && reader.has("unbalance");
    if (called_unbalance) {
      static_cast<void>(reader.node("unbalance"));
      reader.error("unbalance", "unknown key", "the unbalance is given as mass × eccentricity, or by its grade",
                   "did you mean \"mass_eccentricity\"?");
    }
    if (!called_unbalance && !reader.has("mass_eccentricity"))
      reader.missing("mass_eccentricity", "give mass × eccentricity in kg m, or grade, rotor_mass and service_speed");
    mass_eccentricity = reader.number("mass_eccentricity", Quantity::mass_length).value_or(0);
    if (mass_eccentricity < 0)
      reader.error("mass_eccentricity", fmt::format("{:.6g} kg m", mass_eccentricity), "it is ≥ 0",
                   "shift the phase by half a turn instead");
    if (const auto speed = reader.number("service_speed", Quantity::angular_frequency)) {
      if (!(*speed > 0))
        reader.error("service_speed", value_text(*reader.node("service_speed"), 0), "it must be > 0",
                     "give a positive number");
      service_speed = std::max(*speed, 0.0);
    }
  }
  static_cast<void>(reader.node("mass_eccentricity"));
  if (!axis) return 0;
  // Forward: from e1 to e2, counter-clockwise seen against the axis; Re((e1 − i e2) e^{iωt}) = e1 cos ωt + e2 sin ωt.
  const Eigen::Matrix3d axes = spatial::axes_along(*axis);
  const std::complex<double> turn = mass_eccentricity * std::exp(std::complex<double>(0, phase));
  action.amplitude.head<3>() = turn *
      (axes.col(0).cast<std::complex<double>>() +
       std::complex<double>(0, backward ? 1 : -1) * axes.col(1).cast<std::complex<double>>());
  return service_speed;
}

}  // namespace trivet::project
