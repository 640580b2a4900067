// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exchange/universal/universal_writing.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "trivet/exchange/text/text_lines.h"
#include "trivet/exchange/universal/universal_functions.h"
#include "trivet/exchange/universal/universal_lines.h"
#include "trivet/foundation/invalid_input.h"

static_assert(std::endian::native == std::endian::little, "the numbers are copied to the file as they are");

namespace trivet::exchange {

namespace {

constexpr int label_width = 10, date_field_width = 10, color_of_all = 1;
constexpr std::size_t labels_per_line = 8, largest_line_nodes = 250;

/// "28-Jan-21 14:01:42" in two fields of ten characters; NONE for an empty one: some programs cannot read blank dates.
std::string date_fields(std::string_view date_and_time) {
  const auto parts = blank_separated(date_and_time);
  const auto part = [&](std::size_t i) -> std::string_view {
    if (parts.empty() && i == 0) return "NONE";
    return i < parts.size() ? parts[i].substr(0, date_field_width) : "";
  };
  return fmt::format("{:<{}}{:<{}}", part(0), date_field_width, part(1), date_field_width);
}

std::string header_set(const UniversalHeader& header) {
  return opening_lines(151) + text_line(header.model) + text_line(header.description) +
      text_line(header.database_program) + date_fields(header.created) + fmt::format("{:10d}{:10d}{:10d}\n", 0, 0, 0) +
      date_fields(header.saved) + "\n" + text_line(header.program) + date_fields(header.written) + "\n" +
      closing_line_of_set();
}

/// Unit factors of SI, and the offset between kelvin and degrees Celsius.
std::string si_units_set() {
  return opening_lines(164) + fmt::format("{:10d}{:<20}{:10d}\n", 1, "Meter (newton)", 2) +
      "  1.00000000000000000D+00  1.00000000000000000D+00  1.00000000000000000D+00\n"
      "  2.73150000000000000D+02\n" +
      closing_line_of_set();
}

std::string node_set(const std::vector<UniversalNode>& nodes) {
  std::string text = opening_lines(15);
  for (const UniversalNode& node : nodes) {
    text += whole_field(node.label, label_width, "node") +
        whole_field(node.definition_system, label_width, "coordinate system") +
        whole_field(node.displacement_system, label_width, "coordinate system") + fmt::format("{:10d}", color_of_all);
    for (int i = 0; i < 3; ++i) {
      require_finite(node.position[i], "a coordinate of a node");
      text += single_field(node.position[i]);
    }
    text += '\n';
  }
  return text + closing_line_of_set();
}

std::string line_set(const UniversalLine& line) {
  if (line.nodes.size() > largest_line_nodes)
    throw foundation::InvalidInput(fmt::format("line {} has {} nodes, at most {} are possible", line.number,
                                               line.nodes.size(), largest_line_nodes));
  std::string text = opening_lines(82) + whole_field(line.number, label_width, "line") +
      fmt::format("{:10d}{:10d}\n", line.nodes.size(), color_of_all) + text_line(line.name);
  for (std::size_t i = 0; i < line.nodes.size(); ++i) {
    text += whole_field(line.nodes[i], label_width, "node");
    if ((i + 1) % labels_per_line == 0 || i + 1 == line.nodes.size()) text += '\n';
  }
  return text + closing_line_of_set();
}

/// Analysis type and parameters of records 6, 7 and 8.
struct WrittenParameters {
  int analysis = 2;
  std::vector<double> numbers;
};

WrittenParameters written_parameters(const UniversalMode& mode) {
  if (const auto* normal = std::get_if<UniversalNormalMode>(&mode.parameters))
    return {2, {normal->frequency_hz, normal->modal_mass, normal->damping_ratio, normal->hysteretic_damping}};
  const auto& complex = std::get<UniversalComplexMode>(mode.parameters);
  return {complex.second_order ? 7 : 3,
          {complex.eigenvalue.real(), complex.eigenvalue.imag(), complex.modal_a.real(), complex.modal_a.imag(),
           complex.modal_b.real(), complex.modal_b.imag()}};
}

std::string node_motion(const UniversalNodeMotion& motion, const UniversalMode& mode) {
  std::vector<double> numbers;
  for (std::size_t i = 0; i < (mode.has_rotations ? 6 : 3); ++i) {
    numbers.push_back(motion.components[i].real());
    if (mode.is_complex) numbers.push_back(motion.components[i].imag());
  }
  for (const double number : numbers) require_finite(number, "a mode shape");
  return whole_field(motion.node, label_width, "node") + "\n" + single_lines(numbers);
}

std::string mode_set(const UniversalMode& mode) {
  if (mode.in_file_units) throw foundation::InvalidInput(fmt::format("mode {} is not in SI", mode.number));
  std::string text = opening_lines(55);
  for (const std::string& id : mode.ids) text += text_line(id);
  const WrittenParameters parameters = written_parameters(mode);
  for (const double number : parameters.numbers) require_finite(number, "a parameter of a mode");
  text += fmt::format("{:10d}{:10d}{:10d}{:10d}{:10d}{:10d}\n", 1, parameters.analysis, mode.has_rotations ? 3 : 2,
                      static_cast<int>(mode.quantity), mode.is_complex ? 5 : 2, mode.has_rotations ? 6 : 3);
  text += fmt::format("{:10d}{:10d}", 2, parameters.numbers.size()) +
      whole_field(mode.load_case, label_width, "load case") + whole_field(mode.number, label_width, "mode") + "\n";
  text += single_lines(parameters.numbers);
  for (const UniversalNodeMotion& motion : mode.nodes) text += node_motion(motion, mode);
  return text + closing_line_of_set();
}

}  // namespace

std::string universal_text(const UniversalFile& file, FunctionForm form) {
  std::string text = header_set(file.header) + si_units_set();
  if (!file.nodes.empty()) text += node_set(file.nodes);
  for (const UniversalLine& line : file.lines) text += line_set(line);
  for (const UniversalMode& mode : file.modes) text += mode_set(mode);
  for (const UniversalFunction& function : file.functions) {
    const bool binary = form == FunctionForm::binary;
    require_writable(function, binary);
    text += function_set(function, binary);
  }
  return text;
}

namespace {

/// Number of fields in a line of values.
constexpr std::size_t values_per_double_line = 4;

[[noreturn]] void reject(const UniversalFunction& function, const std::string& why) {
  throw foundation::InvalidInput(fmt::format("function \"{}\": {}", function.ids[0], why));
}

bool is_single(const UniversalFunction& function, bool binary) {
  return function.precision == UniversalPrecision::single_precision || (binary && !is_even(function));
}

int ordinate_type(const UniversalFunction& function, bool single) {
  if (function.is_complex) return single ? 5 : 6;
  return single ? 2 : 4;
}

std::string place_line(const UniversalFunction& function) {
  const auto point = [](const UniversalPoint& p) {
    return " " + text_field(p.entity, universal_entity_width) + whole_field(p.node, 10, "node") +
        whole_field(p.direction, 4, "direction");
  };
  return whole_field(static_cast<int>(function.type), 5, "function type") +
      whole_field(function.identifier, 10, "identifier") + whole_field(function.version, 5, "version") +
      whole_field(function.load_case, 10, "load case") + point(function.response) + point(function.reference) + "\n";
}

std::string form_line(const UniversalFunction& function, bool single) {
  const EvenAbscissa even = is_even(function) ? std::get<EvenAbscissa>(function.abscissa) : EvenAbscissa{0, 0};
  return fmt::format("{:10d}{:10d}{:10d}", ordinate_type(function, single), function.values.size(),
                     is_even(function) ? 1 : 0) +
      single_field(even.first) + single_field(even.step) + single_field(function.z_value) + "\n";
}

std::string axis_line(const UniversalAxis& axis) {
  return whole_field(static_cast<int>(axis.quantity), 10, "quantity") +
      whole_field(axis.exponents.length, 5, "power of length") +
      whole_field(axis.exponents.force, 5, "power of force") +
      whole_field(axis.exponents.temperature, 5, "power of temperature") + " " +
      text_field(axis.label, universal_label_width) + " " + text_field(axis.unit, universal_label_width) + "\n";
}

std::string head(const UniversalFunction& function, bool single) {
  std::string text;
  for (const std::string& id : function.ids) text += text_line(id);
  return text + place_line(function) + form_line(function, single) + axis_line(function.abscissa_axis) +
      axis_line(function.numerator) + axis_line(function.denominator) + axis_line(function.z_axis);
}

const std::vector<double>* uneven_abscissa(const UniversalFunction& function) {
  return std::get_if<std::vector<double>>(&function.abscissa);
}

std::string single_values(const UniversalFunction& function) {
  std::vector<double> numbers;
  const auto* abscissa = uneven_abscissa(function);
  for (std::size_t i = 0; i < function.values.size(); ++i) {
    if (abscissa) numbers.push_back((*abscissa)[i]);
    numbers.push_back(function.values[i].real());
    if (function.is_complex) numbers.push_back(function.values[i].imag());
  }
  return single_lines(numbers);
}

/// 4E20.12 or, with an uneven abscissa, 2(E13.5,E20.12) and E13.5,2E20.12.
std::string double_values(const UniversalFunction& function) {
  const auto* abscissa = uneven_abscissa(function);
  const std::size_t fields_per_point = numbers_per_point(function);
  const std::size_t points_per_line = values_per_double_line / fields_per_point;
  std::string text;
  for (std::size_t i = 0; i < function.values.size(); ++i) {
    if (abscissa) text += single_field((*abscissa)[i]);
    text += double_field(function.values[i].real());
    if (function.is_complex) text += double_field(function.values[i].imag());
    if ((i + 1) % points_per_line == 0 || i + 1 == function.values.size()) text += '\n';
  }
  return text;
}

template <typename Real>
void append(std::string& bytes, double number) {
  const Real value = static_cast<Real>(number);
  char copy[sizeof(Real)];
  std::memcpy(copy, &value, sizeof(Real));
  bytes.append(copy, sizeof(Real));
}

template <typename Real>
std::string binary_values(const UniversalFunction& function) {
  const auto* abscissa = uneven_abscissa(function);
  std::string bytes;
  bytes.reserve(function.values.size() * numbers_per_point(function) * sizeof(Real));
  for (std::size_t i = 0; i < function.values.size(); ++i) {
    if (abscissa) append<Real>(bytes, (*abscissa)[i]);
    append<Real>(bytes, function.values[i].real());
    if (function.is_complex) append<Real>(bytes, function.values[i].imag());
  }
  return bytes;
}

void require_range(const UniversalFunction& function, double number, bool single) {
  if (!std::isfinite(number)) reject(function, "a number is not finite");
  if (single && std::abs(number) > std::numeric_limits<float>::max())
    reject(function, fmt::format("{:.9g} is too large for single precision", number));
}

bool must_increase(const UniversalFunction& function) {
  const UniversalQuantity quantity = function.abscissa_axis.quantity;
  return quantity == UniversalQuantity::time || quantity == UniversalQuantity::frequency;
}

/// The abscissa that the file holds: six digits in text, a number in single precision in binary form.
double held_abscissa(double value, bool binary) {
  return binary ? static_cast<double>(static_cast<float>(value)) : as_universal_abscissa(value);
}

void require_abscissa(const UniversalFunction& function, bool single, bool binary) {
  if (const auto* even = std::get_if<EvenAbscissa>(&function.abscissa)) {
    if (!std::isfinite(even->first) || !std::isfinite(even->step) || (function.values.size() > 1 && !(even->step > 0)))
      reject(function, fmt::format("step {:.9g}, must be > 0", even->step));
    return;
  }
  const std::vector<double>& abscissa = *uneven_abscissa(function);
  if (abscissa.size() != function.values.size())
    reject(function, fmt::format("{} abscissas and {} values, must be equal", abscissa.size(), function.values.size()));
  for (std::size_t i = 0; i < abscissa.size(); ++i) {
    require_range(function, abscissa[i], single);
    if (i > 0 && must_increase(function) &&
        held_abscissa(abscissa[i], binary) <= held_abscissa(abscissa[i - 1], binary))
      reject(function,
             fmt::format("{:.9g} after {:.9g}: times and frequencies must increase, also with {} digits", abscissa[i],
                         abscissa[i - 1], binary ? "seven" : "six"));
  }
}

}  // namespace

void require_writable(const UniversalFunction& function, bool binary) {
  const bool single = is_single(function, binary);
  if (function.in_file_units) reject(function, "its values are not in SI");
  if (function.values.empty()) reject(function, "it has no values");
  require_range(function, function.z_value, single);
  for (const std::complex<double>& value : function.values) {
    require_range(function, value.real(), single);
    require_range(function, value.imag(), single);
    if (!function.is_complex && value.imag() != 0) reject(function, "it is real and has an imaginary part");
  }
  require_abscissa(function, single, binary);
}

std::string function_set(const UniversalFunction& function, bool binary) {
  const bool single = is_single(function, binary);
  if (!binary)
    return opening_lines(58) + head(function, single) + (single ? single_values(function) : double_values(function)) +
        closing_line_of_set();
  const std::string values = single ? binary_values<float>(function) : binary_values<double>(function);
  // Little-endian, IEEE 754, eleven lines before the values.
  return fmt::format("{:6d}\n{:6d}b{:6d}{:6d}{:12d}{:12d}{:6d}{:6d}{:12d}{:12d}\n", -1, 58, 1, 2, 11, values.size(), 0,
                     0, 0, 0) +
      head(function, single) + values + closing_line_of_set();
}

}  // namespace trivet::exchange
