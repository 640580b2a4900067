// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exchange/universal/universal_contents.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "trivet/exchange/universal/universal_descriptions.h"
#include "trivet/exchange/universal/universal_lines.h"
#include "trivet/exchange/universal/universal_units.h"

namespace trivet::exchange {
namespace {

constexpr std::array system_head_widths{10, 10, 10, 10, 10};
constexpr std::array point_widths{13, 13, 13, 13, 13, 13};
constexpr std::array matrix_row_widths{25, 25, 25};
constexpr int by_three_points = 1;
constexpr std::size_t point_numbers = 9;
/// Sine of the least angle between two directions, and error of axes that are printed with six digits.
constexpr double least_angle = 1e-4, printed_axes = 1e-4;
/// Systems may be given in other systems, but not in a circle.
constexpr int deepest_reference = 50;

std::optional<UniversalSystemType> system_type(int type) {
  if (type < 0 || type > 2) return std::nullopt;
  return static_cast<UniversalSystemType>(type);
}

/// Numbers of as many lines as they take.
std::optional<std::vector<double>> next_numbers(Lines& lines, std::size_t count, FieldWidths widths) {
  std::vector<double> numbers;
  while (numbers.size() < count && lines.next()) {
    auto line = numbers_between_blanks(lines.line());
    if (!line) line = numbers_in_columns(lines.line(), widths, BlankFields::end_the_line);
    if (!line || line->empty()) return std::nullopt;
    numbers.insert(numbers.end(), line->begin(), line->end());
  }
  if (numbers.size() != count) return std::nullopt;
  return numbers;
}

void report_wrong(const UniversalSet& set, const Lines& lines, const char* rule, SetProblems& problems) {
  problems.warning(set.line + lines.number(), "coordinate system", in_quotes(lines.line()), rule,
                   "the rest of the set is not read; nodes in its systems have no place by their position");
}

void warn_left_out(const UniversalSet& set, int label, const std::string& finding, const char* rule,
                   SetProblems& problems) {
  problems.warning(set.line, fmt::format("coordinate system {}", label), finding, rule,
                   "nodes in this system have no place by their position");
}

/// Axes by a point on +x and one in the +xz plane, relative to the origin.
std::optional<Eigen::Matrix3d> axes_by_points(const Eigen::Vector3d& on_x, const Eigen::Vector3d& in_xz) {
  const Eigen::Vector3d across = in_xz.cross(on_x);
  if (!(across.norm() > least_angle * in_xz.norm() * on_x.norm())) return std::nullopt;
  Eigen::Matrix3d axes;
  axes.col(0) = on_x.normalized();
  axes.col(1) = across.normalized();
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

/// A system in global coordinates; nullopt if its references are not known.
std::optional<UniversalSystem> in_global(const std::vector<UniversalSystem>& systems, int label) {
  UniversalSystem result;
  result.label = label;
  bool first = true;
  for (int depth = 0; label != 0; ++depth) {
    const auto found = std::ranges::find(systems, label, &UniversalSystem::label);
    if (found == systems.end() || depth > deepest_reference) return std::nullopt;
    if (first) result.type = found->type;
    else if (found->type != UniversalSystemType::cartesian) return std::nullopt;
    first = false;
    result.origin = found->origin + found->axes * result.origin;
    result.axes = found->axes * result.axes;
    label = found->reference;
  }
  return result;
}

/// System 0 is the global one; so is system 1 of nodes in part coordinates, unless the file defines it.
std::optional<UniversalSystem> system_of(const std::vector<UniversalSystem>& systems, int label, bool in_part) {
  auto system = in_global(systems, label);
  if (!system && in_part && label == 1) return UniversalSystem{};
  return system;
}

/// Axes of displacement at a place; nullopt for a spherical system, and on the axis of a cylindrical one.
std::optional<Eigen::Matrix3d> axes_at(const UniversalSystem& system, const Eigen::Vector3d& position) {
  if (system.type == UniversalSystemType::cartesian) return system.axes;
  if (system.type == UniversalSystemType::spherical) return std::nullopt;
  const Eigen::Vector3d local = system.axes.transpose() * (position - system.origin);
  const double radius = local.head<2>().norm();
  if (!(radius > least_angle * local.norm()) || radius == 0) return std::nullopt;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() << local.x() / radius, -local.y() / radius, local.y() / radius, local.x() / radius;
  return system.axes * turn;
}

}  // namespace

std::vector<UniversalSystem> read_universal_systems(const UniversalSet& set, const UniversalUnits& units,
                                                    SetProblems& problems) {
  std::vector<UniversalSystem> systems;
  const double length = unit_value(units, {.length = 1});
  for (Lines lines(set.body); lines.next();) {
    if (trimmed(lines.line()).empty()) continue;
    const auto head = whole_numbers_of_record(lines.line(), system_head_widths, 5);
    if (!head) {
      report_wrong(set, lines, "it begins with its number, type, reference, colour and way of definition", problems);
      return systems;
    }
    lines.next();  // its name
    const auto points = next_numbers(lines, point_numbers, point_widths);
    if (!points) {
      report_wrong(set, lines, "three points define it: origin, on +x, in the +xz plane", problems);
      return systems;
    }
    const Eigen::Map<const Eigen::Matrix3d> point(points->data());
    const auto type = system_type((*head)[1]);
    const auto axes = axes_by_points(point.col(1) - point.col(0), point.col(2) - point.col(0));
    if (!type || (*head)[4] != by_three_points || !axes) {
      warn_left_out(set, (*head)[0],
                    fmt::format("type {}, definition {}{}", (*head)[1], (*head)[4], axes ? "" : ", points in one line"),
                    "systems of the types 0 to 2 by three points (1) are read", problems);
      continue;
    }
    systems.push_back({(*head)[0], *type, (*head)[2], *axes, length * point.col(0)});
  }
  check_end(set, problems);
  return systems;
}

std::vector<UniversalSystem> read_universal_part_systems(const UniversalSet& set, const UniversalUnits& units,
                                                         SetProblems& problems) {
  std::vector<UniversalSystem> systems;
  const double length = unit_value(units, {.length = 1});
  Lines lines(set.body);
  for (int i = 0; i < 2; ++i) lines.next();  // number and name of the part
  while (lines.next()) {
    if (trimmed(lines.line()).empty()) continue;
    const auto head = whole_numbers_of_record(lines.line(), std::span(system_head_widths).first(4), 2);
    if (!head) {
      report_wrong(set, lines, "it begins with its number, type and colour", problems);
      return systems;
    }
    lines.next();  // its name
    const auto rows = next_numbers(lines, 12, matrix_row_widths);
    if (!rows) {
      report_wrong(set, lines, "four rows of three numbers define it", problems);
      return systems;
    }
    const Eigen::Map<const Eigen::Matrix<double, 3, 4>> columns(rows->data());
    const Eigen::Matrix3d axes = columns.leftCols<3>();
    const auto type = system_type((*head)[1]);
    const bool rotation =
        (axes.transpose() * axes - Eigen::Matrix3d::Identity()).norm() < printed_axes && axes.determinant() > 0;
    if (!type || !rotation) {
      warn_left_out(set, (*head)[0],
                    fmt::format("type {}{}", (*head)[1], rotation ? "" : ", axes that are no rotation"),
                    "systems of the types 0 to 2 with orthonormal axes are read", problems);
      continue;
    }
    systems.push_back({(*head)[0], *type, 0, axes, length * columns.col(3)});
  }
  check_end(set, problems);
  return systems;
}

void apply_systems(const std::vector<UniversalSystem>& systems, std::vector<UniversalNode>& nodes) {
  for (UniversalNode& node : nodes) {
    if (!node.in_part) {
      const auto definition = in_global(systems, node.definition_system);
      node.position_known = definition && definition->type == UniversalSystemType::cartesian;
      if (node.position_known) node.position = definition->origin + definition->axes * node.position;
    }
    const auto displacement = system_of(systems, node.displacement_system, node.in_part);
    const bool cartesian = displacement && displacement->type == UniversalSystemType::cartesian;
    const auto axes =
        displacement && (cartesian || node.position_known) ? axes_at(*displacement, node.position) : std::nullopt;
    node.axes_known = axes.has_value();
    if (axes) node.axes = *axes;
  }
}

}  // namespace trivet::exchange
