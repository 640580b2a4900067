// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exchange/universal/universal_contents.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "trivet/exchange/universal/universal_descriptions.h"
#include "trivet/exchange/universal/universal_sets.h"
#include "trivet/exchange/universal/universal_units.h"

namespace trivet::exchange {
namespace {

constexpr std::array definition_widths{10, 10, 10, 10, 10, 10};
constexpr std::array parameter_count_widths{10, 10, 10, 10, 10, 10, 10, 10};
constexpr std::array mode_value_widths{13, 13, 13, 13, 13, 13};
constexpr int normal_mode = 2, complex_mode = 3, frequency_response = 5, second_order_complex_mode = 7;
constexpr int translations = 2, translations_and_rotations = 3;
constexpr int real_data = 2, complex_data = 5;
constexpr std::size_t largest_parameter_count = 12;
constexpr std::array double_value_widths{20, 20, 20, 20};
constexpr std::array analysis_widths{10, 10, 10, 10, 10, 10, 10, 10};
constexpr int at_nodes = 1, real_double_data = 4, complex_double_data = 6;
/// Records 1 to 8 of set 2414: label, name, location and five id lines.
constexpr std::size_t analysis_head_lines = 8;

/// Record 6.
struct ModeDefinition {
  int analysis = 0, characteristic = 0, quantity = 0, data_type = 0, values_per_node = 0;
};

/// The mode while it is read.
struct ModeReading {
  const UniversalSet& set;
  SetProblems& problems;
  Lines lines;
  FieldWidths value_widths = mode_value_widths;
  [[nodiscard]] int line() const { return set.line + lines.number(); }
};

std::optional<ModeDefinition> mode_definition(std::string_view line) {
  const auto numbers = whole_numbers_of_record(line, definition_widths, definition_widths.size());
  if (!numbers) return std::nullopt;
  const std::vector<int>& n = *numbers;
  const ModeDefinition definition{n[1], n[2], n[3], n[4], n[5]};
  const bool known_data = definition.data_type == real_data || definition.data_type == complex_data;
  return known_data && definition.values_per_node > 0 ? std::optional(definition) : std::nullopt;
}

/// Number of id lines before record 6: five, or fewer if the file lacks some.
std::optional<std::size_t> id_lines_before_definition(const std::vector<HeadLine>& head) {
  for (std::size_t ids = universal_id_lines + 1; ids-- > 0;)
    if (ids < head.size() && mode_definition(head[ids].text)) return ids;
  return std::nullopt;
}

/// Why the numbers of a set are not three or six motions of nodes, or why it is not a mode; or an empty text.
std::string other_than_shape(const ModeDefinition& definition) {
  const int characteristic = definition.characteristic;
  if (characteristic != translations && characteristic != translations_and_rotations)
    return fmt::format("data characteristic {}", characteristic);
  return definition.values_per_node == 3 || definition.values_per_node == 6
      ? ""
      : fmt::format("{} values per node", definition.values_per_node);
}

std::string other_than_mode(const ModeDefinition& definition) {
  const int analysis = definition.analysis;
  if (analysis != normal_mode && analysis != complex_mode && analysis != second_order_complex_mode)
    return fmt::format("analysis type {}", analysis);
  return other_than_shape(definition);
}

/// The next `count` values, from as many lines as they take; nullopt with an error.
std::optional<std::vector<double>> next_values(ModeReading& reading, std::size_t count, const std::string& what) {
  std::vector<double> values;
  while (values.size() < count && reading.lines.next()) {
    const auto line = values_of_line(reading.lines.line(), reading.line(), reading.value_widths, reading.problems);
    if (!line) return std::nullopt;
    values.insert(values.end(), line->begin(), line->end());
  }
  if (values.size() == count) return values;
  reading.problems.error(reading.line(), what, fmt::format("{} numbers", values.size()),
                         fmt::format("{} are announced", count),
                         reading.set.closed ? "correct the record" : "was the file cut off?");
  return std::nullopt;
}

/// Records 7 and 8: numbers of the load case and of the mode, and its parameters.
bool read_parameters(ModeReading& reading, const ModeDefinition& definition, UniversalMode& mode) {
  const auto numbers =
      reading.lines.next() ? whole_numbers_of_record(reading.lines.line(), parameter_count_widths, 2) : std::nullopt;
  const int count = numbers ? (*numbers)[1] : 0;
  if (count < 1 || count > static_cast<int>(largest_parameter_count)) {
    reading.problems.error(reading.line(), "record 7", in_quotes(reading.lines.line()),
                           "it has the numbers of parameters (1 to 12), the load case and the number of the mode",
                           "correct the line");
    return false;
  }
  mode.load_case = (*numbers)[2];
  mode.number = (*numbers)[3];
  auto values = next_values(reading, static_cast<std::size_t>(count), "record 8");
  if (!values) return false;
  values->resize(largest_parameter_count, 0.0);
  const std::vector<double>& v = *values;
  if (definition.analysis == normal_mode)
    mode.parameters = UniversalNormalMode{
        .frequency_hz = v[0], .modal_mass = v[1], .damping_ratio = v[2], .hysteretic_damping = v[3]};
  else
    mode.parameters = UniversalComplexMode{.eigenvalue = {v[0], v[1]},
                                           .modal_a = {v[2], v[3]},
                                           .modal_b = {v[4], v[5]},
                                           .second_order = definition.analysis == second_order_complex_mode};
  return true;
}

bool is_finite(const UniversalMode& mode) {
  for (const UniversalNodeMotion& node : mode.nodes)
    for (const std::complex<double> component : node.components)
      if (!std::isfinite(component.real()) || !std::isfinite(component.imag())) return false;
  return true;
}

/// Records 9 and 10 of one node; nullopt with an error.
std::optional<UniversalNodeMotion> next_node(ModeReading& reading, bool is_complex, std::size_t components) {
  const auto label = whole_number(trimmed(reading.lines.line()));
  if (!label || *label < 0) {
    reading.problems.error(reading.line(), "node", in_quotes(reading.lines.line()),
                           "the numbers of a node follow a line with its label",
                           "correct the line; has each node the announced number of values?");
    return std::nullopt;
  }
  UniversalNodeMotion motion{.node = *label};
  const auto values = next_values(reading, (is_complex ? 2 : 1) * components, fmt::format("node {}", *label));
  if (!values) return std::nullopt;
  for (std::size_t i = 0; i < components; ++i)
    motion.components[i] =
        is_complex ? std::complex((*values)[2 * i], (*values)[2 * i + 1]) : std::complex((*values)[i], 0.0);
  return motion;
}

/// Records of all nodes; false after an error.
bool read_nodes(ModeReading& reading, std::size_t components, UniversalMode& mode) {
  while (reading.lines.next()) {
    if (trimmed(reading.lines.line()).empty()) continue;
    auto node = next_node(reading, mode.is_complex, components);
    if (!node) return false;
    mode.nodes.push_back(*node);
  }
  return true;
}

void convert_mode(UniversalMode& mode, const UniversalUnits& units, const UniversalSet& set, SetProblems& problems) {
  if (is_si(units)) return;
  if (si_unit_label(mode.quantity, UniversalMotion::translation).empty() ||
      mode.quantity == UniversalQuantity::excitation_force || mode.quantity == UniversalQuantity::reaction_force) {
    mode.in_file_units = true;
    problems.warning(set.line, "unit", fmt::format("shape of quantity {}", static_cast<int>(mode.quantity)),
                     "shapes of displacement (8), velocity (11) and acceleration (12) are converted to SI",
                     "the numbers are as in the file");
    return;
  }
  const double length = unit_value(units, {.length = 1});
  // With this, φφᵀ/mass stays the receptance, in m/N.
  const double mass = unit_value(units, {.length = 1, .force = 1});
  for (UniversalNodeMotion& node : mode.nodes)
    for (std::size_t i = 0; i < 3; ++i) node.components[i] *= length;
  if (auto* normal = std::get_if<UniversalNormalMode>(&mode.parameters)) {
    normal->modal_mass *= mass;
  } else {
    auto& complex = std::get<UniversalComplexMode>(mode.parameters);
    complex.modal_a *= mass;
    complex.modal_b *= mass;
  }
  if (!is_finite(mode))
    problems.error(set.line, "unit", "infinite numbers in SI", "numbers are finite", "check the factors of set 164");
}

bool is_complex_data(int type) { return type == complex_data || type == complex_double_data; }
bool is_double_data(int type) { return type == real_double_data || type == complex_double_data; }

/// What set 2414 contains other than a mode or motions of a frequency response at nodes, or an empty text.
std::string other_than_analysis_mode(int location, const ModeDefinition& definition) {
  if (location != at_nodes)
    return fmt::format("results {}",
                       location == 2 || location == 3 ? "at elements" : fmt::format("at location {}", location));
  const auto quantity = static_cast<UniversalQuantity>(definition.quantity);
  const bool motion = quantity == UniversalQuantity::displacement || quantity == UniversalQuantity::velocity ||
      quantity == UniversalQuantity::acceleration;
  const std::string result = motion ? "motions" : fmt::format("results of type {}", definition.quantity);
  switch (definition.analysis) {
    case normal_mode:
    case complex_mode:
    case second_order_complex_mode:
      break;
    case 1:
      return result + " of a static analysis";
    case 4:
      return result + " over time";
    case frequency_response:
      if (!motion || !is_complex_data(definition.data_type))
        return fmt::format("{}{} of a frequency response", motion ? "real " : "", result);
      return other_than_shape(definition);
    default:
      return fmt::format("{} of analysis type {}", result, definition.analysis);
  }
  return motion ? other_than_mode(definition) : result + " of modes";
}

/// Record 9.
std::optional<ModeDefinition> analysis_definition(std::string_view line) {
  const auto numbers = whole_numbers_of_record(line, definition_widths, definition_widths.size());
  if (!numbers) return std::nullopt;
  const std::vector<int>& n = *numbers;
  return ModeDefinition{n[1], n[2], n[3], n[4], n[5]};
}

/// Records 10 to 13 of set 2414: numbers of the mode, and its parameters.
bool read_analysis_parameters(ModeReading& reading, const ModeDefinition& definition, UniversalMode& mode) {
  const auto numbers =
      reading.lines.next() ? whole_numbers_of_record(reading.lines.line(), analysis_widths, 6) : std::nullopt;
  if (!numbers) {
    reading.problems.error(reading.line(), "record 10", in_quotes(reading.lines.line()),
                           "it has eight whole numbers, the fifth the load, the sixth the mode", "correct the line");
    return false;
  }
  mode.load_case = (*numbers)[4];
  mode.number = (*numbers)[5];
  reading.lines.next();  // creation option
  const auto values = next_values(reading, largest_parameter_count, "records 12 and 13");
  if (!values) return false;
  const std::vector<double>& v = *values;
  if (definition.analysis == normal_mode || definition.analysis == frequency_response)
    mode.parameters = UniversalNormalMode{
        .frequency_hz = v[1], .modal_mass = v[3], .damping_ratio = v[4], .hysteretic_damping = v[5]};
  else
    mode.parameters = UniversalComplexMode{.eigenvalue = {v[6], v[7]},
                                           .modal_a = {v[8], v[9]},
                                           .modal_b = {v[10], v[11]},
                                           .second_order = definition.analysis == second_order_complex_mode};
  return true;
}

}  // namespace

UniversalModeSet read_universal_mode(const UniversalSet& set, const UniversalUnits& units, SetProblems& problems) {
  const auto head = head_lines(set, universal_id_lines + 1);
  const auto ids = id_lines_before_definition(head);
  if (!ids) {
    problems.error(set.line + static_cast<int>(universal_id_lines) + 1, "record 6",
                   head.size() > universal_id_lines ? in_quotes(head.back().text) : "missing",
                   "after five id lines it has six numbers, the fifth 2 (real) or 5 (complex)",
                   set.closed ? "correct the set" : "was the file cut off?");
    return {};
  }
  const ModeDefinition definition = *mode_definition(head[*ids].text);
  if (std::string other = other_than_mode(definition); !other.empty()) return {.other_content = std::move(other)};
  UniversalMode mode;
  mode.ids = read_ids(head, *ids, problems);
  mode.quantity = static_cast<UniversalQuantity>(definition.quantity);
  mode.has_rotations = definition.values_per_node == 6;
  mode.is_complex = definition.data_type == complex_data;
  ModeReading reading{.set = set, .problems = problems, .lines = Lines(set.body)};
  for (std::size_t i = 0; i <= *ids; ++i) reading.lines.next();
  if (!read_parameters(reading, definition, mode)) return {};
  if (!read_nodes(reading, static_cast<std::size_t>(definition.values_per_node), mode)) return {};
  convert_mode(mode, units, set, problems);
  check_end(set, problems);
  return {.mode = std::move(mode)};
}

UniversalModeSet read_universal_analysis_mode(const UniversalSet& set, const UniversalUnits& units,
                                              SetProblems& problems) {
  ModeReading reading{.set = set, .problems = problems, .lines = Lines(set.body)};
  UniversalMode mode;
  int location = 0;
  for (std::size_t i = 0; i < analysis_head_lines && reading.lines.next(); ++i) {
    if (i == 2) location = whole_number(trimmed(reading.lines.line())).value_or(0);
    if (i > 2) mode.ids[i - 3] = unless_none(readable_line(reading.lines.line()));
  }
  const auto definition = reading.lines.next() ? analysis_definition(reading.lines.line()) : std::nullopt;
  if (!definition) {
    problems.error(reading.line(), "record 9", in_quotes(reading.lines.line()),
                   "after five id lines it has six numbers", set.closed ? "correct the set" : "was the file cut off?");
    return {};
  }
  if (std::string other = other_than_analysis_mode(location, *definition); !other.empty())
    return {.other_content = std::move(other)};
  mode.quantity = static_cast<UniversalQuantity>(definition->quantity);
  mode.has_rotations = definition->values_per_node == 6;
  mode.is_complex = is_complex_data(definition->data_type);
  if (!read_analysis_parameters(reading, *definition, mode)) return {};
  if (is_double_data(definition->data_type)) reading.value_widths = double_value_widths;
  if (!read_nodes(reading, static_cast<std::size_t>(definition->values_per_node), mode)) return {};
  if (definition->analysis == frequency_response) {
    check_end(set, problems);
    return {.response = std::move(mode)};
  }
  convert_mode(mode, units, set, problems);
  check_end(set, problems);
  return {.mode = std::move(mode)};
}

int count_universal_elements(const UniversalSet& set) {
  constexpr std::array beams{11, 21, 22, 23, 24};
  constexpr int nodes_per_line = 8;
  int count = 0;
  for (Lines lines(set.body); lines.next();) {
    const auto head = whole_numbers_of_record(lines.line(), definition_widths, definition_widths.size());
    if (!head || (*head)[5] < 1) continue;
    ++count;
    if (std::ranges::find(beams, (*head)[1]) != beams.end()) lines.next();
    for (int read = 0; read < (*head)[5] && lines.next();) read += nodes_per_line;
  }
  return count;
}

}  // namespace trivet::exchange
